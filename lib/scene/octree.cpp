// SPDX-License-Identifier: BSD-3-Clause
// Reading octrees.
#include "scene/octree.h"
#include "base/error.h"
#include "base/printable.h"
#include "base/split.h"
#include "scene/types.h"

namespace scene {

int read_magic(Binary& in, int magic, const char* what) {
    const int size = int(in.integer(2)) - magic;
    if (size != 2 && size != 4 && size != 8) in.fail(std::string("not ") + what + " of RADIANCE 4 to 6");
    return size;
}

// Nodes in pre-order: 0 empty, 1 leaf with a set of objects, 2 eight children.  Only the number of open nodes matters.
void skip_tree(Binary& in, int index_size) {
    for (uint64_t open = 1; open > 0; open--) {
        const int node = in.byte();
        if (node == 2) {
            open += 8;
        } else if (node == 1) {
            const int64_t n = in.integer(index_size);
            if (n < 0) in.fail("a leaf with a negative number of objects");
            for (int64_t i = 0; i < n; i++) in.skip(index_size);
        } else if (node != 0) {
            in.fail("damaged tree (node type " + std::to_string(node) + ")");
        }
    }
}

Octree read_octree(Binary& in) {
    Octree o;
    for (const std::string& line : in.header())
        if (!base::begins_with(line, "#?") && !base::begins_with(line, "FORMAT=")) o.history.push_back(line);
    const int size = o.index_size = read_magic(in, octree_magic, "an octree");
    for (int i = 0; i < 4; i++) in.text_real();  // bounding cube
    for (std::string name; !(name = in.text()).empty();) {
        o.files.push_back(name);
        if (o.files.size() > 100000) in.fail("more than 100000 scene files");
    }
    o.objects = in.integer(size);
    if (o.objects < 0) in.fail("a negative number of objects");
    skip_tree(in, size);
    return o;
}

std::vector<int32_t> read_objects(Binary& in, int index_size, int64_t expected, SceneBuilder& builder) {
    struct TypeName {
        std::string name;
        Type type;
        bool known;
    };
    std::vector<TypeName> types;
    for (std::string name; !(name = in.text()).empty();) {
        TypeName t{name, Type::count, false};
        t.known = type_from_name(name, t.type);
        types.push_back(t);
        if (types.size() > 255) in.fail("more than 255 types");
    }
    std::vector<int32_t> index;
    if (expected > 0) builder.make_room(uint64_t(expected), in.source().size);
    Primitive p;
    p.file = builder.file(in.source().name());
    for (;;) {
        const int type = in.byte();
        if (type == 0xff) break;
        if (type >= int(types.size())) in.fail("damaged object table (type " + std::to_string(type) + ")");
        if (!types[type].known) in.fail("unknown type \"" + base::excerpt(types[type].name) + "\"");
        p.type = types[type].type;
        const int64_t modifier = in.integer(index_size);
        if (modifier >= int64_t(index.size()) || modifier < -1) in.fail("an object that comes before its modifier");
        p.modifier_object = modifier < 0 ? VOID : index[modifier];
        p.name = in.text();
        p.strings.clear();
        p.reals.clear();
        for (uint64_t n = in.unsigned_integer(2); n > 0; n--) p.strings.push_back(in.text());
        for (uint64_t n = in.unsigned_integer(2); n > 0; n--) p.reals.push_back(in.real());
        if (modifier >= 0 && (p.modifier_object == VOID || is_surface(builder.type(p.modifier_object))))
            in.fail("\"" + base::excerpt(p.name) + "\" has a surface as its modifier");
        if (p.type != Type::alias) {
            const std::string fault = argument_fault(p.type, p.strings.size(), p.reals.size());
            if (!fault.empty()) in.fail(std::string(type_name(p.type)) + " \"" + base::excerpt(p.name) + "\" " + fault);
        }
        p.line = uint32_t(index.size() + 1);  // "room.oct:17" is the 17th object
        index.push_back(builder.add(p));
    }
    if (expected >= 0 && expected != int64_t(index.size()))
        in.fail("holds " + std::to_string(index.size()) + " objects but announces " + std::to_string(expected));
    return index;
}

}  // namespace scene
