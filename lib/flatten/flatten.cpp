// SPDX-License-Identifier: BSD-3-Clause
// The steps from a scene to its tables.  Each step reads only results of the steps before it.
#include "flatten/flatten.h"

#include "flatten/coincident.h"
#include "flatten/instances.h"
#include "flatten/light_tree.h"
#include "flatten/modifiers.h"
#include "flatten/sources.h"
#include "flatten/surfaces.h"
#include "flatten/trees.h"

namespace flatten {

FlatScene flatten(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files) {
    FlatScene out;

    // Modifiers first, because all other records refer to them: the scene's, then the ones inside its octrees and
    // meshes.
    ModifierTables tables;
    Instances instances(scene, options, files, tables);
    const Modifiers modifiers = flatten_modifiers(scene, instances.mesh_materials(scene), options, files, tables);
    Lights lights;
    instances.place(modifiers, lights);
    write_modifiers(std::move(tables), out);

    // Surfaces: tree 0 is the scene with the places of its instances, the others are what these hold.
    flatten_geometry(modifiers, instances, options.eye ? &*options.eye : nullptr, out, lights);
    out.built = build_trees(out, options);
    warn_of_coincident(modifiers, out);

    // Sources: emissive surfaces, distant ones, and their images in mirrors and prisms; the sources that mists scatter;
    // the light tree.
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
