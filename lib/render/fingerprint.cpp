// SPDX-License-Identifier: BSD-3-Clause
// See fingerprint.h.
#include "render/fingerprint.h"

#include <fmt/format.h>

#include "base/options.h"

namespace render {
namespace {

std::string scene_hash(base::Hash hash, const flatten::FlatScene& s) {
    hash.add_all(std::vector<float>{float(s.centre.x), float(s.centre.y), float(s.centre.z)});
    hash.add({s.shadow_mode, s.antimatter, s.absorbs});
    return hash.text();
}

// Options that move pixels, as typed, and those that tests set.  The seed has a header line of its own.
std::string option_text(RenderOptions o) {
    if (o.sampling != Sampling::reuse) o.noisy_share = 0;  // the others have none
    base::OptionTable table;
    declare_options(table, o);
    std::string text;
    for (const base::Option& option : table.options())
        if (option.pixels) text += option.in_force() + " ";
    return text + fmt::format("direct {}{}", o.direct_samples, o.more_if_small ? "" : " and no more");
}

std::string focus_text(const Focus& focus) {
    std::string text;
    for (const FocusPart& part : focus) text += fmt::format(" {} samples of {}", part.spp, base::hash_of(part.pixels));
    return text;
}

}  // namespace

#define HASH_TABLE(type, name) hash.add_all(s.name);
base::Hash hash_of_geometry(const flatten::FlatScene& s) {
    base::Hash hash;
    hash.add_all(s.built.inputs);
    FLAT_TABLES(HASH_TABLE)
    return hash;
}

std::string fingerprint(base::Hash geometry, const flatten::FlatScene& scene, const std::string& view, int nx, int ny,
                        const RenderOptions& options, const Focus& focus) {
    return fmt::format("scene:{} view:{} options:{} estimator:{}", scene_hash(geometry, scene),
                       base::hash_of(fmt::format("{} {} {}", view, nx, ny)),
                       base::hash_of(option_text(options) + focus_text(focus)), estimator);
}

}  // namespace render
