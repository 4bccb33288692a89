// SPDX-License-Identifier: BSD-3-Clause
// See until.h.
#include "report/until.h"
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <sstream>
#include "base/error.h"
#include "base/number.h"
#include "glare/columns.h"
#include "uncertainty/stopping.h"

namespace report {

using glare::dgp_class, glare::dgp_classes;
using uncertainty::Estimate;

namespace {

// "1%" or "0.1"; false: it is neither.
bool read_amount(std::string text, Tolerance& t) {
    const bool share = !text.empty() && text.back() == '%';
    if (share) text.pop_back();
    double value = 0;
    if (!base::parse_real(text, value) || value < 0) return false;
    (share ? t.share : t.amount) = share ? value / 100 : value;
    return true;
}

}  // namespace

double Tolerance::of(double value) const { return std::max(amount, share > 0 ? share * std::fabs(value) : 0); }

std::string Tolerance::text() const {
    const std::string of_share = fmt::format("{:.4g}%", 100 * share), of_amount = fmt::format("{:.4g}", amount);
    return share > 0 && amount > 0 ? of_share + " or " + of_amount : share > 0 ? of_share : of_amount;
}

std::vector<Tolerance> parse_tolerances(const std::string& rule, const std::string& place) {
    std::vector<Tolerance> out;
    std::istringstream parts(rule);
    for (std::string part; std::getline(parts, part, ',');) {
        std::istringstream words(part);
        Tolerance t;
        if (words >> t.metric && (t.metric == "class" || t.metric == "classf"))
            base::fail(place, t.metric + " takes no tolerance");
        std::string amounts[2];
        bool second = false;
        for (std::string word; words >> word;)
            if (word == "or" && !second) second = true;
            else amounts[second] += word;
        if (amounts[0].empty())
            base::fail(place, "\"" + part + "\" is not a rule; write for example 'DGP 1%, Ev 0.5% or 0.1'");
        const bool both = (amounts[0].back() == '%') != (second && !amounts[1].empty() && amounts[1].back() == '%');
        if (!read_amount(amounts[0], t) || (second && !(both && read_amount(amounts[1], t))))
            base::fail(place, "\"" + part + "\" has no tolerance such as 1%, 0.01 or '1% or 0.01'");
        out.push_back(t);
    }
    if (out.empty()) base::fail(place, "the rule is empty; write for example 'DGP 1%, Ev 0.5% or 0.1'");
    return out;
}

UntilRule::UntilRule(const std::string& rule) {
    std::string others;
    std::istringstream parts(rule);
    for (std::string part; std::getline(parts, part, ',');) {
        std::istringstream words(part);
        std::string word, more;
        if (words >> word && (word == "class" || word == "classf") && !(words >> more))
            class_of_ = word == "class" ? "DGP" : "DGPf";
        else others += (others.empty() ? "" : ",") + part;
    }
    if (!others.empty() || class_of_.empty()) tolerances_ = parse_tolerances(others, "-until");
}

namespace {

const std::optional<Estimate> none;
const std::optional<Estimate>& pixels_of(const PixelErrors& pixels, size_t tolerance) {
    return tolerance < pixels.of_tolerances.size() ? pixels.of_tolerances[tolerance] : none;
}

Estimate less_pixels(Estimate e, const Estimate& pixels) {
    e.value += pixels.value;
    return e;
}

std::string low_or_high(const Estimate& pixels) {
    return fmt::format("{:.2g} {}", std::fabs(pixels.value), pixels.value > 0 ? "low" : "high");
}

// The error of the variance inside of pixels does not fall with frames.  From here on it is what it will be.
constexpr int64_t least_to_give_up = 1024;
constexpr double clearly = 1.5;                // times what is allowed, before
constexpr int64_t any_number = INT64_MAX / 2;  // of frames

// The part of an error that no number of frames removes is more than the tolerance allows.
bool lasts(const Estimate& e, double allowed) {
    const double half_width = e.half_width(uncertainty::alpha, any_number);
    return half_width > (e.frames >= least_to_give_up ? 1 : clearly) * allowed;
}

// A square picture's side at which an error in proportion to the width of pixels is nine tenths of what is allowed.
int side_for(int side, double error, double allowed) {
    constexpr double multiple = 64, share = .9;
    return int(multiple * std::ceil(side * error / (share * allowed) / multiple));
}

}  // namespace

bool UntilRule::holds(const std::vector<Estimate>& estimates, const Estimate& dgp, const PixelErrors& pixels) const {
    for (size_t k = 0; k < tolerances_.size(); ++k) {
        const std::optional<Estimate>& of_pixels = pixels_of(pixels, k);
        const double left = tolerances_[k].of(estimates[k].value) - (of_pixels ? std::fabs(of_pixels->value) : 0);
        if (!uncertainty::narrow_enough(estimates[k], left)) return false;
    }
    if (class_of_.empty()) return true;
    if (!uncertainty::class_is_known(dgp, dgp_class)) return false;
    if (!pixels.of_class) return true;
    const Estimate without = less_pixels(dgp, *pixels.of_class);
    return uncertainty::class_is_known(without, dgp_class) && dgp_class(without.value) == dgp_class(dgp.value);
}

std::string UntilRule::reason(const std::vector<Estimate>& estimates, const Estimate& dgp,
                              const PixelErrors& pixels) const {
    std::string out;
    for (size_t k = 0; k < tolerances_.size(); ++k) {
        const Estimate& e = estimates[k];
        out += fmt::format("{}{} {:.4g} +- {:.2g}", out.empty() ? "" : ", ", tolerances_[k].metric, e.value,
                           e.half_width(uncertainty::alpha, e.frames));
        if (const auto& p = pixels_of(pixels, k))
            out += fmt::format(" of noise; at this size evalglare's definition reads {}", low_or_high(*p));
    }
    if (!class_of_.empty())
        out += fmt::format("{}glare is {}", out.empty() ? "" : ", ", dgp_classes[dgp_class(dgp.value)]);
    return out;
}

std::string UntilRule::out_of_reach(const std::vector<Estimate>& estimates, const Estimate& dgp,
                                    const PixelErrors& pixels, int width, int height) const {
    for (size_t k = 0; k < tolerances_.size(); ++k) {
        const Estimate& e = estimates[k];
        if (const double most = tolerances_[k].of(e.value); lasts(e, most))
            return fmt::format(
                "at {} x {} pixels {} is known to +- {:.2g} however many frames there are, more than the {:.2g} of the "
                "rule; larger pictures have less",
                width, height, tolerances_[k].metric, e.half_width(uncertainty::alpha, any_number), most);
        const std::optional<Estimate>& p = pixels_of(pixels, k);
        if (!p) continue;
        const uncertainty::Interval off = p->around(uncertainty::alpha, p->frames);
        const double most = tolerances_[k].of(e.value), error = std::fabs(p->value);
        const bool outside = p->value + off.low > most || p->value + off.high < -most;
        if (!outside && !(p->frames >= least_to_give_up && error > most)) continue;
        return fmt::format(
            "at {} x {} pixels {} reads {}, more than the {:.2g} of the rule; about {} x {} may do, and "
            "{}f does not depend on the size",
            width, height, tolerances_[k].metric, low_or_high(*p), most, side_for(width, error, most),
            side_for(height, error, most), tolerances_[k].metric);
    }
    if (class_of_.empty()) return "";
    Estimate at_last = dgp;
    at_last.error = dgp.error_after(any_number);
    if (dgp.lasting > 0 && dgp.frames >= least_to_give_up && !uncertainty::class_is_known(at_last, dgp_class))
        return fmt::format(
            "at {} x {} pixels {} is {:.4g} +- {:.2g} however many frames there are, which is no class; larger "
            "pictures have less",
            width, height, class_of_, dgp.value, dgp.half_width(uncertainty::alpha, any_number));
    if (!pixels.of_class) return "";
    const Estimate without = less_pixels(dgp, *pixels.of_class);
    if (!uncertainty::class_is_known(dgp, dgp_class) || !uncertainty::class_is_known(without, dgp_class)) return "";
    if (dgp_class(without.value) == dgp_class(dgp.value)) return "";
    return fmt::format(
        "at {} x {} pixels DGP reads {}: glare is {} by it, and {} by DGPf (classf), which does not "
        "depend on the size",
        width, height, low_or_high(*pixels.of_class), dgp_classes[dgp_class(dgp.value)],
        dgp_classes[dgp_class(without.value)]);
}

}  // namespace report
