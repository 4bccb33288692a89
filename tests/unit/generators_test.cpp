// SPDX-License-Identifier: BSD-3-Clause
// The built-in generators and xform against RADIANCE's own output (golden/scene, see the heads of its tables): every
// primitive's type, modifier, name and strings are equal, its numbers within their printed digits.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <cmath>
#include "base/angle.h"
#include "base/number.h"
#include "generators/generators.h"
#include "scene_text.h"

namespace {

const std::string golden = LUXPIPE_TESTS "/golden/scene/";

// Modifiers that the commands' output uses, so that it is a scene.
const char* const modifiers =
    "void plastic m 0 0 5 1 1 1 0 0\nvoid plastic newm 0 0 5 1 1 1 0 0\n"
    "void plastic other 0 0 5 1 1 1 0 0\nvoid plastic pl 0 0 5 1 1 1 0 0\n";

std::string modifier_name(const scene::Scene& s, const scene::Object& o) {
    return o.modifier == scene::VOID ? "void" : s.name(s.objects[o.modifier]);
}

void check_same(const scene::Scene& a, const scene::Scene& b) {
    REQUIRE(a.objects.size() == b.objects.size());
    for (size_t i = 0; i < a.objects.size(); i++) {
        const scene::Object &x = a.objects[i], &y = b.objects[i];
        CAPTURE(a.name(x));
        REQUIRE(std::string(type_name(x.type)) == type_name(y.type));
        REQUIRE(modifier_name(a, x) == modifier_name(b, y));
        REQUIRE(a.name(x) == b.name(y));
        REQUIRE(x.string_count == y.string_count);
        REQUIRE(x.real_count == y.real_count);
        for (size_t k = 0; k < x.string_count; k++) REQUIRE(a.strings(x)[k] == b.strings(y)[k]);
        const bool six_digits =
            x.type == scene::Type::mist || x.type == scene::Type::dielectric || x.type == scene::Type::interface;
        for (size_t k = 0; k < x.real_count; k++) {
            const double v = a.reals(x)[k], w = b.reals(y)[k];
            REQUIRE(std::fabs(v - w) <= (six_digits ? 1e-6 : 1e-9) * std::fmax(1, std::fabs(v)));
        }
    }
}

std::vector<std::vector<std::string>> table(const std::string& path) {
    std::vector<std::vector<std::string>> rows;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
        if (line[0] == '#') continue;
        std::stringstream columns(line);
        rows.emplace_back();
        for (std::string c; std::getline(columns, c, '\t');) rows.back().push_back(c);
    }
    return rows;
}

}  // namespace

TEST_CASE("every command writes what RADIANCE's program writes") {
    const Folder folder;
    for (const char* name : {"xf_in.rad", "xf_ball.rad", "xf_args.txt"}) std::filesystem::copy(golden + name, name);
    int count = 0;
    for (const auto& row : table(golden + "commands.tsv")) {
        const std::string &file = row[0], &command = row[1];
        CAPTURE(command);
        const std::string program = command.substr(0, command.find(' '));
        if (program != "xform") REQUIRE(bool(generators::find(program)));
        std::string expected = text_of(golden + file);
        Folder::write("expected.rad", modifiers + expected);
        Folder::write("ours.rad", std::string(modifiers) + "!" + command + "\n");
        check_same(scene::read_scene({"expected.rad"}, {}), scene::read_scene({"ours.rad"}, {}));
        count++;
    }
    CHECK(count == 35);
}

// xform -c leaves the inner command for the reader, with the transform behind a pipe; the result is the same.
TEST_CASE("xform -c comes to the same as -e") {
    const Folder folder;
    for (const char* name : {"xf_in.rad"}) std::filesystem::copy(golden + name, name);
    Folder::write("expected.rad", modifiers + text_of(golden + "gen_21.out"));
    Folder::write("ours.rad", std::string(modifiers) + "!xform -c -a 2 -t 1 0 0 -i 1 -ry 30 xf_in.rad\n");
    check_same(scene::read_scene({"expected.rad"}, {}), scene::read_scene({"ours.rad"}, {}));
}

