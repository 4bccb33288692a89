// SPDX-License-Identifier: BSD-3-Clause
// Glare sources, the report and the map of points, by the program that measures the stream: it runs on the picture
// beside the pipe with the same options, when the page asks, so that its numbers are the program's own.
#pragma once
#include <string>
#include <vector>
#include "live/asked.h"
#include "live/live.h"

namespace live {

struct PlanOptions {
    std::string sum;                   // file of ptaccum (-batches, .exr)
    std::vector<std::string> points;   // its point files and folders of them
    std::vector<std::string> measure;  // vcmetrics with these
};

// From the program after "--": its options that concern sources, and -sources.
std::vector<std::string> sources_command(const std::vector<std::string>& command);
// Its options but for those of a stream; the files of the scene.
std::vector<std::string> report_command(const std::vector<std::string>& command, const std::vector<std::string>& scene);

// vcmetrics with the intervals of that program, of the points in these files.
std::vector<std::string> plan_command(const std::vector<std::string>& command, const std::vector<std::string>& points);

// text: the sources as JSON.
Asked::Found find_sources(const Live& live, const std::vector<std::string>& command);
// text: the HTML of vcmetrics -report, with the numbers of the line that vcmetrics has printed of this picture.
Asked::Found find_report(Live& live, std::vector<std::string> command, const PlanOptions& plan);
// text: numbers of the grids and the map, as JSON.
Asked::Found find_plan(Live& live, const PlanOptions& plan);

}  // namespace live
