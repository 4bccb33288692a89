// SPDX-License-Identifier: BSD-3-Clause
// The table of generators, their arguments and their output.
#include "generators/generators.h"
#include <fmt/format.h>
#include <iterator>
#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"

namespace generators {

namespace {
struct Row {
    const char* name;
    Generator run;
};
const Row rows[] = {
    {"genblinds", genblinds}, {"genbox", genbox},     {"genciesky", genciesky},
    {"gendaylit", gendaylit}, {"genprism", genprism}, {"genrev", genrev},
    {"gensky", gensky},       {"gensurf", gensurf},   {"genworm", genworm},
};
}  // namespace

Generator find(const std::string& name) {
    for (const Row& r : rows)
        if (name == r.name) return r.run;
    return nullptr;
}

void Call::fail(const std::string& fact) const { base::fail(place, words[0] + ": " + fact); }

const std::string& Call::word(size_t i, const char* what) const {
    if (i >= words.size()) fail(std::string(what) + " is missing");
    return words[i];
}

double Call::real(size_t i, const char* what) const {
    double v;
    if (!base::parse_real(word(i, what), v))
        fail(std::string(what) + ": \"" + base::excerpt(words[i]) + "\" is not a number");
    return v;
}

long long Call::integer(size_t i, const char* what, long long low, long long high) const {
    long long v;
    if (!base::parse_integer(word(i, what), v) || v < low || v > high)
        fail(fmt::format("{}: \"{}\" is not an integer of {} to {}", what, base::excerpt(words[i]), low, high));
    return v;
}

std::string number(double v) { return fmt::format("{:.12g}", v); }

// Quotes cannot be escaped: each kind stands within the other.
std::string quoted(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t\n\v\f\r'\"") == std::string::npos) return word;
    std::string s;
    for (char c : word) s += c == '"' ? "'\"'" : std::string("\"") + c + "\"";
    return s;
}

void write_surface(std::string& out, const std::string& material, const char* type, const std::string& name,
                   const std::vector<double>& reals) {
    fmt::format_to(std::back_inserter(out), "\n{} {} {}\n0\n0\n{}", quoted(material), type, quoted(name), reals.size());
    for (size_t i = 0; i < reals.size(); i++) out += (i % 3 ? "\t" : "\n\t") + number(reals[i]);
    out += '\n';
}

void write_polygon(std::string& out, const std::string& material, const std::string& name,
                   const std::vector<base::Vec3>& v) {
    std::vector<double> reals;
    for (const base::Vec3& p : v) reals.insert(reals.end(), {p.x, p.y, p.z});
    write_surface(out, material, "polygon", name, reals);
}

}  // namespace generators
