// SPDX-License-Identifier: BSD-3-Clause
// The table of all columns: a metric is one row here (columns.h says how to add one).
#include "glare/columns.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include "base/error.h"
#include "glare/actions.h"
#include "glare/refuse_column.h"

namespace glare {
namespace {

using M = const Measurement&;
using G = const Glare&;
constexpr Noise no_interval = Noise::no_interval, linear = Noise::linear;
constexpr Requirements nothing = 0, uncompared = 1u << 31;  // -tolerance leaves it out unless it is named
using require::sources, require::rammg, require::medians, require::mask, require::all_light, require::filled,
    require::regions_in_full, require::reach;

enum WithFilled { filled_too };

// A formula of G has a meaning for filled pixels as well: with filled_too there are columns NAMEf; NAME.px, the
// difference from NAMEu; and NAMEf.px; nan where a picture has no moments.  Others, of M, read what only whole pixels
// have, and do not compile with it.
struct Entry {
    const char* name;
    Requirements required;
    double (*value)(M);
    Noise noise;
    double (*of_glare)(G);
    DefaultTolerance tolerance;
    bool has_filled = false;
    Entry(const char* its_name, Requirements needs, double (*of)(M), Noise its_noise, DefaultTolerance its = {})
        : name(its_name), required(needs), value(of), noise(its_noise), of_glare(nullptr), tolerance(its) {}
    Entry(const char* its_name, Requirements needs, double (*of)(G), Noise its_noise, DefaultTolerance its = {})
        : name(its_name), required(needs), value(nullptr), noise(its_noise), of_glare(of), tolerance(its) {}
    Entry(const char* its_name, WithFilled, double (*of)(G), Noise its_noise, DefaultTolerance its = {})
        : Entry(its_name, sources, of, its_noise, its) {
        has_filled = true;
    }
    double operator()(M m) const { return of_glare ? of_glare(m) : value(m); }
};

double omega_sources(G m) {
    return std::accumulate(m.sources.begin(), m.sources.end(), 0.0, [](double sum, auto& s) { return sum + s.omega; });
}
double lum_sources(G m) {
    const double flux = std::accumulate(m.sources.begin(), m.sources.end(), 0.0,
                                        [](double sum, auto& s) { return sum + s.lum * s.omega; });
    return m.sources.empty() ? 0 : flux / omega_sources(m);
}

double class_value(G m) { return dgp_class(m.dgp); }

// Tolerances of what is not one sum are the spread between builds of evalglare itself.
constexpr DefaultTolerance exactly{0, 0};
const Entry entries[] = {
    {"Ev", all_light, [](M m) { return m.placed_ev; }, linear},
    {"DGP", filled_too, [](G m) { return m.dgp; }, Noise::dgp, {2e-5, 0}},
    {"class", filled_too, class_value, no_interval},
    {"DGI", filled_too, [](G m) { return dgi(m.glare, m.background); }, Noise::glare},
    {"UGR", filled_too, [](G m) { return ugr(m.glare, m.background); }, Noise::glare},
    {"VCP", filled_too, [](G m) { return vcp(m.glare, dgr(m.glare, m.mean_lum)); }, Noise::bias_alone, {0, .02}},
    {"CGI", filled_too, [](G m) { return cgi(m.glare, m.direct_lux, m.ev); }, Noise::glare},
    {"UGP", filled_too, [](G m) { return ugp(m.glare, m.background); }, Noise::glare},
    {"UGP2", sources, [](G m) { return ugp2(m.glare, m.background); }, Noise::glare},
    {"DGImod", sources, [](G m) { return dgi_mod(m.glare, m.background, m.ev); }, Noise::glare},
    {"UGRexp", sources, [](G m) { return ugr_exp(m.glare, m.background0, m.ev); }, Noise::glare},
    {"DGR", sources, [](G m) { return dgr(m.glare, m.mean_lum); }, Noise::bias_alone, {0, .02}},
    {"PGSV", sources | mask | uncompared, [](M m) { return m.pgsv.value; }, no_interval},
    {"PGSVcon", sources | mask | uncompared, [](M m) { return m.pgsv.contrast; }, no_interval},
    {"PGSVsat", sources | mask | uncompared, [](M m) { return m.pgsv.saturation; }, no_interval},
    {"Lveil", sources, [](G m) { return veil_poynter(m.glare); }, Noise::glare, {0, .05}},
    {"LveilCIE", sources, [](G m) { return veil_cie(m.glare, m.settings.veil_cut); }, Noise::glare, {0, .05}},
    {"Lavg", nothing, [](M m) { return m.mean_lum; }, linear},
    {"Lmax", nothing, [](M m) { return m.max_lum; }, no_interval},
    {"Lmed", medians, [](M m) { return m.median; }, no_interval},
    {"LavgPos", medians | uncompared, [](M m) { return m.mean_pos; }, linear},
    {"LavgPos2", medians | uncompared, [](M m) { return m.mean_pos2; }, linear},
    {"LmedPos", medians | uncompared, [](M m) { return m.median_pos; }, no_interval},
    {"LmedPos2", medians | uncompared, [](M m) { return m.median_pos2; }, no_interval},
    {"Lb", sources, [](G m) { return m.background; }, Noise::glare},
    {"Lt", sources | uncompared, [](G m) { return m.task_lum; }, linear},
    {"threshold", sources | uncompared, [](G m) { return m.threshold; }, no_interval},
    {"Edir", sources, [](M m) { return m.placed_direct_lux; }, Noise::glare},
    {"n_sources", filled_too, [](G m) { return double(m.sources.size()); }, no_interval, exactly},
    {"omega_sources", sources, omega_sources, no_interval},
    {"L_sources", sources | uncompared, lum_sources, no_interval},
    {"RAMMG", rammg, [](M m) { return m.rammg; }, Noise::contrast},
    {"omega", uncompared, [](M m) { return m.omega; }, no_interval},
    {"pixels", uncompared, [](M m) { return double(m.valid_pixels); }, no_interval},
    {"not_finite", uncompared, [](M m) { return double(m.not_finite); }, no_interval, exactly},
    {"negative", uncompared, [](M m) { return double(m.negative); }, no_interval, exactly},
};

template <class Values>
struct PartEntry {
    const char* name;
    double Values::*value;
    Noise noise;
};
const PartEntry<RegionValues> parts[] = {
    {"TAL", &RegionValues::tal, Noise::region},     {"mean", &RegionValues::mean, Noise::region},
    {"median", &RegionValues::median, no_interval}, {"min", &RegionValues::lowest, no_interval},
    {"max", &RegionValues::highest, no_interval},   {"share", &RegionValues::share, no_interval}};

const PartEntry<PixelStatistics> set_parts[] = {
    {"omega", &PixelStatistics::omega, no_interval},   {"mean", &PixelStatistics::mean, linear},
    {"median", &PixelStatistics::median, no_interval}, {"std", &PixelStatistics::deviation, no_interval},
    {"p75", &PixelStatistics::p75, no_interval},       {"p95", &PixelStatistics::p95, no_interval},
    {"min", &PixelStatistics::lowest, no_interval},    {"max", &PixelStatistics::highest, no_interval},
    {"Ev", &PixelStatistics::eye_lux, linear}};

class ColumnSelector {
public:
    ColumnSelector(const ColumnChoice& choice, const Settings& settings, Requirements& requirements)
        : choice_(choice), settings_(settings), requirements_(requirements) {
        requirements_ = 0;
    }
    std::vector<Column> all() {
        if (choice_.accelerad) return accelerad(), std::move(columns_);
        std::vector<std::string> names = choice_.names;
        if (names.empty()) {
            names = {"Ev", "DGP"};
            if (!choice_.regions.empty()) names.push_back("TAL");
            if (!choice_.pairs.empty()) names.push_back("CR");
            names.push_back("RAMMG");
            if (settings_.mask_file) names.insert(names.end(), {"mask", "PGSV"});
            if (settings_.zones) names.push_back("zone1");
            if (settings_.zones && settings_.zones->outer_opening) names.push_back("zone2");
            if (settings_.band_rad) names.push_back("band");
        }
        for (const std::string& name : names)
            if (!plain(name) && !contrast(name) && !region(name) && !pixel_set(name)) refuse(name);
        for (const std::string& name : choice_.hidden)
            if (plain(name)) columns_.back().printed = false;
        return std::move(columns_);
    }

private:
    // AvLum Ev DGP RAMMG TaskLum HighLum LowLum CR, of the task's region and the first contrast pair.
    void accelerad() {
        for (const char* name : {"Lavg", "Ev", "DGP", "RAMMG"}) plain(name);
        columns_[0].name = "AvLum";
        const ContrastPair pair = choice_.pairs.empty() ? ContrastPair{} : choice_.pairs[0];
        std::string task = settings_.task_region;
        for (const std::string& name : choice_.regions)  // or the first region outside the pair
            if (task.empty() && name != pair.low && name != pair.high) task = name;
        mean_of("TaskLum", task);
        mean_of("HighLum", pair.high);
        mean_of("LowLum", pair.low);
        const auto high = columns_[5].value, low = columns_[6].value;
        columns_.push_back({"CR", [high, low](M m) { return high(m) / low(m); }, no_interval});
    }
    // Mean luminance of a region in a column of a given name; nan without such a region.
    void mean_of(const char* column, const std::string& name) {
        const size_t k = region_index(name);
        if (k == choice_.regions.size()) columns_.push_back({column, [](M) { return std::nan(""); }, no_interval});
        else columns_.push_back({column, [k](M m) { return m.region_values[k].tal; }, no_interval});
    }

