// SPDX-License-Identifier: BSD-3-Clause
// Wavefront .obj: v, vt, vn, f (any number of corners, indices from 1 or from the end), usemtl, and the names
// of o and g.  Other lines mean nothing here.  A corner "position/texture/normal" becomes one vertex of the mesh; faces
// are cut into triangles.
#include <unordered_map>
#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "scene/mesh_formats.h"
#include "scene/triangulate.h"

namespace scene {

namespace {

struct Corner {
    uint32_t position, texture, normal;  // from 1; 0 = none
    bool operator==(const Corner& o) const {
        return position == o.position && texture == o.texture && normal == o.normal;
    }
};
struct CornerHash {
    size_t operator()(const Corner& c) const {
        uint64_t h = c.position * 0x9e3779b97f4a7c15u;
        h = (h ^ (h >> 32) ^ c.texture) * 0x9e3779b97f4a7c15u;
        return (h ^ (h >> 32) ^ c.normal) * 0x9e3779b97f4a7c15u;
    }
};

struct ObjReader {
    ObjReader(base::TextReader& source, Mesh& result) : in(source), mesh(result) {}
    base::TextReader& in;
    Mesh& mesh;
    std::vector<base::Vec3> positions;
    std::vector<Mesh::Normal> normals;
    std::vector<Mesh::Uv> uvs;
    std::unordered_map<Corner, uint32_t, CornerHash> vertices;
    std::unordered_map<std::string, int32_t> materials;
    int32_t material = VOID;
    Mesh::Group group{};  // of the next face
    bool any_normals = false, any_uvs = false;
    std::string place;
    uint32_t in_line = 0;
    std::string_view rest;  // of the line

    bool word(std::string_view& w) {
        const char* const blanks = " \t\r";
        const size_t begin = rest.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return false;
        const size_t end = std::min(rest.find_first_of(blanks, begin), rest.size());
        w = rest.substr(begin, end - begin);
        rest.remove_prefix(end);
        return true;
    }

    void numbers(double* v, int needed, int most) {
        std::string_view w;
        for (int i = 0; i < most; i++) {
            if (!word(w)) {
                if (i < needed) base::fail(place, "needs " + std::to_string(needed) + " numbers");
                return;
            }
            if (!base::parse_real(w, v[i])) base::fail(place, "\"" + base::excerpt(w) + "\" is not a number");
        }
    }

    uint32_t index(std::string_view text, size_t count, const char* what) {
        long long i;
        if (!base::parse_integer(text, i)) base::fail(place, "\"" + base::excerpt(text) + "\" is not an index");
        if (i < 0) i += static_cast<long long>(count) + 1;
        if (i < 1 || i > static_cast<long long>(count))
            base::fail(place, std::string(what) + " " + base::excerpt(text) + " does not exist");
        return uint32_t(i);
    }

    uint32_t vertex(std::string_view w) {
        Corner c{0, 0, 0};
        const size_t slash = w.find('/');
        c.position = index(w.substr(0, slash), positions.size(), "vertex");
        if (slash != std::string_view::npos) {
            const std::string_view tail = w.substr(slash + 1);
            const size_t second = tail.find('/');
            if (second != 0 && !tail.empty()) c.texture = index(tail.substr(0, second), uvs.size(), "texture vertex");
            if (second != std::string_view::npos && second + 1 < tail.size())
                c.normal = index(tail.substr(second + 1), normals.size(), "normal");
        }
        const auto [found, fresh] = vertices.emplace(c, uint32_t(mesh.positions.size()));
        if (fresh) {
            mesh.positions.push_back(positions[c.position - 1]);
            mesh.normals.push_back(c.normal ? normals[c.normal - 1] : Mesh::Normal{0, 0, 0});
            mesh.uvs.push_back(c.texture ? uvs[c.texture - 1] : Mesh::Uv{0, 0});
            any_normals |= c.normal != 0;
            any_uvs |= c.texture != 0;
        }
        return found->second;
    }

    std::vector<uint32_t> face;
    std::vector<base::Vec3> outline;
    void read_face() {
        if (!group.name.empty() || !mesh.groups.empty()) begin_group();
        face.clear();
        for (std::string_view w; word(w);) face.push_back(vertex(w));
        if (face.size() < 3) base::fail(place, "a face with " + std::to_string(face.size()) + " vertices");
        if (face.size() == 3) {
            mesh.triangles.push_back({{face[0], face[1], face[2]}, material});
            return;
        }
        outline.clear();
        for (uint32_t v : face) outline.push_back(mesh.positions[v]);
        for (const auto& t : triangulate(outline))
            mesh.triangles.push_back({{face[t[0]], face[t[1]], face[t[2]]}, material});
    }

    void begin_group() {
        if (!mesh.groups.empty() && mesh.groups.back().line == group.line) return;
        group.first = mesh.triangles.size();
        mesh.groups.push_back(group);
    }

    // The rest of the line, blanks and all.
    std::string name_of_line() const {
        const char* const blanks = " \t\r";
        const size_t begin = rest.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return "";
        return std::string(rest.substr(begin, rest.find_last_not_of(blanks) - begin + 1));
    }

    void use_material() {
        const std::string name = name_of_line();
        if (name.empty()) base::fail(place, "usemtl without a name");
        const auto [found, fresh] = materials.emplace(name, int32_t(mesh.material_names.size()));
        if (fresh) {
            mesh.material_names.push_back(name);
            mesh.material_lines.push_back(in_line);
        }
        material = found->second;
    }

    void statement() {
        std::string_view key;
        if (!word(key) || key[0] == '#') return;
        double v[3] = {0, 0, 0};
        if (key == "v") {
            numbers(v, 3, 3);
            positions.push_back({v[0], v[1], v[2]});
        } else if (key == "vt") {
            numbers(v, 1, 2);
            uvs.push_back({float(v[0]), float(v[1])});
        } else if (key == "vn") {
            numbers(v, 3, 3);
            const base::Vec3 n = base::unit({v[0], v[1], v[2]});
            normals.push_back({float(n.x), float(n.y), float(n.z)});
        } else if (key == "f") {
            read_face();
        } else if (key == "usemtl") {
            use_material();
        } else if (key == "o" || key == "g") {
            group.name = name_of_line();
            group.line = in_line;
        }
    }
};

}  // namespace

// A comment ends with its line, even with a backslash ("# C:\models\").
static bool goes_on(const std::string& line) {
    const size_t first = line.find_first_not_of(" \t");
    return (base::ends_with(line, "\\") || base::ends_with(line, "\\\r")) && line[first] != '#';
}

void read_obj(base::TextReader& in, Mesh& mesh) {
    ObjReader r(in, mesh);
    std::string line, more;
    for (;;) {
        r.place = in.place();
        r.in_line = in.line();
        if (!in.line(line, 1 << 20)) break;
        while (goes_on(line) && in.line(more, 1 << 20)) {
            line.resize(line.rfind('\\'));
            line += " " + more;
            if (line.size() > (1 << 24)) base::fail(r.place, "the line is longer than 16 million characters");
        }
        r.rest = line;
        r.statement();
        if (mesh.positions.size() > 0xfffffff0u) base::fail(r.place, "more vertices than 32-bit indices reach");
    }
    if (!r.any_normals) mesh.normals.clear();
    if (!r.any_uvs) mesh.uvs.clear();
}

}  // namespace scene
