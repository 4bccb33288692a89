// SPDX-License-Identifier: BSD-3-Clause
// See measured.h.
#include "measured.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdio>

#include "base/error.h"
#include "base/printable.h"
#include "base/run.h"
#include "evalglare/source_finder.h"
#include "region/open.h"
#include "report/until.h"

using namespace glare;

namespace {

// What pixels do to the metrics of a rule is measured, too.
std::vector<std::string> pixel_columns(const report::UntilRule& rule) {
    std::vector<std::string> out;
    for (const report::Tolerance& t : rule.tolerances()) out.push_back(pixels_column(t.metric));
    out.push_back(pixels_column(rule.class_of()));
    out.erase(std::remove(out.begin(), out.end(), ""), out.end());
    return out;
}

void tell(const base::Error& e) { base::say("vcmetrics: " + base::printable(e.text)); }

// Those of a view and size that regions cannot be drawn for are out of sight: told, and without a pixel.
// gone: names that the file does not have any more.
image::DrawRegions lenient(const image::MaskSet& masks, const image::DrawRegions& draw, const std::string& file,
                           const std::vector<std::string>& gone) {
    return [=](const view::View& view, int width, int height) {
        image::MaskSet out = masks;
        try {
            if (draw) out = draw(view, width, height);
            if (out.width != width || out.height != height)
                base::fail(file, fmt::format("the picture has {} x {} pixels, the masks {} x {}", width, height,
                                             out.width, out.height));
        } catch (const base::Error& e) {
            tell(e);
            for (image::Mask& m : out.masks) m.coverage.clear();
        }
        for (const std::string& name : gone) out.masks.push_back({name, {}});
        out.width = width, out.height = height;
        return out;
    };
}

// A file that is being written changes again at once.
bool is_quiet(const timespec& changed) {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    const double age_s = double(now.tv_sec - changed.tv_sec) + 1e-9 * double(now.tv_nsec - changed.tv_nsec);
    return age_s < 0 || age_s > .025;
}

}  // namespace

Measured::Measured(const Options& o) : options_(o), named_(o.metrics) {
    image::DrawRegions draw;
    std::optional<image::MaskSet> regions;
    version_ = version_of_file();
    if (!o.regions_file.empty()) regions = region::open(o.regions_file, draw, region::Check::empty_and_small, true);
    if (regions && regions->masks.empty()) base::warn(o.regions_file, "holds no region");
    if (regions)
        for (const image::Mask& m : regions->masks) regions_.push_back(m.name);
    if (!o.until.empty()) {
        const report::UntilRule rule(o.until);
        for (const report::Tolerance& t : rule.tolerances()) named_.push_back(t.metric);
    }
    for (const std::string& text : o.contrast_pairs) {
        pairs_.push_back(parse_pair(text));
        named_.insert(named_.end(), {pairs_.back().low + ".", pairs_.back().high + "."});
    }
    if (o.regions_file.empty() || (regions && !regions->masks.empty() && !draw)) require_pairs();  // none come later
    Requirements requirements = 0;
    columns_ = choose(regions_, requirements);
    if (o.mode == OutputMode::evalglare)
        requirements = require::sources | (o.evalglare.detailed || o.settings.mask_file ? require::medians : 0);
    if (o.list_sources || !o.check_file.empty() || !o.over_file.empty()) requirements |= require::sources;
    if (o.evalglare_bug_compatible) requirements &= ~require::filled;
    analyzer_ =
        std::make_unique<PictureAnalyzer>(o.settings, requirements, std::move(regions), std::move(draw),
                                          o.evalglare_bug_compatible ? evalglare::methods(o.evalglare) : own_methods());
}

std::vector<Column> Measured::choose(const std::vector<std::string>& regions, Requirements& requirements) const {
    ColumnChoice choice;
    choice.names = options_.metrics;
    choice.accelerad = options_.mode == OutputMode::accelerad;
    choice.regions = regions;
    choice.regions_come = !options_.regions_file.empty();
    if (!options_.until.empty()) choice.hidden = pixel_columns(report::UntilRule(options_.until));
    for (const ContrastPair& pair : pairs_) {
        const auto there = [&](const std::string& r) {
            return std::find(regions.begin(), regions.end(), r) != regions.end();
        };
        if (there(pair.low) && there(pair.high)) choice.pairs.push_back(pair);
    }
    choice.pairs_come = !pairs_.empty();
    return choose_columns(choice, options_.settings, requirements);
}

void Measured::require_pairs() const {
    for (const ContrastPair& pair : pairs_) require_regions(pair, regions_);
}

bool Measured::names(const std::string& region) const {
    return std::any_of(named_.begin(), named_.end(),
                       [&](const std::string& n) { return n.compare(0, region.size() + 1, region + ".") == 0; });
}

Measured::Version Measured::version_of_file() const {
    struct stat info = {};
    if (options_.regions_file.empty() || stat(options_.regions_file.c_str(), &info) != 0) return {};
    return {S_ISREG(info.st_mode), (long long)info.st_ino, (long long)info.st_size, info.st_mtim};
}

bool Measured::Version::operator==(const Version& v) const {
    return inode == v.inode && bytes == v.bytes && changed.tv_sec == v.changed.tv_sec &&
           changed.tv_nsec == v.changed.tv_nsec;
}

bool Measured::read_regions_again(const std::function<void(const std::vector<Column>&)>& accept) {
    if (!live_) return false;
    const Version now = version_of_file();
    if (!now.regular || (lenient_ && (now == version_ || !is_quiet(now.changed)))) return false;
    version_ = now, lenient_ = true;
    try {
        image::DrawRegions draw;
        const image::MaskSet masks = region::open(options_.regions_file, draw, region::Check::none, true);
        std::vector<std::string> present, gone;
        for (const image::Mask& m : masks.masks) present.push_back(m.name);
        for (const std::string& r : regions_)
            if (names(r) && std::find(present.begin(), present.end(), r) == present.end()) gone.push_back(r);
        const auto lacks = [](const std::vector<std::string>& all, const std::string& r) {
            return std::find(all.begin(), all.end(), r) == all.end();
        };
        for (const ContrastPair& pair : pairs_)  // whose regions may not have come yet
            for (const std::string& r : {pair.low, pair.high})
                if (lacks(present, r) && lacks(gone, r)) gone.push_back(r);
        image::MaskSet all = masks;
        for (const std::string& r : gone) present.push_back(r), all.masks.push_back({r, {}});
        Requirements requirements = 0;
        std::vector<Column> columns = choose(present, requirements);
        accept(columns);
        analyzer_->set_regions(all, lenient(masks, draw, options_.regions_file, gone), requirements);
        columns_ = std::move(columns), regions_ = std::move(present);
    } catch (const base::Error& e) {
        tell(e);
        return false;
    }
    ++reading_;
    return true;
}

std::vector<std::string> Measured::keys() const {
    std::vector<std::string> out;
    const bool all = !options_.settings.task_region.empty();
    for (const Column& c : columns_) {
        const bool of_region = c.name.find('.') != std::string::npos && !c.of_filled;
        out.push_back(of_region || all ? fmt::format("{} {}", c.name, reading_) : c.name);
    }
    return out;
}