// Printed with 4 digits (skies) and 6 decimals (directions, Perez coefficients), some rows of the table with 6 digits
// only; RADIANCE computes part of them in single precision, so the last decimal may differ by one or two.
TEST_CASE("skies have RADIANCE's numbers") {
    int count = 0;
    for (const auto& row : table(golden + "sky.tsv")) {
        CAPTURE(row[0]);
        const scene::Scene s = read_text("!" + row[0] + "\n");
        std::string solar = "0", source = "-", args;
        auto numbers = [&](const scene::Object& o, size_t from) {
            std::string text;
            for (size_t i = from; i < o.real_count; i++)
                text += (text.empty() ? "" : " ") + generators::number(s.reals(o)[i]);
            return text;
        };
        for (const scene::Object& o : s.objects) {
            if (o.type == scene::Type::light) solar = generators::number(s.reals(o)[0]);
            if (o.type == scene::Type::source) source = numbers(o, 0);
            if (s.name(o) == "skyfunc") args = numbers(o, 0);
        }
        CHECK((source == "-") == (row[2] == "-"));
        auto same = [](const std::string& a, const std::string& b) {
            std::istringstream x(a), y(b);
            std::string v, w;
            while (x >> v) {
                REQUIRE(bool(y >> w));
                double p = 0, q = 0;
                if (v == "-" && w == "-") continue;
                REQUIRE(base::parse_real(v, p));
                REQUIRE(base::parse_real(w, q));
                REQUIRE(std::fabs(p - q) <= 2.1e-6 + 5e-6 * std::fabs(p));
            }
            REQUIRE(!bool(y >> w));
        };
        same(row[1], solar);
        same(row[2], source);
        same(row[3], args);
        count++;
    }
    CHECK(count == 56);
}

// Each piece's texture must give the round shape's normals at its vertices: away from the nearest point of the inner
// box.
TEST_CASE("genbox -s has the normals of the round box") {
    for (const std::string inward : {"", " -i"}) {
        const scene::Scene s = read_text("void plastic m 0 0 5 1 1 1 0 0\n!genbox m b 1 2 3 -r .25 -n 4 -s" + inward);
        const double size[3] = {1, 2, 3}, r = .25;
        int textured = 0, flat = 0;
        for (const scene::Object& o : s.objects) {
            if (o.type != scene::Type::polygon) continue;
            const scene::Object& modifier = s.objects[o.modifier];
            if (modifier.type != scene::Type::texfunc) {
                flat++;
                continue;
            }
            textured++;
            REQUIRE(s.strings(modifier)[3] == "tmesh.cal");
            const auto a = s.reals(modifier);
            const int axis = static_cast<int>(a[0]);
            for (size_t v = 0; v < 9; v += 3) {
                const double* p = &s.reals(o)[v];
                for (int k = 0; k < 3; k++) {
                    const double nearest = std::fmin(std::fmax(p[k], r), size[k] - r);
                    const double normal =
                        a[1 + 3 * k] * p[(axis + 1) % 3] + a[2 + 3 * k] * p[(axis + 2) % 3] + a[3 + 3 * k];
                    REQUIRE(normal == doctest::Approx((p[k] - nearest) / r * (inward.empty() ? 1 : -1)).epsilon(1e-9));
                }
            }
        }
        CHECK(textured == 12 * 4 * 2 + 8 * 16);
        CHECK(flat == 6);
    }
}

// The general skies of ISO 15469, table 1, and the traditional overcast sky (16).
const double cie_types[16][5] = {{4, -.7, 0, -1, 0},       {4, -.7, 2, -1.5, .15},  {1.1, -.8, 0, -1, 0},
                                 {1.1, -.8, 2, -1.5, .15}, {0, -1, 0, -1, 0},       {0, -1, 2, -1.5, .15},
                                 {0, -1, 5, -2.5, .3},     {0, -1, 10, -3, .45},    {-1, -.55, 2, -1.5, .15},
                                 {-1, -.55, 5, -2.5, .3},  {-1, -.55, 10, -3, .45}, {-1, -.32, 10, -3, .45},
                                 {-1, -.32, 16, -3, .3},   {-1, -.15, 16, -3, .3},  {-1, -.15, 24, -2.8, .15}};

// Horizontal irradiance per level by midpoints, about the zenith, in mu = cos Z squared and azimuth.
double cie_irradiance(int type, double sun_altitude) {
    const double* t = cie_types[type - 1];
    const int n = 1500;
    double sum = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n / 4; j++) {
            const double z = std::sqrt((i + .5) / n), azimuth = base::pi * (j + .5) / (n / 4);
            const double c =
                z * std::sin(sun_altitude) + std::sqrt(1 - z * z) * std::cos(sun_altitude) * std::cos(azimuth);
            const double chi = std::acos(std::fmin(c, 1));
            sum += (1 + t[0] * std::exp(t[1] / z)) *
                   (1 + t[2] * (std::exp(t[3] * chi) - std::exp(t[3] * base::pi / 2)) + t[4] * c * c);
        }
    return sum * base::pi / (n * (n / 4));
}

