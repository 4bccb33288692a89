// SPDX-License-Identifier: BSD-3-Clause
// A cache of octrees and meshes.
#include "scene/assets.h"
#include "base/error.h"
#include "base/printable.h"

namespace scene {

const Scene& Assets::load(const std::string& path, const std::string& place, int depth) {
    if (depth > limits_.depth)
        base::fail(place, "octrees are nested more than " + std::to_string(limits_.depth) + " deep");
    const auto [found, fresh] = octrees_.emplace(path, nullptr);
    if (!fresh) {
        if (!found->second) base::fail(place, "octree \"" + base::excerpt(path) + "\" holds an instance of itself");
        return *found->second;
    }
    ReadOptions how = options_;
    how.asked_by = place;
    how.skies = Skies::any;  // sources inside do not shine
    auto scene = std::make_unique<Scene>(read_scene({path}, how, limits_));
    for (const Object& o : scene->objects)
        if (o.type == Type::instance)
            load(find_file(scene->strings(o)[0], options_, scene->place(o)), scene->place(o), depth + 1);
    octrees_[path] = std::move(scene);
    return *octrees_[path];
}

const Scene& Assets::octree(const Scene& scene, const Object& o) {
    const std::string place = scene.place(o);
    return load(find_file(scene.strings(o)[0], options_, place), place, 1);
}

const Mesh& Assets::mesh(const Scene& scene, const Object& o) {
    const std::string path = find_file(scene.strings(o)[0], options_, scene.place(o));
    std::unique_ptr<Mesh>& mesh = meshes_[path];
    if (!mesh) mesh = std::make_unique<Mesh>(read_mesh(path, limits_, options_.opener(scene.place(o))));
    return *mesh;
}

Xform Assets::transform(const Scene& scene, const Object& o) {
    Xform x;
    const auto words = scene.strings(o);
    const int used = parse_xform(words, 1, x, scene.place(o));
    if (size_t(used) + 1 < words.size())
        base::fail(scene.place(o), "\"" + base::excerpt(words[size_t(used) + 1]) + "\" is not a transform option");
    return x;
}

}  // namespace scene
