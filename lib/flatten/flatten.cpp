// SPDX-License-Identifier: BSD-3-Clause
// The order in which a scene becomes tables.  Each step reads what those before it have written, and nothing else.
#include "flatten/flatten.h"

#include "flatten/coincident.h"
#include "flatten/instances.h"
#include "flatten/light_tree.h"
#include "flatten/modifiers.h"
#include "flatten/sources.h"
#include "flatten/surfaces.h"

namespace flatten {
using namespace kernels;

FlatScene flatten(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files) {
    FlatScene out;
    out.tell_tree = options.tell_tree;
    out.known_tree = options.known_tree;

    // Modifiers first, for all else names them by their records: those of the scene, then those inside the octrees and
    // meshes that it places.
    ModifierTables tables;
    Instances instances(scene, options, files, tables);
    const Modifiers modifiers = flatten_modifiers(scene, instances.mesh_materials(scene), options, files, tables);
    Lights lights;
    instances.place(modifiers, lights);
    write_modifiers(std::move(tables), out);

    // Surfaces: tree 0 is the scene with the places of its instances, the others are what these hold.
    flatten_geometry(modifiers, instances, out, lights);
    warn_of_coincident(modifiers, out);

    // Sources: surfaces that shine, distant ones, and all of them again in mirrors and prisms; which of them mists
    // scatter; how they are chosen among if they are many.
    Sources sources;
    add_local_sources(modifiers, lights.emitters, out, sources);
    add_distant_sources(modifiers, out, sources);
    weigh_patterns(out, sources);
    add_virtual_sources(lights.relays, options.dr, out, sources);
    link_mists(modifiers, lights.relays, sources, out);
    write_sources(std::move(sources), out);
    plant_light_tree(out);
    mark_covered_sources(out);
    return out;
}

}  // namespace flatten
