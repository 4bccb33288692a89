// SPDX-License-Identifier: BSD-3-Clause
// A triangle mesh as one tree: one primitive a triangle, corner data shared by the triangles around a vertex.
// About 85 bytes a triangle in the tables, beside the hierarchy's own.
#include "base/error.h"
#include "base/memory.h"
#include "flatten/pack.h"
#include "flatten/surfaces.h"

namespace flatten {
namespace {

// Reserves memory for all, once.
void reserve(const scene::Mesh& mesh, bool corners, Draft& out) {
    const size_t n = mesh.positions.size(), triangles = mesh.triangles.size();
    if (out.corners.size() + n > 0xffffffffu || out.u.size() + 3 * triangles > 0xffffffffu ||
        out.prims.size() + triangles > ID_PRIM)
        base::fail(mesh.path, "too many triangles");
    out.make_room(n, triangles, triangles);
    if (!corners) return;
    base::make_room(out.corners, n);
    base::make_room(out.u, 3 * triangles);
}

void add_corners(const scene::Mesh& mesh, Draft& out) {
    const bool smooth = !mesh.normals.empty(), mapped = !mesh.uvs.empty();
    for (size_t i = 0; i < mesh.positions.size(); i++) {
        const scene::Mesh::Normal a = smooth ? mesh.normals[i] : scene::Mesh::Normal{0, 0, 0};
        const scene::Mesh::Uv t = mapped ? mesh.uvs[i] : scene::Mesh::Uv{0, 0};
        out.corners.push_back({{a.x, a.y, a.z}, t.u, t.v});
    }
}

bool has_normals(const scene::Mesh& mesh, const scene::Mesh::Triangle& t) {
    for (uint32_t v : t.v)
        if (mesh.normals[v].x == 0 && mesh.normals[v].y == 0 && mesh.normals[v].z == 0) return false;
    return true;
}

// Names the groups one after another, and says which one a triangle is of.
class GroupNames {
public:
    GroupNames(const scene::Mesh& mesh, Draft& out) : mesh_(mesh), out_(out) {}
    uint32_t of(size_t triangle) {
        if (!out_.names) return FlatScene::NO_OBJECT;
        for (; next_ < mesh_.groups.size() && mesh_.groups[next_].first <= triangle; next_++) {
            const scene::Mesh::Group& g = mesh_.groups[next_];
            now_ = g.name.empty() ? FlatScene::NO_OBJECT : uint32_t(out_.inner_names.size());
            if (!g.name.empty())
                out_.inner_names.push_back({g.name, "mesh", mesh_.path + ":" + std::to_string(g.line)});
        }
        return now_;
    }

private:
    const scene::Mesh& mesh_;
    Draft& out_;
    size_t next_ = 0;
    uint32_t now_ = FlatScene::NO_OBJECT;
};

}  // namespace

void flatten_mesh(const scene::Mesh& mesh, const Modifiers* modifiers, const std::vector<int32_t>& materials,
                  Vec3 centre, Draft& out) {
    const bool smooth = !mesh.normals.empty(), corners = smooth || !mesh.uvs.empty();
    reserve(mesh, corners, out);
    for (const Vec3& position : mesh.positions) {
        const Vec3 p = position - centre;
        out.vertices.insert(out.vertices.end(), {float(p.x), float(p.y), float(p.z)});
    }
    const uint32_t corner_at = uint32_t(out.corners.size());
    if (corners) add_corners(mesh, out);

    GroupNames groups(mesh, out);
    for (const scene::Mesh::Triangle& t : mesh.triangles) {
        uint32_t mod = NONE;
        bool passes = false, clear = false;
        if (modifiers) {
            int32_t m = t.material;
            if (m >= 0 && !materials.empty()) m = materials[size_t(m)];
            if (m < 0 || !modifiers->is_met[m]) continue;
            mod = modifiers->record[m];
            passes = modifiers->passes[m];
            clear = modifiers->is_clear(m);
        }
        const Vec3 a = mesh.positions[t.v[0]];
        const Vec3 across = cross(mesh.positions[t.v[1]] - a, mesh.positions[t.v[2]] - a);
        const double area2 = length(across);
        if (!(area2 > 0)) continue;
        const Vec3 normal = across * (1 / area2);
        uint32_t kind = corners ? PRIM_SMOOTH : PRIM_FLAT;
        if (smooth && has_normals(mesh, t)) kind |= PRIM_CORNER_NORMALS;

        if (clear) kind |= PRIM_CLEAR;
        const Vec3 of_tree[3] = {a - centre, mesh.positions[t.v[1]] - centre, mesh.positions[t.v[2]] - centre};
        const Plane plane(normal, of_tree, 3);
        kind |= extent_bits(plane.extent_of_triangles(of_tree, 3));
        const uint32_t prim = uint32_t(out.prims.size());
        out.prims.push_back({kind, mod, NONE, packed(normal), plane.offset, uint32_t(out.u.size())});
        out.prim_object.push_back(groups.of(size_t(&t - mesh.triangles.data())));
        out.triangles.insert(out.triangles.end(), {t.v[0], t.v[1], t.v[2]});
        out.tri_prim.push_back(prim | (passes ? ID_TRANSPARENT : 0u));
        if (passes) out.shadows_need(SHADOW_STRAIGHT);
        if (corners)
            for (uint32_t v : t.v) out.u.push_back(corner_at + v);
    }
}

}  // namespace flatten
