// SPDX-License-Identifier: BSD-3-Clause
// read_scene(): files, octrees, meshes and the statements of scene text.
#include "scene/reader.h"
#include "base/error.h"
#include "base/file_status.h"
#include "base/find_file.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "scene/octree.h"
#include "scene/skies.h"
#include "scene/types.h"

namespace scene {

namespace {

bool is_mesh(base::TextReader& in) {
    return in.header_format() == "Radiance_tmesh" || base::ends_with(in.name(), ".obj");
}

// For messages: polygon "floor".
std::string described(const Primitive& p) {
    return std::string(type_name(p.type)) + " \"" + base::excerpt(p.name) + '"';
}

// Files that people take for scenes, by their first word.
void refuse_other_files(const base::TextReader& in, const std::string& first_word) {
    if (base::begins_with(first_word, "LOCATION,") || first_word == "place")
        base::fail(in.name(), "is a weather file, no scene: ptrace -wea takes it");
    if (first_word.find('=') != std::string::npos)
        base::fail(in.place(),
                   "\"" + base::excerpt(first_word) + "\" is of an input file of rad(1): ptrace -rif takes it");
}

}  // namespace

SceneReader::Deeper::Deeper(int& depth, int limit, const std::string& place) : depth_(depth) {
    if (depth >= limit) base::fail(place, "commands and files are nested more than " + std::to_string(limit) + " deep");
    ++depth_;
}

void SceneReader::read_file(const std::string& path, const std::string& asked_by) {
    base::TextReader in = base::TextReader::from_file(path, options_.opener(asked_by));
    const std::pair<uint64_t, uint64_t> id{in.device, in.inode};
    if (in.inode) {
        for (const auto& other : open_)
            if (other == id) base::fail(asked_by, "\"" + base::excerpt(path) + "\" includes itself");
        open_.push_back(id);
    }
    work_.spend(work_file, asked_by.empty() ? path : asked_by);
    content(in, path);
    work_.spend(in.bytes() / work_bytes, in.name());
    if (in.inode) open_.pop_back();
}

void SceneReader::content(base::TextReader& in, const std::string& path) {
    if (in.header_format() == "Radiance_octree") return octree(in);
    if (is_mesh(in)) return mesh(in, path);
    if (const std::string format = in.header_format(); !format.empty())
        base::fail(in.name(), "is not a scene: its header says FORMAT=" + base::excerpt(format));
    in.skip_space();
    if (in.peek() < 0) base::warn(in.name(), "an empty scene file");
    statements(in);
}

void SceneReader::statements(base::TextReader& in) {
    primitive_.file = builder_.file(in.name());
    for (;;) {
        in.skip_space();
        const int c = in.peek();
        if (c < 0) return;
        if (c == '#') {
            in.skip_line();
        } else if (c == '!') {
            command(in);
            primitive_.file = builder_.file(in.name());
        } else {
            primitive(in);
        }
    }
}

void SceneReader::read_statements(const std::string& text, const std::string& name, uint32_t line) {
    base::TextReader in = base::TextReader::from_text(text, name, line);
    statements(in);
}

// An unfrozen octree is a list of scene files; a frozen one holds the primitives.
void SceneReader::octree(base::TextReader& in) {
    const Deeper deeper(depth_, limits_.depth, in.name());
    Binary b(in);
    const Octree head = read_octree(b);
    scene_.history.insert(scene_.history.end(), head.history.begin(), head.history.end());
    if (head.files.empty()) {
        work_.spend(read_objects(b, head.index_size, head.objects, builder_).size(), in.name());
        return;
    }
    const uint64_t before = primitives_;
    const base::TextReader here = base::TextReader::from_text("", in.name(), 1);
    for (const std::string& file : head.files) {
        if (file[0] == '!') read_statements(file, in.name(), 1);
        else read_included(file, here);
    }
    if (primitives_ - before != uint64_t(head.objects))
        base::warn(in.name(), "the octree is older than its scene files; the files are used");
}

// A mesh file by itself is a mesh with the materials it names.
void SceneReader::mesh(const base::TextReader& in, const std::string& path) {
    Primitive& p = primitive_;
    p.type = Type::mesh;
    p.modifier = "void";
    const size_t slash = path.rfind('/') + 1;
    p.name = path.substr(slash, path.rfind('.') - slash);
    p.strings = {base::is_absolute(path) || path[0] == '.' ? path : "./" + path};  // not along RAYPATH
    p.reals.clear();
    p.file = builder_.file(in.name());
    p.line = 1;
    for (size_t i = transforms_.size(); i-- > 0;) apply(*transforms_[i], p);
    builder_.add(p);
}

void SceneReader::read_included(const std::string& name, const base::TextReader& from) {
    if (name == "-") base::fail(from.place(), "a command cannot read standard input");
    read_file(base::beside(name, from.place()), from.place());
}

long long SceneReader::count(base::TextReader& in, const char* what) {
    std::string_view word;
    const Primitive& p = primitive_;
    if (!in.word(word)) base::fail(in.place(), "the file ends within \"" + base::excerpt(p.name) + "\"");
    long long n;
    if (!base::parse_integer(word, n) || n < 0)
        base::fail(in.place(), described(p) + ": number of " + what + " expected, not \"" + base::excerpt(word) + "\"");
    return n;
}

void SceneReader::primitive(base::TextReader& in) {
    Primitive& p = primitive_;
    p.line = in.line();
    p.strings.clear();
    p.reals.clear();
    std::string_view word;
    in.word(word);
    p.modifier = word;
    if (!in.word(word)) base::fail(in.place(), "the file ends after \"" + base::excerpt(p.modifier) + "\"");
    if (!type_from_name(word, p.type)) {
        refuse_other_files(in, p.modifier);
        base::fail(in.place(), "unknown type \"" + base::excerpt(word) + "\"");
    }
    if (!in.word(word)) base::fail(in.place(), std::string("the file ends after \"") + type_name(p.type) + "\"");
    p.name = word;
    if (p.modifier.find('\t') != std::string::npos || p.name.find('\t') != std::string::npos)
        base::fail(in.place(), "a tab within the name \"" + base::excerpt(p.name) + "\"");
    auto end = [&]() { base::fail(in.place(), "the file ends within " + described(p)); };
    if (p.type == Type::alias) {
        if (!in.word(word)) end();
        p.strings.emplace_back(word);
    } else {
        for (long long n = count(in, "strings"); n > 0; n--) {
            if (!in.word(word)) end();
            p.strings.emplace_back(word);
        }
        if (count(in, "integers")) base::fail(in.place(), described(p) + " has integer arguments");
        double v;
        for (long long n = count(in, "reals"); n > 0; n--) {
            if (!in.word(word)) end();
            if (!base::parse_real(word, v))
                base::fail(in.place(), described(p) + ": \"" + base::excerpt(word) + "\" is not a number");
            p.reals.push_back(v);
        }
        const std::string fault = argument_fault(p.type, p.strings.size(), p.reals.size());
        if (!fault.empty()) base::fail(builder_.place(p), described(p) + " " + fault);
    }
    if (!is_surface(p.type) && (p.name == "void" || p.name == "inherit"))
        base::fail(builder_.place(p), "a modifier cannot be named \"" + p.name + "\"");
    for (size_t i = transforms_.size(); i-- > 0;) apply(*transforms_[i], p);
    if (!work_.spend(1)) work_.fail(builder_.place(p));
    builder_.add(p);
    primitives_++;
}

void read_more(Scene& scene, const std::vector<std::string>& files, const ReadOptions& options, const Limits& limits) {
    const size_t before = scene.objects.size();
    SceneReader reader(scene, options, limits);
    for (const std::string& file : files) {
        const bool is_text = file[0] == '!' || file.find('\n') != std::string::npos;
        if (is_text) reader.read_statements(file, "command line", 1);
        else reader.read_file(file, options.asked_by);
    }
    if (options.skies != Skies::any && before > 0) require_one_sky(scene, before);
}

Scene read_scene(const std::vector<std::string>& files, const ReadOptions& options, const Limits& limits) {
    Scene scene;
    read_more(scene, files, options, limits);
    if (options.skies == Skies::of_weather) require_no_sky(scene);
    if (options.skies == Skies::one) warn_of_two_skies(scene);
    return scene;
}

Scene read_scene_text(const std::string& text, const std::string& name) {
    Scene scene;
    SceneReader(scene, {}, {}).read_statements(text, name, 1);
    return scene;
}

}  // namespace scene