TEST_CASE("genciesky: level and coefficients are those of ISO 15469 at the irradiance asked for") {
    for (int type = 1; type <= 16; type++)
        for (double altitude : {0., 8., 60., 90.}) {
            CAPTURE(type);
            CAPTURE(altitude);
            const scene::Scene s = read_text("!genciesky " + std::to_string(type) + " -ang " +
                                             std::to_string(altitude) + " 30 -L 17900\n");
            REQUIRE(s.objects.size() == 1);
            CHECK(s.name(s.objects[0]) == "skyfunc");
            CHECK(s.strings(s.objects[0])[0] == (type == 16 ? "traditional" : "ciesky"));
            const auto r = s.reals(s.objects[0]);
            if (type == 16) {
                CHECK(r[0] == doctest::Approx(100 * 9 / (7 * base::pi)).epsilon(1e-8));
                continue;
            }
            if (type == 5) CHECK(r[0] == doctest::Approx(100 / base::pi).epsilon(1e-8));
            for (int k = 0; k < 5; k++) CHECK(r[size_t(1 + k)] == cie_types[type - 1][k]);
            CHECK(r[0] * cie_irradiance(type, altitude * base::degree) == doctest::Approx(100).epsilon(1e-4));
            CHECK(r[8] == doctest::Approx(std::sin(altitude * base::degree)).epsilon(1e-8));
        }
}

TEST_CASE("genciesky: the sun stands where gensky's does, and has the irradiance asked for") {
    const std::string site = " 3 21 14:30CET -a 48.1 -o -11.6";
    const scene::Scene ours = read_text("!genciesky 12" + site + " -B 50 -R 200\n");
    const scene::Scene other = read_text("!gensky" + site + "\n");
    REQUIRE(ours.objects.size() == 3);
    const auto a = ours.reals(ours.objects[1]), b = other.reals(other.objects[1]);
    for (size_t k = 0; k < 3; k++) CHECK(a[k] == doctest::Approx(b[k]).epsilon(2e-6));
    const double half_sine = std::sin(.2665 * base::degree);
    CHECK(ours.reals(ours.objects[0])[0] * base::pi * half_sine * half_sine * a[2] ==
          doctest::Approx(200).epsilon(1e-5));
}

TEST_CASE("a wrong command line names the line, the program and the fact") {
    CHECK(error_in("\n!genbox m b 1 2\n") == "t.rad:2: genbox: the size is missing");
    CHECK(error_in("!genbox m b 1 x 3\n") == "t.rad:1: genbox: the size: \"x\" is not a number");
    CHECK(error_in("!genbox m b 1 2 3 -r .1 -b .1") ==
          "t.rad:1: genbox: bevel and radius must be positive, and only one of them given");
    CHECK(error_in("!genbox m b 1 2 3 -r 0") ==
          "t.rad:1: genbox: bevel and radius must be positive, and only one of them given");
    CHECK(error_in("!genbox m b 1 2 3 -r .1 -n 1000") == "t.rad:1: genbox: -n: more than 1000000 polygons");
    CHECK(error_in("!genbox m b 1 2 3 -o") ==
          "t.rad:1: genbox: -o writes a Wavefront file, which a scene cannot contain");
    CHECK(error_in("!gensurf m s s t 0 2 2 -o") ==
          "t.rad:1: gensurf: -o writes a Wavefront file, which a scene cannot contain");
    CHECK(error_in("!gensky 13 1 12\n") == "t.rad:1: gensky: the month: \"13\" is not an integer of 1 to 12");
    CHECK(error_in("!gensky 6 21 +12EST\n") == "t.rad:1: gensky: a time zone and solar time cannot be used together");
    CHECK(error_in("!gendaylit 6 21 12\n") == "t.rad:1: gendaylit: one of -P -W -G -L -E is needed");
    CHECK(error_in("!genciesky 17 6 21 12 -B 1\n") ==
          "t.rad:1: genciesky: the type: \"17\" is not an integer of 1 to 16");
    CHECK(error_in("!genciesky 5 6 21 12\n") == "t.rad:1: genciesky: one of -B and -L is needed");
    CHECK(error_in("!genciesky 5 -ang 10 0 -B -1\n") == "t.rad:1: genciesky: -B is below 0");
    CHECK(error_in("!genciesky 5 -ang 10 0 -B 1 -g .2\n") == "t.rad:1: genciesky: unknown option \"-g\"");
    CHECK(error_in("!genciesky 5 -ang -1 0 -B 1\n") ==
          "t.rad:1: genciesky: the sun's altitude is outside 0 to 90 degrees");
    CHECK(error_in("!genprism m p 2 0 0 1 1\n") ==
          "t.rad:1: genprism: the number of vertices: \"2\" is not an integer of 3 to 1000000");
    CHECK(error_in("!genblinds m n .1 1 2 1 0 +r .04\n") ==
          "t.rad:1: genblinds: the radius is smaller than half the depth");
}
