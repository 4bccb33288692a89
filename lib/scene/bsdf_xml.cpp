// SPDX-License-Identifier: BSD-3-Clause
// XML by pugixml; what it means follows LBNL's WindowElement schema.  A file is read whole (at most 1 GB); tables are
// as long as their text, so nothing large is taken on a file's word.
#include "scene/bsdf_xml.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <pugixml.hpp>
#include "base/error.h"
#include "base/text_file.h"
#include "scene/bsdf_text.h"
#include "scene/bsdf_tree.h"

namespace scene {
namespace {

constexpr uint64_t max_file = uint64_t(1) << 30;
constexpr size_t max_cells = 1u << 16;  // of one basis

using base::fail;

std::string text_of(pugi::xml_node parent, const char* name) { return trimmed(parent.child_value(name)); }

double number_of(pugi::xml_node node, const std::string& place) {
    BsdfNumbers n(node.child_value(), place);
    const double v = n.number();
    if (n.peek()) fail(place, fmt::format("<{}> is not one number", node.name()));
    return v;
}

double length_of(pugi::xml_node material, const char* name, const std::string& place) {
    const pugi::xml_node node = material.child(name);
    if (trimmed(node.child_value()).empty()) return 0;
    const std::string unit = trimmed(node.attribute("unit").value());
    const struct {
        const char* name;
        double metres;
    } units[] = {{"meter", 1}, {"metre", 1},    {"m", 1},        {"centimeter", .01}, {"cm", .01}, {"millimeter", .001},
                 {"mm", .001}, {"foot", .3048}, {"feet", .3048}, {"inch", .0254},     {"", 1}};
    for (const auto& u : units)
        if (same_but_case(unit, u.name)) return number_of(node, place) * u.metres;
    fail(place, fmt::format("unknown unit \"{}\" of <{}>", unit, name));
}

BsdfBasis klems(const char* name, std::vector<double> theta, std::vector<uint32_t> count) {
    return {name, std::move(theta), std::move(count)};
}
std::vector<BsdfBasis> known_bases() {
    return {klems("LBNL/Klems Full", {0, 5, 15, 25, 35, 45, 55, 65, 75, 90}, {1, 8, 16, 20, 24, 24, 24, 16, 12}),
            klems("LBNL/Klems Half", {0, 6.5, 19.5, 32.5, 45.5, 58.5, 71.5, 90}, {1, 8, 12, 16, 20, 12, 8}),
            klems("LBNL/Klems Quarter", {0, 9, 27, 45, 63, 90}, {1, 8, 12, 12, 8})};
}

void read_basis(pugi::xml_node node, std::vector<BsdfBasis>& bases, const std::string& place) {
    BsdfBasis b;
    b.name = text_of(node, "AngleBasisName");
    for (const BsdfBasis& known : bases)
        if (same_but_case(b.name, known.name.c_str())) return;  // Klems' bases are what they are
    for (pugi::xml_node block : node.children("AngleBasisBlock")) {
        const pugi::xml_node bounds = block.child("ThetaBounds");
        const double low = number_of(bounds.child("LowerTheta"), place),
                     high = number_of(bounds.child("UpperTheta"), place);
        const double count = number_of(block.child("nPhis"), place);
        if (b.theta.empty()) b.theta.push_back(low);
        if (std::fabs(low - b.theta.back()) > 0.01 || !(high > low) || high > 90.01 || low < 0)
            fail(place, fmt::format("rings of angle basis \"{}\" do not join", b.name));
        if (!(count >= 1 && count <= 4096) || count != std::floor(count))
            fail(place, fmt::format("angle basis \"{}\" has a ring of {:g} patches", b.name, count));
        b.theta.push_back(high);
        b.count.push_back(uint32_t(count));
    }
    if (b.count.empty()) return;  // only named
    if (b.theta.front() != 0 || std::fabs(b.theta.back() - 90) > 0.01 || b.cells() > max_cells)
        fail(place, fmt::format("angle basis \"{}\" is not a hemisphere of at most {} patches", b.name, max_cells));
    b.theta.back() = 90;
    bases.push_back(std::move(b));
}

uint32_t find_basis(const std::string& name, const Bsdf& b, const std::string& place) {
    for (size_t i = 0; i < b.bases.size(); i++)
        if (same_but_case(name, b.bases[i].name.c_str())) return uint32_t(i);
    fail(place, fmt::format("unknown angle basis \"{}\"", name));
}

std::vector<float> read_matrix(const char* text, size_t incident, size_t exit, bool columns, const std::string& place) {
    BsdfNumbers in(text, place);
    std::vector<float> file;
    while (in.peek()) {
        if (file.size() == incident * exit)
            fail(place, fmt::format("more than {} x {} scattering values", incident, exit));
        file.push_back(in.value());
    }
    if (file.size() != incident * exit)
        fail(place, fmt::format("{} scattering values where {} x {} are expected", file.size(), incident, exit));
    if (!columns) return file;
    std::vector<float> m(file.size());
    for (size_t o = 0; o < exit; o++)
        for (size_t i = 0; i < incident; i++) m[i * exit + o] = file[o * incident + i];
    return m;
}

enum class Channel { y, x, z, u, v, none };
Channel channel_of(const std::string& name) {
    const struct {
        const char* name;
        Channel channel;
    } names[] = {{"Visible", Channel::y}, {"CIE-Y", Channel::y}, {"CIE-X", Channel::x},
                 {"CIE-Z", Channel::z},   {"CIE-u", Channel::u}, {"CIE-v", Channel::v}};
    for (const auto& n : names)
        if (same_but_case(name, n.name)) return n.channel;
    return Channel::none;
}

void read_block(pugi::xml_node block, Channel channel, const std::string& structure, Bsdf& out,
                const std::string& file) {
    const std::string direction = text_of(block, "WavelengthDataDirection");
    const std::string place = file + ": " + direction;
    BsdfTable* table = same_but_case(direction, "Transmission Back")    ? &out.transmission[0]
                       : same_but_case(direction, "Transmission Front") ? &out.transmission[1]
                       : same_but_case(direction, "Reflection Back")    ? &out.reflection[0]
                       : same_but_case(direction, "Reflection Front")   ? &out.reflection[1]
                                                                        : nullptr;
    if (!table) fail(file, fmt::format("unknown <WavelengthDataDirection> \"{}\"", direction));
    const char* data = block.child_value("ScatteringData");
    if (same_but_case(structure, "TensorTree3") || same_but_case(structure, "TensorTree4")) {
        const std::string basis = text_of(block, "AngleBasis");
        if (!basis.empty() && !same_but_case(basis, "LBNL/Shirley-Chiu"))
            fail(place, fmt::format("unknown angle basis \"{}\"", basis));
        BsdfTree* tree = channel == Channel::y   ? &table->tree
                         : channel == Channel::u ? &table->u
                         : channel == Channel::v ? &table->v
                                                 : nullptr;
        if (!tree) return;  // X and Z of a tensor are not used
        if (tree->dims) fail(place, "the same data appear twice");
        *tree = read_bsdf_tree(data, structure.back() - '0', place);
    } else {
        const bool columns = same_but_case(structure, "Columns");
        if (!columns && !same_but_case(structure, "Rows"))
            fail(file, fmt::format("unknown <IncidentDataStructure> \"{}\"", structure));
        const uint32_t column = find_basis(text_of(block, "ColumnAngleBasis"), out, place);
        const uint32_t row = find_basis(text_of(block, "RowAngleBasis"), out, place);
        const uint32_t incident = columns ? column : row, exit = columns ? row : column;
        std::vector<float>* m = channel == Channel::y   ? &table->y
                                : channel == Channel::x ? &table->x
                                : channel == Channel::z ? &table->z
                                                        : nullptr;
        if (!m) return;
        if (!m->empty()) fail(place, "the same data appear twice");
        const bool first = table->y.empty() && table->x.empty() && table->z.empty();
        if (!first && (table->incident != incident || table->exit != exit))
            fail(place, "the colours have different angle bases");
        table->incident = incident;
        table->exit = exit;
        *m = read_matrix(data, out.bases[incident].cells(), out.bases[exit].cells(), columns, place);
    }
}

}  // namespace

size_t BsdfBasis::cells() const {
    size_t n = 0;
    for (uint32_t c : count) n += c;
    return n;
}

Bsdf parse_bsdf(const std::string& text, const std::string& place) {
    pugi::xml_document xml;
    const pugi::xml_parse_result r = xml.load_buffer(text.data(), text.size());
    if (!r) {
        const size_t line =
            1 +
            size_t(std::count(text.begin(),
                              text.begin() + std::min(ptrdiff_t(text.size()), std::max(ptrdiff_t(0), r.offset)), '\n'));
        fail(fmt::format("{}:{}", place, line), fmt::format("XML: {}", r.description()));
    }
    const pugi::xml_node root = xml.child("WindowElement");
    if (!root) fail(place, "not a BSDF file: no <WindowElement>");
    const pugi::xml_node layer = root.child("Optical").child("Layer");
    if (!layer) fail(place, "no <Layer> in <Optical>");
    Bsdf out;
    out.bases = known_bases();
    const pugi::xml_node material = layer.child("Material");
    out.name = text_of(material, "Name");
    out.thickness = length_of(material, "Thickness", place);
    out.width = length_of(material, "Width", place);
    out.height = length_of(material, "Height", place);
    const pugi::xml_node definition = layer.child("DataDefinition");
    const std::string structure = text_of(definition, "IncidentDataStructure");
    for (pugi::xml_node basis : definition.children("AngleBasis")) read_basis(basis, out.bases, place);
    for (pugi::xml_node data : layer.children("WavelengthData")) {
        const Channel channel = channel_of(text_of(data, "Wavelength"));
        if (channel == Channel::none) continue;  // solar, infrared
        for (pugi::xml_node block : data.children("WavelengthDataBlock"))
            read_block(block, channel, structure, out, place);
    }
    bool any = false;
    for (auto* tables : {&out.reflection, &out.transmission})
        for (BsdfTable& t : *tables) {
            t.present = !t.y.empty() || t.tree.dims;
            any = any || t.present;
            if (t.x.empty() || t.z.empty()) {
                t.x.clear();
                t.z.clear();
            }
            if (!t.u.dims || !t.v.dims) t.u = t.v = {};
        }
    if (!any) fail(place, "no scattering data for visible light");
    return out;
}

Bsdf read_bsdf(const std::string& path, const base::Opener& by) {
    return parse_bsdf(base::read_text_file(path, max_file, by), path);
}

}  // namespace scene
