// SPDX-License-Identifier: BSD-3-Clause
// Loading of function files and the look-up of names.
#include "cal/library.h"
#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>
#include "base/error.h"
#include "base/split.h"

namespace cal {

namespace {
constexpr size_t max_file = size_t(4) << 20;  // function files; trees take a hundred times the text

std::string context_of(const std::string& file) {  // "skies/my sky.cal" -> "my_sky"
    std::string name = file.substr(file.find_last_of('/') + 1);
    if (base::ends_with(name, ".cal")) name.resize(name.size() - 4);
    for (char& c : name)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.'))
            c = '_';
    return name;
}

// "x`ctx." -> base x, context ctx; false if there is no mark in the name
bool split_context(const std::string& name, std::string& base, std::string& context) {
    const size_t mark = name.find('`');
    if (mark == std::string::npos) return false;
    base = name.substr(0, mark);
    context = name.substr(mark + 1);
    if (!context.empty() && context.back() == '.') context.pop_back();
    return true;
}
}  // namespace

std::string read_text(const std::string& path, size_t limit, const base::Opener& by) {
    const std::string& place = by.place;
    FILE* file = fdopen(base::open_file(path, by), "rb");
    if (!file) base::fail_system(place, "cannot open \"" + path + "\"");
    std::string text;
    char block[65536];
    size_t n;
    while ((n = std::fread(block, 1, sizeof block, file)) > 0 && text.size() <= limit) text.append(block, n);
    const bool bad = std::ferror(file) != 0;
    std::fclose(file);
    if (bad) base::fail_system(place, "cannot read \"" + path + "\"");
    if (text.size() > limit) base::fail(place, "file \"" + path + "\" is too large");
    return text;
}

Library::Library(const base::ReadOptions& files) : state_(new State) {
    state_->files = files;
    state_->add(rayinit_text, "rayinit.cal", "", false);
    for (const std::string& file : files.cal_files) define_file(file, "-f");
}
Library::~Library() = default;

void Library::define(const std::string& text, const std::string& place) { state_->add(text, place, "", true); }

void Library::define_file(const std::string& file, const std::string& place) {
    state_->add_global_file(file, place, true);
}

// `e` with these names, unless they are parameters, as global ones.
static const Expr* with_globals(const Expr* e, const std::set<std::string>& names,
                                const std::vector<std::string>& parameters, Pool& pool) {
    Expr copy = *e;
    bool changed = false;
    for (const Expr*& kid : copy.kids) {
        const Expr* old = std::exchange(kid, with_globals(kid, names, parameters, pool));
        changed = changed || kid != old;
    }
    const bool is_name = e->kind == Expr::Kind::name || e->kind == Expr::Kind::call;
    if (is_name && names.count(e->name) && std::find(parameters.begin(), parameters.end(), e->name) == parameters.end())
        copy.name += '`', changed = true;
    if (!changed) return e;
    Expr* made = pool.make(e->kind);
    *made = std::move(copy);
    return made;
}

// As in RADIANCE, a name means what it means where it is read: "v = A1; A1 = 5;" gives v the primitive's A1.
void Library::State::bind(std::vector<Definition>& list, const std::string& context) {
    std::set<std::string> later;  // global so far, and not yet the file's
    for (const Definition& d : list)
        if (contexts[""].count(d.name) && !contexts[context].count(d.name)) later.insert(d.name);
    for (Definition& d : list) {
        if (later.empty()) return;
        d.body = with_globals(d.body, later, d.parameters, pool);
        later.erase(d.name);
    }
}

void Library::State::add(std::string_view text, const std::string& file, const std::string& context, bool warn) {
    std::vector<Definition> list = parse_definitions(text, file, pool);
    if (!context.empty()) bind(list, context);
    for (Definition& def : list) {
        std::string base, own;
        def.context = context;
        if (split_context(def.name, base, own)) {
            if (base.empty()) def.name = own;  // `x: in this context anyway
            else {
                def.name = base;
                def.context = own;
            }
        }
        auto& names = contexts[def.context];
        const auto old = names.find(def.name);
        if (warn && old != names.end()) base::warn(def.place, "\"" + def.name + "\" is defined again");
        const std::string key = def.name;
        names[key] = std::move(def);
    }
}

void Library::State::add_file(const std::string& file, const std::string& path, const std::string& context,
                              const std::string& place, bool warn) {
    if (!path.empty()) return add(read_text(path, max_file, files.opener(place)), path, context, warn);
    const bool has_ending = base::ends_with(file, ".cal");
    const char* text = builtin_file(has_ending ? file : file + ".cal");
    if (!text) base::fail(place, "cannot find function file \"" + file + "\"");
    add(text, file, context, false);
}

std::string Library::State::load(const std::string& file, const std::string& place) {
    if (file == ".") return "";
    const std::string path = base::look_for_file(file, files, place);
    const auto [found, fresh] = loaded.emplace(path.empty() ? file : path, context_of(file));
    std::string& context = found->second;
    if (!fresh) return context;
    // Files of one name in two folders: the later one's definitions have a context that no name can mean.
    const auto taken = [&](const auto& other) { return &other.second != &context && other.second == context; };
    while (std::any_of(loaded.begin(), loaded.end(), taken)) context += '+';
    try {
        add_file(file, path, context, place, true);
    } catch (...) {
        loaded.erase(found);
        throw;
    }
    return context;
}

const Definition* Library::State::lookup(const std::string& name, const std::string& context) const {
    auto in = [&](const std::string& where, const std::string& what) -> const Definition* {
        const auto c = contexts.find(where);
        if (c == contexts.end()) return nullptr;
        const auto d = c->second.find(what);
        return d == c->second.end() ? nullptr : &d->second;
    };
    std::string base, own;
    if (split_context(name, base, own)) {
        if (base.empty()) return in(context, own);
        return in(own, base);
    }
    if (const Definition* d = in(context, name)) return d;
    return context.empty() ? nullptr : in("", name);
}

}  // namespace cal
