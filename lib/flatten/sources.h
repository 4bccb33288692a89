// SPDX-License-Identifier: BSD-3-Clause
// Active sources (spec shading 4.1) on their way into the tables: every step adds records or changes them, the last one
// writes all.
#pragma once
#include <cstdint>
#include <vector>
#include "flatten/modifiers.h"
#include "flatten/pack.h"
#include "flatten/surfaces.h"

namespace flatten {

struct Sources {
    std::vector<kernels::Source> records;
    std::vector<uint32_t> objects;  // of the real ones, which stand first: objects of the scene
    std::vector<kernels::FanTriangle> fans;
    std::vector<kernels::Distant> distant;
    std::vector<uint32_t> distant_objects;

    uint32_t count() const { return uint32_t(records.size()); }
};

// A record that states its material and nothing else.
kernels::Source& add_source(const Modifiers& modifiers, const scene::Object& surface, Sources& sources);
// Where and how large it is, for each kind of surface (source_shapes.cpp); throws for those that cannot shine.
void shape_source(const scene::Scene& scene, const scene::Object& surface, base::Vec3 centre,
                  std::vector<kernels::FanTriangle>& fans, kernels::Source& record);

// The surfaces of the scene that shine and are active sources; the rest is found by sampled rays alone.
void add_local_sources(const Modifiers& modifiers, const std::vector<Lights::Emitter>& emitters, FlatScene& out,
                       Sources& sources);
// All distant surfaces in order, the active sources among them.
void add_distant_sources(const Modifiers& modifiers, FlatScene& out, Sources& sources);
// Sources from this one on that have patterns are chosen by the power that their mean luminance gives.
void weigh_patterns(const FlatScene& out, Sources& sources, size_t first);
// Copies of the sources mirrored in the relays, up to `levels` of them (virtual_sources.cpp).
void add_virtual_sources(const std::vector<Lights::Relay>& relays, int levels, FlatScene& out, Sources& sources);
// The sources that mists name, to scatter (mists.cpp).
void link_mists(const Modifiers& modifiers, const std::vector<Lights::Relay>& relays, const Sources& sources,
                FlatScene& out);
void write_sources(Sources sources, FlatScene& out);
Sources take_sources(FlatScene& out);  // back again, for more

}  // namespace flatten
