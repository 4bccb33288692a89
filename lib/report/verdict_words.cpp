// SPDX-License-Identifier: BSD-3-Clause
// See verdict_words.h.  Classes: EN 17037, annex E.
#include "report/verdict_words.h"

#include <fmt/format.h>

#include <cmath>

#include "glare/formulas.h"

namespace report {

namespace {

constexpr int limits_of_100[] = {35, 40, 45};

std::string people_words(double dgp, int low, int high) {
    using glare::dgp_classes;
    const std::string share = dgp < .2   ? "fewer than 20"
                              : dgp > .8 ? "more than 80"
                                         : fmt::format("about {:.0f}", std::round(100 * dgp));
    std::string called;
    if (low != high)
        called = fmt::format("glare {} below {} of 100 and {} from there on, which is not decided yet",
                             dgp_classes[low], limits_of_100[low], dgp_classes[high]);
    else if (low == 0) called = fmt::format("a share below {} of 100 {} glare", limits_of_100[0], dgp_classes[0]);
    else if (low == 3) called = fmt::format("a share from {} of 100 on {} glare", limits_of_100[2], dgp_classes[3]);
    else
        called = fmt::format("a share from {} to {} of 100 {} glare", limits_of_100[low - 1], limits_of_100[low],
                             dgp_classes[low]);
    return fmt::format(
        "DGP is a share of people: {} of 100 would be disturbed by glare in this view. The standard (EN 17037) calls "
        "{}.",
        share, called);
}

}  // namespace

VerdictWords verdict_words(double dgp, double low, double high) {
    const bool known = std::isfinite(low) && std::isfinite(high);
    const int from = glare::dgp_class(known ? low : dgp), to = glare::dgp_class(known ? high : dgp);
    if (to - from > 1) return {};
    const std::string worst = glare::dgp_classes[to];
    return {to, from == to ? worst : glare::dgp_classes[from] + (" to " + worst), people_words(dgp, from, to)};
}

}  // namespace report
