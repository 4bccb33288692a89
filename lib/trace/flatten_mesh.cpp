// SPDX-License-Identifier: BSD-3-Clause
// A triangle mesh as one tree: one primitive a triangle, corner data shared by the triangles around a vertex.
// About 85 bytes a triangle in the tables, beside the hierarchy's own.
#include "base/error.h"
#include "trace/instances.h"

namespace trace {

using namespace kernels;
using base::Vec3;

void Instances::flatten_mesh(const Tree& tree) {
    const scene::Mesh& mesh = *tree.mesh;
    FlatScene& out = out_;
    const bool smooth = !mesh.normals.empty(), mapped = !mesh.uvs.empty(), corners = smooth || mapped;
    const size_t n = mesh.positions.size(), triangles = mesh.triangles.size();
    if (out.f.size() + CORNER_FLOATS * n > 0xffffffffu || out.u.size() + 3 * triangles > 0xffffffffu ||
        out.prims.size() / PRIM_WORDS + triangles > ID_PRIM)
        base::fail(mesh.path, "too many triangles");
    const uint32_t corner_at = uint32_t(out.f.size());
    out.vertices.reserve(out.vertices.size() + 3 * n);
    for (size_t i = 0; i < n; i++) {
        const Vec3 p = mesh.positions[i] - tree.centre;
        out.vertices.insert(out.vertices.end(), {float(p.x), float(p.y), float(p.z)});
    }
    if (corners) {
        out.f.reserve(out.f.size() + CORNER_FLOATS * n);
        for (size_t i = 0; i < n; i++) {
            const scene::Mesh::Normal a = smooth ? mesh.normals[i] : scene::Mesh::Normal{0, 0, 0};
            const scene::Mesh::Uv t = mapped ? mesh.uvs[i] : scene::Mesh::Uv{0, 0};
            out.f.insert(out.f.end(), {a.x, a.y, a.z, t.u, t.v});
        }
        out.u.reserve(out.u.size() + 3 * triangles);
    }
    out.prims.reserve(out.prims.size() + PRIM_WORDS * triangles);
    out.prim_object.reserve(out.prim_object.size() + triangles);
    out.triangles.reserve(out.triangles.size() + 3 * triangles);
    out.tri_prim.reserve(out.tri_prim.size() + triangles);
    const auto has_normal = [&](uint32_t v) {
        return mesh.normals[v].x != 0 || mesh.normals[v].y != 0 || mesh.normals[v].z != 0;
    };
    for (const scene::Mesh::Triangle& t : mesh.triangles) {
        uint32_t mod = NONE;
        bool pass = false;
        if (tree.names) {
            int32_t m = t.material;
            if (m >= 0 && !tree.materials.empty()) m = tree.materials[size_t(m)];
            if (m < 0 || !tree.names->has_material[m]) continue;
            mod = tree.names->mod_of[m];
            pass = tree.names->passes[m];
        }
        const Vec3 a = mesh.positions[t.v[0]], e = mesh.positions[t.v[1]] - a, f = mesh.positions[t.v[2]] - a;
        const Vec3 cr = cross(e, f);
        const double area2 = length(cr);
        if (!(area2 > 0)) continue;
        const Vec3 normal = cr * (1 / area2);
        uint32_t kind = PRIM_FLAT;
        if (corners) kind = PRIM_SMOOTH;
        if (smooth && has_normal(t.v[0]) && has_normal(t.v[1]) && has_normal(t.v[2])) kind |= PRIM_CORNER_NORMALS;
        const uint32_t prim = uint32_t(out.prims.size() / PRIM_WORDS);
        const uint32_t rec[PRIM_WORDS] = {kind,
                                          mod,
                                          NONE,
                                          bits(float(normal.x)),
                                          bits(float(normal.y)),
                                          bits(float(normal.z)),
                                          uint32_t(out.u.size()),
                                          bits(0.0f)};
        out.prims.insert(out.prims.end(), rec, rec + PRIM_WORDS);
        out.prim_object.push_back(FlatScene::NO_OBJECT);
        out.triangles.insert(out.triangles.end(), {t.v[0], t.v[1], t.v[2]});
        out.tri_prim.push_back(prim | (pass ? ID_TRANSPARENT : 0u));
        if (pass) out.shadow_mode = SHADOW_STRAIGHT;
        if (corners)
            for (uint32_t v : t.v) out.u.push_back(corner_at + CORNER_FLOATS * v);
    }
}

}  // namespace trace
