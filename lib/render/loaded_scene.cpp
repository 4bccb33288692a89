// SPDX-License-Identifier: BSD-3-Clause
// See loaded_scene.h.
#include "render/loaded_scene.h"

#include <algorithm>

#include "flatten/band_colours.h"
#include "render/fingerprint.h"
#include "sampling/targets.h"

namespace render {
namespace {

std::string made_of(const RenderOptions& options, const scene::ReadOptions& files) {
    base::Hash hash;
    hash.add_all(options.room_text);
    hash.add({options.bv, options.any_reflectance, options.compact_tree, options.names});
    for (const std::string& file : files.cal_files) hash.add_all(file);
    if (options.bands) hash.add_all(options.bands->name);
    return hash.text();
}

LoadedRoom load_room(const scene::Scene& scene, const RenderOptions& options, const scene::ReadOptions& files) {
    LoadedRoom room;
    scene::ReadOptions own = files;
    own.read = std::make_shared<base::FilesRead>();
    try {
        room.surfaces = flatten::flatten_room(scene, options, own);
    } catch (...) {
        base::note_files(*files.read, *own.read);
        throw;
    }
    room.files = *own.read;
    room.windows = sampling::find_windows(room.surfaces.tables);
    room.smooth = sampling::smooth_surfaces(room.surfaces.tables);
    room.made_of = made_of(options, files);
    return room;
}

bool is_same(const LoadedRoom& room, const RenderOptions& options, const scene::ReadOptions& files) {
    const flatten::FlatScene& flat = room.surfaces.tables;
    return made_of(options, files) == room.made_of && !options.room_text.empty() &&
           flatten::centre_of(flat.boxes, options.eye ? &*options.eye : nullptr) == flat.centre &&
           base::are_unchanged(room.files, files.overlays);
}

}  // namespace

LoadedScene load_scene(const scene::Scene& scene, const RenderOptions& options, const scene::ReadOptions& files,
                       const std::shared_ptr<const LoadedRoom>& known) {
    LoadedScene out;
    flatten::FlatScene flat;
    const auto light = [&](const LoadedRoom& room, flatten::Room surfaces) {
        out.mirrors_sources = !surfaces.relays.empty();
        flat = flatten::add_distant(std::move(surfaces), scene, options, files);
        if (options.sampling != Sampling::plain) sampling::find_targets(flat, room.windows, *files.work);
        out.smooth = room.smooth;
    };
    if (known && is_same(*known, options, files)) {
        light(*known, known->surfaces);
        if (options.keep_room) out.room = known;
        base::note_files(*files.read, known->files);
    } else {
        LoadedRoom room = load_room(scene, options, files);
        if (options.keep_room) out.room = std::make_shared<const LoadedRoom>(room);
        base::note_files(*files.read, room.files);
        light(room, std::move(room.surfaces));
    }
    const auto of_sky = [&](uint32_t object) { return object >= options.sky_from; };
    flat.hours_sky_at = uint32_t(std::find_if(flat.distant_object.begin(), flat.distant_object.end(), of_sky) -
                                 flat.distant_object.begin());
    out.geometry = hash_of_geometry(flat);
    flat.keep_tables_only();
    out.tables = std::make_shared<const flatten::FlatScene>(std::move(flat));
    return out;
}

}  // namespace render
