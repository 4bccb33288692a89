// SPDX-License-Identifier: BSD-3-Clause
// read_scene(): statements of scene text, and the "!commands" between them.  A command is a pipe of stages; xform
// stages act on what comes out of the stage before them, generators write text, anything else needs -exec.
#include <algorithm>
#include <memory>
#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/shell.h"
#include "scene/builder.h"
#include "generators/generators.h"
#include "scene/octree.h"
#include "scene/shell_words.h"
#include "base/text_reader.h"
#include "scene/transform.h"
#include "scene/types.h"

namespace scene {

namespace {

constexpr size_t text_limit = size_t(1) << 30;                        // of one command's output
constexpr size_t definitions_limit = size_t(1) << 26;                 // of an xform -f file
constexpr uint64_t bytes_a_step = 1000, opened_file = 10, copy = 10;  // of base::Work

class Reader {
public:
    Reader(Scene& scene, const ReadOptions& options, const Limits& limits)
        : scene_(scene), options_(options), limits_(limits), work_(*options.work), builder_(scene, limits) {}
    void read_file(const std::string& path, const std::string& asked_by);
    void read_command(const std::string& text, const std::string& name, uint32_t line);  // "!..." as in a scene file

private:
    void content(base::TextReader& in, const std::string& path);
    void statements(base::TextReader& in);
    void octree(base::TextReader& in);
    void mesh(const base::TextReader& in, const std::string& path);
    void primitive(base::TextReader& in);
    void command(base::TextReader& in);
    void run(const CommandLine& line, const std::string& text, size_t stage, const base::TextReader& from);
    void read_text(const std::string& text, const base::TextReader& from);
    void read_included(const std::string& name, const base::TextReader& from);
    std::string run_shell(const std::string& text, const std::string& place) const;
    long long count(base::TextReader& in, const char* what);

