// SPDX-License-Identifier: BSD-3-Clause
// A measured picture as one HTML file for people, on a screen and on two sheets of A4 (vcmetrics -report).  The text
// needs no other file, and runs and loads nothing; names from files are escaped.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>
#include "image/picture.h"
#include "report/criterion.h"

namespace report {

constexpr double speck = .005;  // of DGP's sum: smaller sources share one row and have no number

struct Page {
    struct Number {
        std::string name;         // a column of vcmetrics
        double value, low, high;  // low, high: nan without an interval
    };
    struct Source {
        size_t number;  // of vcmetrics -sources
        double share, lum_cdm2, omega_sr, position_index, eye_lux;
        base::Vec3 direction;
        std::string what;  // seen there; empty: not known
    };
    struct Outline {
        std::string name;                                      // empty: none is written
        std::vector<std::vector<std::array<float, 2>>> rings;  // closed lines, in pixels from the upper left corner
        float x = 0, y = 0;                                    // of the name
        bool is_source = false;
    };
    struct Drawing {
        std::string caption, png;  // png: the file's bytes
    };
    // Another picture beside this one, and lines about it.
    struct Variant {
        std::string name, png;
        std::vector<std::string> lines;
    };
    // The scale of the falsecolor picture: places from 0 (bottom) to 1.
    struct Legend {
        std::vector<std::string> colours;  // evenly spaced
        std::vector<std::pair<double, std::string>> ticks;
    };
    struct File {
        std::string name, sha256;
    };

    std::string title;
    std::vector<std::pair<std::string, std::string>> about;  // project, author, room, place ...: in the user's words
    std::vector<Criterion> criteria;
    std::vector<Number> numbers;
    std::vector<std::string> notes;  // sentences below the verdict
    bool is_black = false;           // no light reaches the eye, so that glare has no class
    double certainty = .95;          // of the intervals
    std::vector<Drawing> drawings;
    std::vector<Outline> outlines;  // over each of them
    Legend legend;
    std::vector<Source> sources;
    struct Plan {
        std::string svg;  // maps of points; empty: there is none
        std::vector<Number> numbers;
    } plan;
    std::vector<Variant> variants;
    std::vector<std::string> day;  // a line an hour
    bool knows_objects = false;    // what is seen at the sources has a column
    std::vector<std::string> sky;
    view::View view;
    int width = 0, height = 0;  // of the picture that was measured
    image::Header header;
    std::vector<File> files;
    std::vector<std::string> commands;  // the pipe that makes it again
    std::string version;
};

std::string page_text(const Page& page);

}  // namespace report
