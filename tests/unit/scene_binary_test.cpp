// SPDX-License-Identifier: BSD-3-Clause
// Octrees and meshes written by RADIANCE's oconv and obj2mesh (golden/scene), and the same files damaged: cut at every
// byte, and with bytes changed at random (fixed seed).  Damage gives an Error or another scene, never a crash.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <cmath>
#include <random>
#include "scene/assets.h"
#include "scene/triangulate.h"
#include "scene_text.h"

namespace {

const std::string golden = LUXPIPE_TESTS "/golden/scene/";

template <class Read>
void damage(const std::string& whole, const std::string& name, Read read) {
    const Folder folder;
    for (size_t n = 0; n + 1 < whole.size(); n++) {
        Folder::write(name, whole.substr(0, n));
        error_of(read);
    }
    std::mt19937 random(1);
    for (int i = 0; i < 500; i++) {
        std::string text = whole;
        for (unsigned k = random() % 4 + 1; k > 0; k--) text[random() % text.size()] = static_cast<char>(random());
        Folder::write(name, text);
        error_of(read);
    }
    CHECK(true);  // we are still here
}

}  // namespace

TEST_CASE("a frozen octree gives back its scene") {
    const scene::Scene s = scene::read_scene({golden + "in_a.oct"}, {});
    REQUIRE(s.objects.size() == 3);
    CHECK(s.strings(s.objects[0])[0] == ".5+.25*Px");
    CHECK(s.objects[1].modifier == 0);
    CHECK(s.objects[2].modifier == 1);
    CHECK(s.reals(s.objects[1])[0] == .5);
    CHECK(s.reals(s.objects[1])[1] == doctest::Approx(.3).epsilon(1e-9));  // 4 bytes of mantissa
    CHECK(s.reals(s.objects[2])[0] == -1);
}

// Cube, names, tree and count as in the format; written here by hand.
TEST_CASE("an unfrozen octree is its scene files") {
    const Folder folder;
    Folder::write("a.rad", "void plastic m 0 0 5 1 1 1 0 0\n");
    const std::string zeros("0\0000\0000\0001\0", 8);
    std::string oct = "#?RADIANCE\noconv a.rad\nFORMAT=Radiance_octree\n\n";
    oct += std::string("\x01\x1f", 2) + zeros + std::string("a.rad\0!genbox m b 1 1 1\0\0", 25) +
           std::string("\0\0\0\x07\0", 5);
    Folder::write("t.oct", oct);
    CHECK(scene::read_scene({"t.oct"}, {}).objects.size() == 7);
    Folder::write("t.oct", oct.substr(0, oct.size() - 2));
    CHECK(error_of([] { scene::read_scene({"t.oct"}, {}); }) == "t.oct: the file is cut short");
}

