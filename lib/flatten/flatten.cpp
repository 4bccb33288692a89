// SPDX-License-Identifier: BSD-3-Clause
// The steps from a scene to its tables.  Each step reads only results of the steps before it.
#include "flatten/flatten.h"

#include "flatten/coincident.h"
#include "flatten/instances.h"
#include "flatten/light_tree.h"
#include "flatten/room.h"
#include "flatten/trees.h"

namespace flatten {

Room flatten_room(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files) {
    Room room;
    room.objects = surfaces_end(scene);
    Draft draft;
    draft.names = options.names;

    // Modifiers first, because all other records refer to them: the scene's, then the ones inside its octrees and
    // meshes.
    ModifierTables tables;
    Instances instances(scene, options, files, tables);
    Modifiers modifiers(scene);
    flatten_modifiers(modifiers, {0, room.objects}, instances.mesh_materials(scene), options, files, tables);
    Lights lights;
    instances.place(modifiers, lights);
    room.arena_files = tables.code.tables;
    write_modifiers(std::move(tables), draft);

    // Surfaces: tree 0 is the scene with the places of its instances, the others are what these hold.
    flatten_geometry(modifiers, instances, options.eye ? &*options.eye : nullptr, *files.work, draft, lights);
    FlatScene& out = room.tables = std::move(draft).finished();
    out.built = build_trees(out, options, *files.work);
    warn_of_coincident(modifiers, out);

    Sources sources;
    add_local_sources(modifiers, lights.emitters, out, sources);
    weigh_patterns(out, sources, 0);
    write_sources(std::move(sources), out);
    mark_covered_sources(out);
    room.modifiers = std::move(modifiers);
    room.relays = std::move(lights.relays);
    return room;
}

FlatScene add_distant(Room room, const scene::Scene& scene, const Options& options, const scene::ReadOptions& files) {
    FlatScene out = std::move(room.tables);
    Modifiers modifiers(scene, std::move(room.modifiers));
    ModifierTables tables = take_modifiers(out, std::move(room.arena_files));
    flatten_modifiers(modifiers, {room.objects, scene.objects.size()}, {}, options, files, tables);
    write_modifiers(std::move(tables), out);

    // Distant sources, and the images of all in mirrors and prisms; the sources that mists scatter; the light tree.
    Sources sources = take_sources(out);
    const size_t local = sources.count();
    add_distant_sources(modifiers, out, sources);
    weigh_patterns(out, sources, local);
    add_virtual_sources(room.relays, options.dr, out, sources);
    link_mists(modifiers, room.relays, sources, out);
    write_sources(std::move(sources), out);
    plant_light_tree(out);
    return out;
}

FlatScene flatten(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files) {
    return add_distant(flatten_room(scene, options, files), scene, options, files);
}

}  // namespace flatten