    // NAME or, where noise biases NAME, NAMEu; NAMEf, NAME.px and NAMEf.px.
    bool plain(const std::string& name) {
        for (const Entry& e : entries) {
            const bool shows_unbiased = has_bias(e.noise) && name == std::string(e.name) + "u",
                       shows_filled = e.has_filled && name == std::string(e.name) + "f",
                       shows_pixels = name == pixels_column(e.name),
                       shows_reach = e.has_filled && has_interval(e.noise) && name == std::string(e.name) + "f.px";
            if (name != e.name && !shows_unbiased && !shows_filled && !shows_pixels && !shows_reach) continue;
            if (e.required & mask && !settings_.mask_file) base::fail("-metrics", name + " needs a mask (-A file)");
            if ((shows_filled || shows_pixels || shows_reach) && (settings_.field_cut || settings_.fill))
                base::fail("-metrics", name + " needs the whole picture as it is and cannot be used with -G or -I");
            requirements_ |= e.required & ~(mask | uncompared);
            if (e.required & sources) requirements_ |= all_light;
            if (settings_.external_ev) requirements_ &= ~all_light;

            Column column{name, e, e.noise};
            if (e.of_glare == class_value) column.words = dgp_classes;
            column.printed_unbiased = shows_unbiased;
            if (shows_filled || shows_pixels) {
                requirements_ |= filled;
                column.printed_unbiased = has_bias(e.noise);
                column.of_filled = true;
                column.value = [value = e.of_glare, shows_pixels](M m) {
                    return m.filled ? value(*m.filled) - (shows_pixels ? value(m) : 0) : std::nan("");
                };
            }
            if (shows_reach) {
                requirements_ |= filled | reach;
                column.noise = no_interval;
                column.value = [value = e.of_glare](M m) { return off_by_reach(m, value); };
            }
            columns_.push_back(std::move(column));
            return true;
        }
        return false;
    }
    bool contrast(const std::string& name) {
        bool found = false;
        for (const ContrastPair& p : choice_.pairs) {
            const bool plain = name == "CR" || name == p.column + ".CR";
            if (!plain && name != "CRu" && name != p.column + ".CRu") continue;
            const size_t low = region_index(p.low), high = region_index(p.high);
            Column column{p.column + (plain ? ".CR" : ".CRu"),
                          [low, high](M m) { return m.region_values[low].tal / m.region_values[high].tal; },
                          Noise::region_ratio};
            column.printed_unbiased = !plain;
            columns_.push_back(std::move(column));
            found = true;
        }
        if (found || (name != "CR" && name != "CRu")) return found;
        if (!choice_.pairs_come) base::fail("-metrics", name + " needs a contrast pair (-cr low/high)");
        return true;
    }
    bool region(const std::string& name) {
        bool found = false;
        for (const auto& part : parts)
            for (size_t k = 0; k < choice_.regions.size(); ++k) {
                const std::string full = choice_.regions[k] + "." + part.name;
                if (name != part.name && name != full) continue;
                if (part.value != &RegionValues::tal) requirements_ |= regions_in_full;
                columns_.push_back(
                    {full, [k, value = part.value](M m) { return m.region_values[k].*value; }, part.noise});
                found = true;
            }
        const bool of_all = std::any_of(std::begin(parts), std::end(parts), [&](auto& p) { return name == p.name; });
        if (of_all && !found && !choice_.regions_come)
            base::fail("-metrics", name + " needs regions (-regions file.exr)");
        return found || of_all;
    }
    bool pixel_set(const std::string& name) {
        bool found = false;
        const auto offer = [&](const char* set, bool there, std::optional<PixelStatistics> Measurement::*member) {
            for (const auto& part : set_parts) {
                const std::string full = std::string(set) + "." + part.name;
                if (name != set && name != full) continue;
                if (!there) base::fail("-metrics", name + " needs -B, -A, -l or -L");
                columns_.push_back(
                    {full, [member, value = part.value](M m) { return (*(m.*member)).*value; }, part.noise});
                requirements_ |= sources;
                found = true;
            }
        };
        offer("band", settings_.band_rad.has_value(), &Measurement::band);
        offer("mask", settings_.mask_file.has_value(), &Measurement::mask);
        offer("zone1", settings_.zones.has_value(), &Measurement::zone1);
        offer("zone2", settings_.zones && settings_.zones->outer_opening, &Measurement::zone2);
        return found;
    }
    [[noreturn]] void refuse(const std::string& name) {
        std::vector<std::string> of_regions, names;
        for (const auto& part : parts) of_regions.push_back(part.name);
        for (const Entry& e : entries)
            for (const char* const end : {"", has_bias(e.noise) ? "u" : "", e.has_filled ? "f" : ""})
                names.push_back(e.name + std::string(end));
        refuse_column(name, choice_.regions, of_regions, names);
    }
    size_t region_index(const std::string& name) const {
        return size_t(std::find(choice_.regions.begin(), choice_.regions.end(), name) - choice_.regions.begin());
    }

    const ColumnChoice& choice_;
    const Settings& settings_;
    Requirements& requirements_;
    std::vector<Column> columns_;
};

}  // namespace

std::vector<Column> choose_columns(const ColumnChoice& choice, const Settings& settings, Requirements& requirements) {
    return ColumnSelector(choice, settings, requirements).all();
}

std::string pixels_column(const std::string& metric) {
    for (const Entry& e : entries)
        if (metric == e.name && e.has_filled && has_interval(e.noise)) return metric + ".px";
    return "";
}

DefaultTolerance tolerance_of(const std::string& metric) {
    const auto row = std::find_if(std::begin(entries), std::end(entries), [&](auto& e) { return metric == e.name; });
    return row == std::end(entries) ? DefaultTolerance{} : row->tolerance;
}

std::vector<std::string> compared_columns() {
    std::vector<std::string> out;
    for (const Entry& e : entries)
        if (!(e.required & uncompared) && e.of_glare != class_value) out.push_back(e.name);
    return out;
}

std::string column_names() {
    std::string out;
    for (const Entry& e : entries) out += std::string(e.name) + " ";
    return out + "CR TAL mean median min max share (of regions) band mask zone1 zone2 " + action_column_names() +
           " (of actions)";
}

}  // namespace glare