// Some twenty blocks of the reader, whose ends fall into each kind of number and name; each real by its definition.
TEST_CASE("a large octree gives back what was written, wherever the blocks of the file end") {
    const int n = 20000;
    std::string oct = "#?RADIANCE\nFORMAT=Radiance_octree\n\n";
    const auto put = [&](int64_t v, int bytes) {
        while (bytes-- > 0) oct += char(v >> (8 * bytes) & 255);
    };
    const auto put_text = [&](const std::string& text) { oct.append(text.c_str(), text.size() + 1); };
    const auto mantissa = [](int i, int k) {
        return (k + i % 2 * 4 + 1) * 97 * (i + 1) % 1000003 * (i % 3 ? 2000 : -2000);
    };
    const auto exponent = [](int i) { return i % 40 - 20; };
    put(283 + 4, 2);
    for (const char* word : {"0", "0", "0", "1", ""}) put_text(word);
    put(n + 1, 4), put(1, 1), put(n, 4);  // one leaf that holds all
    for (int i = 0; i < n; i++) put(i, 4);
    for (const char* word : {"plastic", "polygon", ""}) put_text(word);
    put(0, 1), put(-1, 4), put_text("m"), put(0, 2), put(5, 2), oct += std::string(25, '\0');
    for (int i = 0; i < n; i++) {
        put(1, 1), put(0, 4), put_text("p" + std::to_string(i)), put(0, 2), put(9, 2);
        for (int k = 0; k < 9; k++) put(mantissa(i, k % 4 + k), 4), put(exponent(i), 1);
    }
    put(255, 1);
    const Folder folder;
    Folder::write("large.oct", oct);
    const scene::Scene s = scene::read_scene({"large.oct"}, {});
    REQUIRE(s.objects.size() == n + 1);
    int wrong = 0;
    for (int i = 0; i < n; i++) {
        const scene::Object& o = s.objects[size_t(i) + 1];
        wrong += s.name(o) != "p" + std::to_string(i) || s.reals(o).size() != 9;
        for (int k = 0; k < 9; k++) {
            const double m = mantissa(i, k % 4 + k), half = m > 0 ? .5 : -.5;
            wrong += s.reals(o)[size_t(k)] != std::ldexp((m + half) / 0x7fffffff, exponent(i));
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("an octree within itself is refused") {
    const Folder folder;
    std::string oct = text_of(golden + "in_b.oct");  // holds two instances of in_a.oct
    Folder::write("in_a.oct", oct);
    Folder::write("t.rad", "void instance i 1 in_a.oct 0 0");
    const scene::Scene s = scene::read_scene({"t.rad"}, {});
    scene::Assets assets({});
    CHECK(error_of([&] { assets.octree(s, s.objects[0]); }) ==
          "in_a.oct:1: octree \"in_a.oct\" holds an instance of itself");
    std::filesystem::copy(golden + "in_a.oct", "in_a.oct", std::filesystem::copy_options::overwrite_existing);
    std::filesystem::copy(golden + "in_b.oct", "in_b.oct");
    Folder::write("t.rad", "void instance i 5 in_b.oct -t 1 2 3 0 0\nvoid instance j 2 in_b.oct oops 0 0");
    const scene::Scene u = scene::read_scene({"t.rad"}, {});
    scene::Assets good({});
    const scene::Scene& inner = good.octree(u, u.objects[0]);
    CHECK(inner.objects.size() == 2);
    CHECK(&inner == &good.octree(u, u.objects[1]));
    CHECK(scene::Assets::transform(u, u.objects[0]).m[3][2] == 3);
    CHECK(error_of([&] { scene::Assets::transform(u, u.objects[1]); }) ==
          "t.rad:2: \"oops\" is not a transform option");
}

TEST_CASE("a compiled mesh: positions, texture coordinates, normals, materials") {
    const scene::Mesh quad = scene::read_mesh(golden + "quad.rtm");
    REQUIRE(quad.triangles.size() == 2);
    CHECK(quad.normals.empty());
    REQUIRE(quad.materials.objects.size() == 2);
    double area = 0;
    for (const auto& t : quad.triangles) {
        CHECK(quad.materials.objects[t.material].type == scene::Type::plastic);
        area +=
            cross(quad.positions[t.v[1]] - quad.positions[t.v[0]], quad.positions[t.v[2]] - quad.positions[t.v[0]]).z /
            2;
        for (uint32_t v : t.v) {  // u = x + 1, v = (y + 1)/2
            CHECK(quad.uvs[v].u == doctest::Approx(quad.positions[v].x + 1).epsilon(1e-6));
            CHECK(quad.uvs[v].v == doctest::Approx((quad.positions[v].y + 1) / 2).epsilon(1e-6));
        }
    }
    CHECK(area == doctest::Approx(4));
    const scene::Mesh tri = scene::read_mesh(golden + "tri.rtm");
    REQUIRE(tri.normals.size() == 3);
    const double c = std::cos(std::atan(.3)),
                 angle = std::acos(std::fmin(1, tri.normals[0].x * .3 * c + tri.normals[0].z * c));
    CHECK(angle * 180 / M_PI < .006);
    CHECK(tri.triangles[0].material == scene::VOID);
}

TEST_CASE("an .obj file is the same mesh as its compiled form") {
    const scene::Mesh a = scene::read_mesh(golden + "tri.obj"), b = scene::read_mesh(golden + "tri.rtm");
    REQUIRE(a.positions.size() == b.positions.size());
    for (size_t i = 0; i < a.positions.size(); i++) CHECK(length(a.positions[i] - b.positions[i]) < 1e-9);
    CHECK(a.material_names == std::vector<std::string>{"mat"});
    CHECK(a.triangles[0].material == 0);
}

TEST_CASE(".obj: indices from the end, continued lines, faces with a dent") {
    const Folder folder;
    Folder::write("a.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 .5 0\nv 0 2 0\nf -5 -4 \\\n-3 -2 -1\n");
    const scene::Mesh m = scene::read_mesh("a.obj");
    REQUIRE(m.triangles.size() == 3);
    double area = 0;
    for (const auto& t : m.triangles) {
        const double a =
            cross(m.positions[t.v[1]] - m.positions[t.v[0]], m.positions[t.v[2]] - m.positions[t.v[0]]).z / 2;
        CHECK(a > 0);
        area += a;
    }
    CHECK(area == doctest::Approx(2.5));  // the square less the dent
    Folder::write("b.obj", "v 0 0 0\nf 1 2 3\n");
    CHECK(error_of([] { scene::read_mesh("b.obj"); }) == "b.obj:2: vertex 2 does not exist");
    Folder::write("c.obj", "v 0 0\n");
    CHECK(error_of([] { scene::read_mesh("c.obj"); }) == "c.obj:1: needs 3 numbers");
}

TEST_CASE("an .obj among the scene files is a mesh primitive") {
    const Folder folder;
    Folder::write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const scene::Scene s = scene::read_scene({"chair.obj"}, {});
    REQUIRE(s.objects.size() == 1);
    CHECK(s.objects[0].type == scene::Type::mesh);
    scene::Assets assets({});
    CHECK(assets.mesh(s, s.objects[0]).triangles.size() == 1);
}

TEST_CASE("damaged octrees and meshes give errors") {
    scene::Limits small;
    small.bytes = 64 << 20;
    damage(text_of(golden + "in_a.oct"), "t.oct", [&] { scene::read_scene({"t.oct"}, {}, small); });
    damage(text_of(golden + "quad.rtm"), "t.rtm", [&] { scene::read_mesh("t.rtm", small); });
    damage(text_of(golden + "tri.obj"), "t.obj", [&] { scene::read_mesh("t.obj", small); });
}