    Scene& scene_;
    const ReadOptions& options_;
    const Limits& limits_;
    base::Work& work_;
    Builder builder_;
    Primitive primitive_;
    std::vector<const Transform*> transforms_;         // innermost last
    std::vector<std::pair<uint64_t, uint64_t>> open_;  // device and inode of the files being read
    int depth_ = 0;
    uint64_t primitives_ = 0;
};

bool is_mesh(base::TextReader& in) {
    const std::string& name = in.name();
    return in.header_format() == "Radiance_tmesh" || (name.size() > 4 && name.compare(name.size() - 4, 4, ".obj") == 0);
}

struct Deeper {
    Deeper(int& depth, int limit, const std::string& place) : depth_(depth) {
        if (depth >= limit)
            base::fail(place, "commands and files are nested more than " + std::to_string(limit) + " deep");
        ++depth_;
    }
    ~Deeper() { --depth_; }
    int& depth_;
};

void Reader::read_file(const std::string& path, const std::string& asked_by) {
    base::TextReader in = base::TextReader::from_file(path, asked_by);
    const std::pair<uint64_t, uint64_t> id{in.device, in.inode};
    if (in.inode) {
        for (const auto& other : open_)
            if (other == id) base::fail(asked_by, "\"" + base::excerpt(path) + "\" includes itself");
        open_.push_back(id);
    }
    work_.spend(opened_file, asked_by.empty() ? path : asked_by);
    content(in, path);
    work_.spend(in.bytes() / bytes_a_step, in.name());
    if (in.inode) open_.pop_back();
}

void Reader::content(base::TextReader& in, const std::string& path) {
    if (in.header_format() == "Radiance_octree") return octree(in);
    if (is_mesh(in)) return mesh(in, path);
    in.skip_space();
    if (in.peek() < 0) base::warn(in.name(), "an empty scene file");
    statements(in);
}

void Reader::statements(base::TextReader& in) {
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

void Reader::read_command(const std::string& text, const std::string& name, uint32_t line) {
    base::TextReader in = base::TextReader::from_text(text, name, line);
    statements(in);
}

// An unfrozen octree is a list of scene files; a frozen one holds the primitives.
void Reader::octree(base::TextReader& in) {
    const Deeper deeper(depth_, limits_.depth, in.name());
    Binary b(in);
    const Octree head = read_octree(b);
    if (head.files.empty()) {
        work_.spend(read_objects(b, head.index_size, head.objects, builder_).size(), in.name());
        return;
    }
    const uint64_t before = primitives_;
    const base::TextReader here = base::TextReader::from_text("", in.name(), 1);
    for (const std::string& file : head.files) {
        if (file[0] == '!') read_command(file, in.name(), 1);
        else read_included(file, here);
    }
    if (primitives_ - before != static_cast<uint64_t>(head.objects))
        base::warn(in.name(), "the octree is older than its scene files; the files are what is used");
}

// A mesh file by itself is a mesh with the materials it names.
void Reader::mesh(const base::TextReader& in, const std::string& path) {
    Primitive& p = primitive_;
    p.type = Type::mesh;
    p.modifier = "void";
    const size_t slash = path.rfind('/') + 1;
    p.name = path.substr(slash, path.rfind('.') - slash);
    p.strings = {path[0] == '/' || path[0] == '.' ? path : "./" + path};  // not along RAYPATH
    p.reals.clear();
    p.file = builder_.file(in.name());
    p.line = 1;
    for (size_t i = transforms_.size(); i-- > 0;) apply(*transforms_[i], p);
    builder_.add(p);
}

long long Reader::count(base::TextReader& in, const char* what) {
    std::string_view word;
    const Primitive& p = primitive_;
    if (!in.word(word)) base::fail(in.place(), "the file ends within \"" + base::excerpt(p.name) + "\"");
    long long n;
    if (!base::parse_integer(word, n) || n < 0)
        base::fail(in.place(), std::string(type_name(p.type)) + " \"" + base::excerpt(p.name) + "\": number of " +
                                   what + " expected, not \"" + base::excerpt(word) + "\"");
    return n;
}

void Reader::primitive(base::TextReader& in) {
    Primitive& p = primitive_;
    p.line = in.line();
    p.strings.clear();
    p.reals.clear();
    std::string_view word;
    in.word(word);
    p.modifier = word;
    if (!in.word(word)) base::fail(in.place(), "the file ends after \"" + base::excerpt(p.modifier) + "\"");
    if (!type_from_name(word, p.type)) base::fail(in.place(), "unknown type \"" + base::excerpt(word) + "\"");
    if (!in.word(word)) base::fail(in.place(), std::string("the file ends after \"") + type_name(p.type) + "\"");
    p.name = word;
    if (p.modifier.find('\t') != std::string::npos || p.name.find('\t') != std::string::npos)
        base::fail(in.place(), "a tab within the name \"" + base::excerpt(p.name) + "\"");
    auto end = [&]() {
        base::fail(in.place(),
                   "the file ends within " + std::string(type_name(p.type)) + " \"" + base::excerpt(p.name) + "\"");
    };
    if (p.type == Type::alias) {
        if (!in.word(word)) end();
        p.strings.emplace_back(word);
    } else {
        for (long long n = count(in, "strings"); n > 0; n--) {
            if (!in.word(word)) end();
            p.strings.emplace_back(word);
        }
        if (count(in, "integers"))
            base::fail(in.place(),
                       std::string(type_name(p.type)) + " \"" + base::excerpt(p.name) + "\" has integer arguments");
        double v;
        for (long long n = count(in, "reals"); n > 0; n--) {
            if (!in.word(word)) end();
            if (!base::parse_real(word, v))
                base::fail(in.place(), std::string(type_name(p.type)) + " \"" + base::excerpt(p.name) + "\": \"" +
                                           base::excerpt(word) + "\" is not a number");
            p.reals.push_back(v);
        }
        const std::string fault = argument_fault(p.type, p.strings.size(), p.reals.size());
        if (!fault.empty())
            base::fail(builder_.place(p),
                       std::string(type_name(p.type)) + " \"" + base::excerpt(p.name) + "\" " + fault);
    }
    if (!is_surface(p.type) && (p.name == "void" || p.name == "inherit"))
        base::fail(builder_.place(p), "a modifier cannot be named \"" + p.name + "\"");
    for (size_t i = transforms_.size(); i-- > 0;) apply(*transforms_[i], p);
    if (!work_.spend(1)) work_.fail(builder_.place(p));
    builder_.add(p);
    primitives_++;
}

void Reader::command(base::TextReader& in) {
    const Deeper deeper(depth_, limits_.depth, in.place());
    const uint32_t line = in.line();
    in.get();  // the "!"
    const std::string text = in.rest_of_line();
    // What the command writes counts as this line.
    const base::TextReader here = base::TextReader::from_text("", in.name(), line);
    const CommandLine parsed = split_command(text, here.place());
    if (parsed.stages.size() == 1 && parsed.stages[0].words.empty()) return;
    if (parsed.stages.size() > 100) base::fail(here.place(), "a pipe of more than 100 commands");
    run(parsed, text, parsed.stages.size(), here);
}

// Reads the output of the first `stage` stages.
void Reader::run(const CommandLine& line, const std::string& text, size_t stage, const base::TextReader& from) {
    const Stage& last = line.stages[stage - 1];
    if (last.words.empty()) base::fail(from.place(), "an empty command in a pipe");
    const std::string& name = last.words[0];
    if (!line.needs_shell && name == "xform") {
        XformCommand x = parse_xform_command(last.words, from.place());
        if (x.files.empty() && !last.input.empty()) x.files = {last.input};
        if (x.files.empty() && stage == 1) base::fail(from.place(), "xform: no file to transform");
        each_copy(
            x, from.place(), limits_.copies,
            [&](const std::string& file) {
                const std::string path = base::beside(file, from.name());
                base::TextReader s = base::TextReader::from_file(path, from.place());
                std::string all;
                for (int c; (c = s.get()) >= 0 && all.size() < definitions_limit;) all += static_cast<char>(c);
                work_.spend(opened_file + all.size() / bytes_a_step, from.place());
                return all;
            },
            [&](const Transform& t) {
                work_.spend(copy, from.place());
                transforms_.push_back(&t);
                if (x.files.empty()) run(line, text, stage - 1, from);
                for (const std::string& file : x.files) read_included(file, from);
                transforms_.pop_back();
            });
    } else if (!line.needs_shell && name == "cat") {
        if (last.words.size() == 1 && stage == 1 && last.input.empty()) base::fail(from.place(), "cat: no file");
        if (last.words.size() == 1 && stage > 1) run(line, text, stage - 1, from);
        else if (last.words.size() == 1) read_included(last.input, from);
        for (size_t i = 1; i < last.words.size(); i++) read_included(last.words[i], from);
    } else if (const auto generate = line.needs_shell || stage > 1 ? nullptr : generators::find(name)) {
        std::string out;
        generate(generators::Call{last.words, last.input, from.name(), from.place(), options_,
                                  static_cast<long long>(std::min<uint64_t>(limits_.copies, 1000000))},
                 out);
        read_text(out, from);
    } else if (options_.exec) {
        read_text(run_shell(text.substr(0, last.end), from.place()), from);
    } else if (line.needs_shell) {
        base::fail(from.place(), "\"!" + base::excerpt(text) + "\" needs a shell (" + line.needs_shell +
                                     "), which -exec would allow");
    } else {
        base::fail(from.place(),
                   "command \"" + base::excerpt(name) + "\" is not built in; -exec would allow to run it");
    }
}

void Reader::read_text(const std::string& text, const base::TextReader& from) {
    work_.spend(opened_file + text.size() / bytes_a_step, from.place());
    base::TextReader in = base::TextReader::from_text(text, from.name(), from.line());
    statements(in);
}

void Reader::read_included(const std::string& name, const base::TextReader& from) {
    if (name == "-") base::fail(from.place(), "a command cannot read standard input");
    read_file(base::beside(name, from.name()), from.place());
}

std::string Reader::run_shell(const std::string& text, const std::string& place) const {
    base::ShellOutput out = base::run_shell(text, text_limit, place);
    if (out.too_long) base::fail(place, "\"" + base::excerpt(text) + "\" writes more than 1 GB");
    if (out.status != 0)
        base::warn(place, "\"" + base::excerpt(text) + "\" ended with status " + std::to_string(out.status));
    return std::move(out.text);
}

}  // namespace

Scene read_scene(const std::vector<std::string>& files, const ReadOptions& options, const Limits& limits) {
    Scene scene;
    Reader reader(scene, options, limits);
    for (const std::string& file : files) {
        if (file[0] == '!') reader.read_command(file, "command line", 1);
        else reader.read_file(file, "");
    }
    return scene;
}

}  // namespace scene
