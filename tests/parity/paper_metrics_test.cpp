// SPDX-License-Identifier: BSD-3-Clause
// Ev, TAL, CR and RAMMG (paper Eqs. 1, 3 to 6) against an independent program in numpy:
// tests/golden/glare/paper_metrics.tsv. Left out: cyl_360 (sees behind the eye: our cosines are 0 there), and readings
// that numpy's small reader does not know.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include "glare/region_pixels.h"
#include "glare/measure.h"
#include "image/stream.h"

namespace {

using Line = std::map<std::string, std::string>;

std::vector<Line> read_table(const std::string& path) {
    std::ifstream in(path);
    REQUIRE(in);
    std::string text;
    std::getline(in, text);
    std::vector<std::string> names;
    std::istringstream head(text);
    for (std::string n; head >> n;) names.push_back(n);
    std::vector<Line> out;
    while (std::getline(in, text)) {
        std::istringstream cells(text);
        Line line;
        for (const std::string& n : names) cells >> line[n];
        out.push_back(line);
    }
    return out;
}

double at(const Line& l, const char* name) { return std::strtod(l.at(name).c_str(), nullptr); }

// 1 inside the circle (opening angle in radians), y from the bottom.
std::vector<float> circle(const glare::Geometry& g, int x, int y, double opening) {
    std::vector<float> mask(g.omega.size(), 0);
    const auto centre = g.direction(x, y);
    for (size_t i = 0; i < mask.size(); ++i)
        if (g.valid(i) && 2 * std::acos(std::clamp(dot(centre, g.direction(i)), -1.0, 1.0)) <= opening) mask[i] = 1;
    return mask;
}

void check_near(double ours, double theirs, const std::string& what) {
    INFO(what << ": " << ours << " against " << theirs);
    CHECK((std::isnan(ours) ? std::isnan(theirs) : std::fabs(ours - theirs) <= 1e-6 * std::fabs(theirs) + 1e-9));
}

}  // namespace

TEST_CASE("the paper's metrics agree with an independent program to 1e-6") {
    const std::string folder = std::string(LUXPIPE_TESTS) + "/golden/glare/";
    const std::set<std::string> left_out = {"cyl_360.hdr", "xyze.hdr", "yup.hdr", "xmajor.hdr"};
    int compared = 0;
    for (const Line& line : read_table(folder + "paper_metrics.tsv")) {
        const std::string name = line.at("image");
        if (left_out.count(name)) continue;
        image::Picture picture = image::read_file(folder + "images/" + name);
        REQUIRE(picture.header.view);
        const glare::Geometry g(*picture.header.view, picture.width, picture.height);
        glare::Luminance lum = glare::make_luminance(picture);
        double ev = 0;
        for (size_t i = 0; i < lum.size(); ++i) ev += lum.at(i) * g.omega_cos[i];
        check_near(ev, at(line, "Ev"), name + " Ev");
        check_near(double(g.valid_count), at(line, "pixels"), name + " pixels");
        check_near(g.omega_sum, at(line, "omega"), name + " omega");
        const auto tal = [&](const char* x, const char* y, double opening) {
            return glare::RegionPixels(circle(g, int(at(line, x)), int(at(line, y)), opening), g).tal(lum);
        };
        const double high = tal("high_x", "high_y", at(line, "region_angle")),
                     low = tal("low_x", "low_y", at(line, "region_angle"));
        check_near(tal("task_x", "task_y", at(line, "task_angle")), at(line, "tal"), name + " TAL");
        check_near(high, at(line, "tal_high"), name + " TAL high");
        check_near(low / high, at(line, "cr_paper"), name + " CR");
        using glare::RammgArea;
        const auto rammg = [&](RammgArea area) { return glare::rammg(lum, glare::Pyramid(g, area)); };
        check_near(rammg(RammgArea::view), at(line, "rammg_fov"), name + " RAMMG");
        check_near(rammg(RammgArea::rectangle), at(line, "rammg"), name + " RAMMG rect");
        check_near(rammg(RammgArea::interior), at(line, "rammg_int"), name + " RAMMG interior");
        check_near(rammg(RammgArea::prototype_scale), at(line, "rammg_x8"), name + " RAMMG prototype");
        ++compared;
    }
    CHECK(compared > 60);
}
