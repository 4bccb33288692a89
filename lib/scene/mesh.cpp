// SPDX-License-Identifier: BSD-3-Clause
// Compiled meshes (.rtm): patches of up to 256 vertices; triangles of one patch are local, those between patches name
// vertices as patch << 8 | local.  Coordinates are 32-bit fractions of the mesh's cube.
#include "scene/mesh.h"
#include <algorithm>
#include <cmath>
#include "base/error.h"
#include "base/split.h"
#include "scene/mesh_formats.h"
#include "scene/octree.h"

namespace scene {

namespace {

constexpr double two_32 = 4294967296.;

double fraction(uint64_t v) { return (double(v) + .5) / two_32; }

// Bits: 0-2 signs, 3 and 4 which axes d1 and d2 stand for, 5-17 and 18-30 their values in steps of 1/11584.5.
Mesh::Normal decode_normal(uint32_t code) {
    if (!code) return {0, 0, 0};
    const double d1 = (code >> 5 & 0x1fff) / 11584.5, d2 = (code >> 18 & 0x1fff) / 11584.5;
    const double d3 = std::sqrt(std::max(0., 1 - d1 * d1 - d2 * d2));
    const bool x_first = code & 8, z_second = code & 16;
    const double other = z_second ? d3 : d2, x = x_first ? d1 : other, y = x_first ? other : d1, z = z_second ? d2 : d3;
    auto sign = [&](int bit, double v) { return float(code >> bit & 1 ? -v : v); };
    return {sign(0, x), sign(1, y), sign(2, z)};
}

struct RtmReader {
    Binary in;
    Mesh& mesh;
    std::vector<int32_t> materials;      // of the file -> objects of mesh.materials
    std::vector<uint32_t> first_vertex;  // of each patch
    base::Vec3 corner;
    double size = 0, uv_limits[4] = {};
    bool any_normals = false, any_uvs = false;

    int32_t material() {
        const int64_t i = in.integer(2);
        if (i == -1) return VOID;
        if (i < 0 || i >= int64_t(materials.size()))
            in.fail("a triangle with material " + std::to_string(i) + ", which the mesh does not hold");
        return materials[i];
    }

    uint32_t count(uint32_t most, const char* what) {
        const uint64_t n = in.unsigned_integer(2);
        if (n > most) in.fail(std::string("a patch with ") + std::to_string(n) + " " + what);
        return uint32_t(n);
    }

    void add(uint32_t a, uint32_t b, uint32_t c, int32_t material) { mesh.triangles.push_back({{a, b, c}, material}); }

    void patch(uint32_t number) {
        const int flags = in.byte();
        const uint32_t n = count(256, "vertices");
        if (!(flags & 1) || n == 0) in.fail("a patch without vertices");
        const size_t first = mesh.positions.size();
        first_vertex.push_back(uint32_t(first));
        for (uint32_t i = 0; i < n; i++) {
            base::Vec3 p;
            for (int j = 0; j < 3; j++) p[j] = corner[j] + fraction(in.unsigned_integer(4)) * size;
            mesh.positions.push_back(p);
        }
        mesh.normals.resize(first + n, {0, 0, 0});
        mesh.uvs.resize(first + n, {0, 0});
        if (flags & 2) {
            any_normals = true;
            for (uint32_t i = 0; i < n; i++) mesh.normals[first + i] = decode_normal(uint32_t(in.unsigned_integer(4)));
        }
        if (flags & 4) {
            any_uvs = true;
            for (uint32_t i = 0; i < n; i++) {
                float uv[2];
                for (int j = 0; j < 2; j++) {
                    const uint64_t v = in.unsigned_integer(4);
                    uv[j] = v ? float(uv_limits[2 * j] + (uv_limits[2 * j + 1] - uv_limits[2 * j]) * fraction(v)) : 0.f;
                }
                mesh.uvs[first + i] = {uv[0], uv[1]};
            }
        }
        auto local = [&] { return number << 8 | uint32_t(in.byte()); };
        auto global = [&] { return uint32_t(in.unsigned_integer(4)); };
        const size_t first_triangle = mesh.triangles.size();
        const uint32_t triangles = count(512, "triangles");
        for (uint32_t i = 0; i < triangles; i++) {
            const uint32_t a = local(), b = local(), c = local();
            add(a, b, c, VOID);
        }
        if (triangles) {
            const bool many = count(65535, "materials") > 1;
            const int32_t sole = many ? VOID : material();
            for (uint32_t i = 0; i < triangles; i++)
                mesh.triangles[first_triangle + i].material = many ? material() : sole;
        }
        for (uint32_t n1 = count(256, "single joiners"); n1 > 0; n1--) {
            const uint32_t a = global(), b = local(), c = local();
            add(a, b, c, material());
        }
        for (uint32_t n2 = count(256, "double joiners"); n2 > 0; n2--) {
            const uint32_t a = global(), b = global(), c = local();
            add(a, b, c, material());
        }
    }

    // Vertex ids to indices, once all patches are known.
    void resolve() {
        for (Mesh::Triangle& t : mesh.triangles)
            for (uint32_t& v : t.v) {
                const uint32_t p = v >> 8, local = v & 255;
                if (p >= first_vertex.size()) in.fail("a triangle names a patch that does not exist");
                const size_t end = p + 1 < first_vertex.size() ? first_vertex[p + 1] : mesh.positions.size();
                if (first_vertex[p] + local >= end) in.fail("a triangle names a vertex that does not exist");
                v = first_vertex[p] + local;
            }
    }
};

}  // namespace

void read_rtm(base::TextReader& source, const Limits& limits, Mesh& mesh) {
    RtmReader r{Binary(source), mesh, {}, {}, {}, 0, {}};
    r.in.header();
    const int index_size = read_magic(r.in, mesh_magic, "a mesh");
    for (int i = 0; i < 3; i++) r.corner[i] = r.in.text_real();
    r.size = r.in.text_real();
    for (double& limit : r.uv_limits) limit = r.in.real();
    skip_tree(r.in, index_size);
    SceneBuilder builder(mesh.materials, limits);
    r.materials = read_objects(r.in, index_size, -1, builder);
    for (const Object& o : mesh.materials.objects)
        if (is_surface(o.type)) r.in.fail("a mesh with a surface among its materials");
    const int64_t patches = r.in.integer(4);
    if (patches < 0 || patches > (1 << 24)) r.in.fail("an impossible number of patches");
    for (int64_t i = 0; i < patches; i++) r.patch(uint32_t(i));
    r.resolve();
    if (!r.any_normals) mesh.normals.clear();
    if (!r.any_uvs) mesh.uvs.clear();
}

Mesh read_mesh(const std::string& path, const Limits& limits, const base::Opener& by) {
    Mesh mesh;
    mesh.path = path;
    base::TextReader in = base::TextReader::from_file(path, by);
    if (in.header_format() == "Radiance_tmesh") read_rtm(in, limits, mesh);
    else if (base::ends_with(path, ".obj")) read_obj(in, mesh);
    else base::fail(path, "neither a compiled mesh (.rtm) nor a Wavefront .obj file");
    return mesh;
}

}  // namespace scene
