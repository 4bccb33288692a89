// SPDX-License-Identifier: BSD-3-Clause
// See edits.h.
#include "edits.h"

#include <algorithm>

#include "base/error.h"
#include "base/printable.h"
#include "base/split.h"
#include "declare.h"

namespace {

// Throws Error for what is no command, with the options as they were.
void edit(const render::Command& c, size_t picture, Options& opt) {
    const std::string place = opt.control.empty() ? "-watch" : opt.control;
    if (opt.first != 0)
        base::fail(place, "a picture that is edited begins with frame 0, not " + std::to_string(opt.first));
    std::vector<std::string> words = base::split_words(c.rest);
    if (c.word == "scene" && words.empty()) return;  // nothing but the files
    if (c.word == "overlay" && c.text) {
        if (opt.files.exec) base::fail(place, "with -exec no text may replace a file: it could run programs");
        return void(opt.files.overlays = base::with_overlay(opt.files.overlays, c.rest, *c.text));
    }
    if (c.word == "overlay" && words.size() > 1 && words.back() == "-")
        return void(opt.files.overlays = base::without_overlay(opt.files.overlays, c.file()));
    if (c.word == "size" && words.size() == 2) words = {"-x", words[0], "-y", words[1]};
    else if (c.word != "view" && c.word != "set" && c.word != "preview" && c.word != "go")
        base::fail(place, "\"" + base::excerpt(c.word + " " + c.rest) + "\" is not a command");
    Options next = opt;
    next.view = next.views[picture].render_view.view;
    std::optional<scene::RadInput> rad_input;
    base::OptionTable table;
    declare_options(table, next, rad_input, {});
    table.read_scene_words(words, place);
    if (c.word == "preview" && (next.nx != opt.nx || next.ny != opt.ny))
        base::fail(place, "a preview has a size of its own; \"size X Y\" is for the picture");
    render::RenderView v{next.view, next.nx, next.ny};
    view::fit_size(v.view, next.pixel_aspect, v.nx, v.ny);
    view::validate(v.view);
    if (opt.views[picture].render_view.points) {
        if (c.word != "set" && c.word != "go")
            base::fail(place, "\"" + c.word + "\" changes a view, and points have none");
        v = opt.views[picture].render_view;
    }
    render::require_memory(v);
    next.views[picture].render_view = v;
    next.preview = c.word == "preview";
    opt = next;
}

}  // namespace

Edited edited(Run run, const std::vector<render::Command>& commands, size_t picture) {
    Edited out{std::move(run), Work::nothing, {}};
    for (const render::Command& c : commands) {
        if (c.word == "note") {
            out.run.note = c.rest;
            continue;
        }
        try {
            edit(c, picture, out.run.opt);
            out.run.last = c.word;
            if (c.word != "go" && c.word != "preview") out.run.changed = c.word;
            out.work = std::max(out.work, c.reads_files() ? Work::files : Work::view);
        } catch (const base::Error& e) {
            out.refused.push_back(e.text);
        }
    }
    return out;
}

Run gone_on(Run run) {
    if (!run.opt.preview) run.note.clear();
    return run;
}

Run begun(Run run) {
    run.edits++;
    run.edited = run.opt.preview ? "preview" : run.last;
    if (run.last == "go") run.edited = run.changed.empty() ? "view" : run.changed;
    if (run.opt.preview) return run;
    if (!run.note.empty()) run.edited += " " + run.note;
    run.changed.clear();
    run.note.clear();
    return run;
}
