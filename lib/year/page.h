// SPDX-License-Identifier: BSD-3-Clause
// A year of glare as one HTML file for people, on a screen and on paper (vcyear -report): the parts of EN 17037,
// verdicts, shades, a plan with the directions of the views, pictures of hours, days by hours, and what all of it rests
// on.  It needs no other file, and runs and loads nothing; names from files are escaped.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image/picture.h"
#include "view/view.h"
#include "weather/weather.h"
#include "year/body_clock.h"
#include "year/page_parts.h"
#include "year/shade_control.h"
#include "year/verdict.h"

namespace year {

struct Page {
    std::string title;  // empty: none
    std::vector<View> views;
    std::vector<Verdict> verdicts;  // of them
    std::vector<BodyClock> clocks;  // of those whose melanopic light is known
    PageParts parts;
    std::optional<ShadeYear> shades;
    double certainty = .95;
    std::string command;                   // shows an hour once it has -hours NAME (text.h)
    std::vector<view::NamedView> eyes;     // of the views, where they are known
    std::optional<image::Picture> plan;    // from above: a parallel view
    std::vector<image::Picture> pictures;  // of hours, by VIEWNAME= and SKYNAME=
    std::optional<weather::Weather> weather;
    std::vector<std::string> files;  // that were read
    std::string version;
};

std::string page_text(const Page& page);

// Of a view and an hour, by which a cell of the heat map finds its picture or its command.
std::string place_of(size_t view, const weather::Time& time);
// The picture of an hour; null: there is none.
const image::Picture* picture_of(const Page& page, const std::string& view, const weather::Time& time);
// The plan with an arrow for each view in the colour of its class, and the pictures of hours in one scale.
std::string plan_figure(const Page& page);
std::string hour_figures(const Page& page);
// Groups and rules of shades; empty where none move.
std::string shades_section(const Page& page);

}  // namespace year
