// SPDX-License-Identifier: BSD-3-Clause
// The scene as regions see it, by the tracer's own geometry: rays go straight through glass and the like and end at the
// first surface of another material.  Distant sources are seen where nothing else is.
#include "visibility/visibility.h"
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include "base/angle.h"
#include "base/error.h"
#include "region/sensors.h"
#include "scene/materials.h"
#include "flatten/flatten.h"
#include "flatten/host_tracer.h"

namespace visibility {

namespace {
using base::Vec3;
using scene::Type;
// Regions ask where surfaces are, not what they reflect.
flatten::Options any_reflectance() {
    flatten::Options o;
    o.any_reflectance = true;
    return o;
}

class TracedScene : public region::SceneView {
public:
    TracedScene(const std::vector<std::string>& files, const base::ReadOptions& options)
        : scene_(scene::read_scene(files, options)),
          flat_(flatten::flatten(scene_, any_reflectance(), options)),
          tracer_(flat_) {
        for (size_t i = 0; i < scene_.objects.size(); ++i)
            if (scene::is_surface(scene_.objects[i].type)) surfaces_.push_back(unsigned(i));
        std::unordered_map<unsigned, unsigned> index;
        for (unsigned s = 0; s < surfaces_.size(); ++s) {
            const scene::Object& o = object(s);
            index[surfaces_[s]] = s;
            const scene::Scene::Resolved material = scene_.material(o.modifier);
            through_.push_back(material.object != scene::VOID &&
                               scene::is_clear(scene_.objects[size_t(material.object)].type));
            if (o.type == Type::source) {
                const auto r = scene_.reals(o);
                distant_.push_back({s, base::unit({r[0], r[1], r[2]}), r[3] / 2 * base::degree});
            }
        }
        std::stable_sort(distant_.begin(), distant_.end(),
                         [](const auto& a, const auto& b) { return a.half_rad > b.half_rad; });
        const auto surface = [&](unsigned object) { return index.count(object) ? index[object] : none; };
        for (unsigned object : flat_.prim_object) prim_surface_.push_back(surface(object));
        for (unsigned object : flat_.instance_object) instance_surface_.push_back(surface(object));
    }
    unsigned surfaces() const override { return unsigned(surfaces_.size()); }
    std::string surface_name(unsigned s) const override { return scene_.name(object(s)); }
    std::vector<std::string> modifier_names(unsigned s) const override {
        std::vector<std::string> names;
        for (int32_t m = object(s).modifier; m != scene::VOID;) {
            const scene::Object& o = scene_.objects[size_t(m)];
            names.push_back(scene_.name(o));
            if (o.type == Type::alias && o.alias_of != scene::VOID)
                names.push_back(scene_.name(scene_.objects[size_t(o.alias_of)]));
            m = o.modifier;
            if (names.size() > 1000) break;
        }
        return names;
    }
    std::vector<Vec3> face(unsigned s) const override {
        const scene::Object& o = object(s);
        const auto r = scene_.reals(o);
        if (o.type == Type::ring) return region::ring_corners({r[0], r[1], r[2]}, {r[3], r[4], r[5]}, r[6], r[7]);
        std::vector<Vec3> corners;
        if (o.type == Type::polygon)
            for (size_t i = 0; i + 2 < r.size(); i += 3) corners.push_back({r[i], r[i + 1], r[i + 2]});
        return corners;
    }
    int look(Vec3 origin, Vec3 dir, double tmax, region::Crossing* out, int room, bool& closed) const override {
        const double end = tmax > 0 ? tmax : 1e30;
        double from = 0;
        int n = 0;
        closed = false;
        for (int passed = 0; passed < 1000; ++passed) {
            const auto hit = tracer_.closest(origin, dir, from, end, flatten::HostTracer::all);
            if (hit.prim == none) break;
            const bool within =
                hit.inst != none;  // a mesh or instance counts as one surface, its panes let the eye pass
            const unsigned s = within ? instance_surface_[hit.inst] : prim_surface_[hit.prim];
            closed = s == none || (within ? !flatten::see_through(flat_, hit.prim, hit.inst) : !through_[s]);
            if (s != none) {
                if (n == room) --n;  // the nearest ones and the last
                out[n++] = {hit.t, s};
            }
            if (closed) return n;
            from = hit.t * (1 + 1e-6) + 1e-7;
        }
        if (tmax > 0) return n;
        for (const region::DistantSource& s : distant_)
            if (std::atan2(base::length(base::cross(s.dir, dir)), base::dot(s.dir, dir)) <= s.half_rad && n < room)
                out[n++] = {1e30, s.surface};
        return n;
    }
    std::vector<region::DistantSource> distant() const override { return distant_; }

private:
    const scene::Object& object(unsigned s) const { return scene_.objects[surfaces_[s]]; }
    static constexpr unsigned none = 0xffffffffu;
    scene::Scene scene_;
    flatten::FlatScene flat_;
    flatten::HostTracer tracer_;
    std::vector<unsigned> surfaces_;          // objects
    std::vector<char> through_;               // by surface
    std::vector<unsigned> prim_surface_;      // by primitive
    std::vector<unsigned> instance_surface_;  // by instance record
    std::vector<region::DistantSource> distant_;
};

}  // namespace

std::unique_ptr<region::SceneView> open_scene(const std::vector<std::string>& files, const base::ReadOptions& options) {
    if (files.empty()) return nullptr;
    return std::make_unique<TracedScene>(files, options);
}

}  // namespace visibility
