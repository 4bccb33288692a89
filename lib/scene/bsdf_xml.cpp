// SPDX-License-Identifier: BSD-3-Clause
// XML by pugixml; what it means follows LBNL's WindowElement schema.  A file is read whole (at most 1 GB); tables are
// as long as their text, so nothing large is taken on a file's word.
#include "scene/bsdf_xml.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <fmt/core.h>
#include <pugixml.hpp>
#include "base/error.h"

namespace scene {
namespace {

constexpr uint64_t MAX_FILE = uint64_t(1) << 30;
constexpr size_t MAX_CELLS = 1u << 16;  // of one basis
constexpr int MAX_DEPTH = 12;           // a tensor of 2^12 = 4096 cells a side is finer than any instrument

[[noreturn]] void fail(const std::string& place, const std::string& fact) { base::fail(place, fact); }

std::string trimmed(const char* text) {
    std::string s = text;
    const char* space = " \t\r\n";
    s.erase(0, s.find_first_not_of(space));
    s.erase(s.find_last_not_of(space) + 1);
    return s;
}
bool same(const std::string& a, const char* b) {
    if (a.size() != std::strlen(b)) return false;
    for (size_t i = 0; i < a.size(); i++)
        if (std::tolower(static_cast<unsigned char>(a[i])) != std::tolower(static_cast<unsigned char>(b[i])))
            return false;
    return true;
}
std::string text_of(pugi::xml_node parent, const char* name) { return trimmed(parent.child_value(name)); }

// Numbers separated by blanks or commas, and the braces of tensor trees.
class Numbers {
public:
    Numbers(const char* text, const std::string& place) : at_(text), end_(text + std::strlen(text)), place_(place) {}
    char peek() {  // the next character that is not a separator, 0 at the end
        while (at_ < end_ && (std::isspace(static_cast<unsigned char>(*at_)) || *at_ == ',')) at_++;
        return at_ < end_ ? *at_ : '\0';
    }
    void take() { at_++; }
    double number() {
        if (!peek()) fail(place_, "scattering data end too early");
        if (*at_ == '+') at_++;
        double v = 0;
        const auto r = std::from_chars(at_, end_, v);
        if (r.ec == std::errc::result_out_of_range) v = 0;
        else if (r.ec != std::errc() || !std::isfinite(v))
            fail(place_,
                 fmt::format("\"{}\" is not a number", std::string(at_, std::min<size_t>(size_t(end_ - at_), 12))));
        at_ = r.ptr;
        return v;
    }
    float value() {  // of a BSDF
        const double v = number();
        if (v > 1e30) fail(place_, "a BSDF value is above 1e30");
        return v > 0 ? float(v) : 0.0f;
    }

private:
    const char *at_, *end_;
    const std::string& place_;
};

double number_of(pugi::xml_node node, const std::string& place) {
    Numbers n(node.child_value(), place);
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
        if (same(unit, u.name)) return number_of(node, place) * u.metres;
    fail(place, fmt::format("unknown unit \"{}\" of <{}>", unit, name));
}

// ---- angle bases
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
        if (same(b.name, known.name.c_str())) return;  // Klems' bases are what they are
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
    if (b.theta.front() != 0 || std::fabs(b.theta.back() - 90) > 0.01 || b.cells() > MAX_CELLS)
        fail(place, fmt::format("angle basis \"{}\" is not a hemisphere of at most {} patches", b.name, MAX_CELLS));
    b.theta.back() = 90;
    bases.push_back(std::move(b));
}

uint32_t find_basis(const std::string& name, const Bsdf& b, const std::string& place) {
    for (size_t i = 0; i < b.bases.size(); i++)
        if (same(name, b.bases[i].name.c_str())) return uint32_t(i);
    fail(place, fmt::format("unknown angle basis \"{}\"", name));
}

// ---- tensor trees
class TreeReader {
public:
    TreeReader(const char* text, int dims, const std::string& place, BsdfTree& tree)
        : in_(text, place), place_(place), tree_(tree), dims_(dims) {}
    void read() {
        tree_.dims = dims_;
        tree_.value.push_back(0);
        tree_.child.push_back(BsdfTree::LEAF);
        node(0, 0);
        if (in_.peek()) fail(place_, "more scattering data than the tensor tree holds");
    }

private:
    uint32_t split(uint32_t parent) {
        const size_t first = tree_.value.size(), count = size_t(1) << dims_;
        tree_.value.resize(first + count, 0.0f);
        tree_.child.resize(first + count, BsdfTree::LEAF);
        tree_.child[parent] = uint32_t(first);
        return uint32_t(first);
    }
    void node(uint32_t at, int depth) {
        if (in_.peek() != '{') fail(place_, "a tensor tree lacks an opening brace");
        in_.take();
        if (in_.peek() == '{') {
            if (depth >= MAX_DEPTH) fail(place_, fmt::format("a tensor tree is deeper than {} levels", MAX_DEPTH));
            const uint32_t first = split(at);
            for (uint32_t c = 0; c < 1u << dims_; c++) node(first + c, depth + 1);
        } else {
            std::vector<float> grid;
            while (in_.peek() != '}') grid.push_back(in_.value());
            int levels = 0;
            while (levels < MAX_DEPTH && size_t(1) << (levels * dims_) < grid.size()) levels++;
            if (size_t(1) << (levels * dims_) != grid.size())
                fail(place_, fmt::format("a leaf of a tensor tree has {} values, which fill no grid of {} dimensions",
                                         grid.size(), dims_));
            if (depth + levels > MAX_DEPTH)
                fail(place_, fmt::format("a tensor tree is deeper than {} levels", MAX_DEPTH));
            tree_.depth = std::max(tree_.depth, depth + levels);
            expand(at, grid, levels, levels, 0);
        }
        if (in_.peek() != '}') fail(place_, "a tensor tree lacks a closing brace");
        in_.take();
    }
    // The grid (dimension 0 slowest) below a node; low = index of the node's lower corner.
    void expand(uint32_t at, const std::vector<float>& grid, int levels, int left, size_t low) {
        if (left == 0) {
            tree_.value[at] = grid[low];
            return;
        }
        const uint32_t first = split(at);
        for (uint32_t c = 0; c < 1u << dims_; c++) {
            size_t corner = low;
            for (int k = 0; k < dims_; k++)
                if (c >> k & 1) corner += size_t(1) << ((left - 1) + levels * (dims_ - 1 - k));
            expand(first + c, grid, levels, left - 1, corner);
        }
    }
    Numbers in_;
    const std::string& place_;
    BsdfTree& tree_;
    int dims_;
};

std::vector<float> read_matrix(const char* text, size_t incident, size_t exit, bool columns, const std::string& place) {
    Numbers in(text, place);
    std::vector<float> file;
    while (in.peek()) {
        if (file.size() == incident * exit)
            fail(place, fmt::format("more than {} x {} scattering data", incident, exit));
        file.push_back(in.value());
    }
    if (file.size() != incident * exit)
        fail(place, fmt::format("{} scattering data where {} x {} are due", file.size(), incident, exit));
    if (!columns) return file;
    std::vector<float> m(file.size());
    for (size_t o = 0; o < exit; o++)
        for (size_t i = 0; i < incident; i++) m[i * exit + o] = file[o * incident + i];
    return m;
}

enum Channel { CHANNEL_Y, CHANNEL_X, CHANNEL_Z, CHANNEL_U, CHANNEL_V, CHANNEL_NONE };
Channel channel_of(const std::string& name) {
    const struct {
        const char* name;
        Channel channel;
    } names[] = {{"Visible", CHANNEL_Y}, {"CIE-Y", CHANNEL_Y}, {"CIE-X", CHANNEL_X},
                 {"CIE-Z", CHANNEL_Z},   {"CIE-u", CHANNEL_U}, {"CIE-v", CHANNEL_V}};
    for (const auto& n : names)
        if (same(name, n.name)) return n.channel;
    return CHANNEL_NONE;
}

void read_block(pugi::xml_node block, Channel channel, const std::string& structure, Bsdf& out,
                const std::string& file) {
    const std::string direction = text_of(block, "WavelengthDataDirection");
    const std::string place = file + ": " + direction;
    BsdfTable* table = same(direction, "Transmission Back")    ? &out.transmission[0]
                       : same(direction, "Transmission Front") ? &out.transmission[1]
                       : same(direction, "Reflection Back")    ? &out.reflection[0]
                       : same(direction, "Reflection Front")   ? &out.reflection[1]
                                                               : nullptr;
    if (!table) fail(file, fmt::format("unknown <WavelengthDataDirection> \"{}\"", direction));
    const char* data = block.child_value("ScatteringData");
    if (same(structure, "TensorTree3") || same(structure, "TensorTree4")) {
        const std::string basis = text_of(block, "AngleBasis");
        if (!basis.empty() && !same(basis, "LBNL/Shirley-Chiu"))
            fail(place, fmt::format("unknown angle basis \"{}\"", basis));
        BsdfTree* tree = channel == CHANNEL_Y   ? &table->tree
                         : channel == CHANNEL_U ? &table->u
                         : channel == CHANNEL_V ? &table->v
                                                : nullptr;
        if (!tree) return;  // X and Z of a tensor are not used
        if (tree->dims) fail(place, "data stand twice");
        TreeReader(data, structure.back() - '0', place, *tree).read();
    } else {
        const bool columns = same(structure, "Columns");
        if (!columns && !same(structure, "Rows"))
            fail(file, fmt::format("unknown <IncidentDataStructure> \"{}\"", structure));
        const uint32_t column = find_basis(text_of(block, "ColumnAngleBasis"), out, place);
        const uint32_t row = find_basis(text_of(block, "RowAngleBasis"), out, place);
        const uint32_t incident = columns ? column : row, exit = columns ? row : column;
        std::vector<float>* m = channel == CHANNEL_Y   ? &table->y
                                : channel == CHANNEL_X ? &table->x
                                : channel == CHANNEL_Z ? &table->z
                                                       : nullptr;
        if (!m) return;
        if (!m->empty()) fail(place, "data stand twice");
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
    out.manufacturer = text_of(material, "Manufacturer");
    out.thickness = length_of(material, "Thickness", place);
    out.width = length_of(material, "Width", place);
    out.height = length_of(material, "Height", place);
    const pugi::xml_node definition = layer.child("DataDefinition");
    const std::string structure = text_of(definition, "IncidentDataStructure");
    for (pugi::xml_node basis : definition.children("AngleBasis")) read_basis(basis, out.bases, place);
    for (pugi::xml_node data : layer.children("WavelengthData")) {
        const Channel channel = channel_of(text_of(data, "Wavelength"));
        if (channel == CHANNEL_NONE) continue;  // solar, infrared
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

Bsdf read_bsdf(const std::string& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    if (!in) base::fail_system(path, "cannot be read");
    const auto size = in.tellg();
    if (size < 0) base::fail_system(path, "cannot be read");
    if (uint64_t(size) > MAX_FILE) fail(path, "BSDF files above 1 GB are not read");
    std::string text(size_t(size), '\0');
    in.seekg(0);
    in.read(text.data(), size);
    if (!in) base::fail_system(path, "cannot be read");
    return parse_bsdf(text, path);
}

}  // namespace scene
