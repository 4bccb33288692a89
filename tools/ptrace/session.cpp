// SPDX-License-Identifier: BSD-3-Clause
// See session.h.
#include "session.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/error.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "base/split.h"
#include "base/value.h"
#include "base/warnings.h"
#include "region/open.h"
#include "render/odd_eye.h"
#include "render/seen.h"

namespace {

using Commands = std::vector<render::Command>;

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds shortest_patience{1}, long_reading{2};

// Readings one after another, each given up for the next.
struct Readings {
    Clock::time_point since = Clock::now();
    bool said = false;  // that they take long
    // A preview's may take as long as all before it, so that one is shown however many edits come.
    Clock::time_point deaf_until() const {
        return Clock::now() + std::max<Clock::duration>(shortest_patience, Clock::now() - since);
    }
};

Run run_of(Options options) {
    Run run;
    run.opt = std::move(options);
    return run;
}

size_t pictures(const Options& opt) {
    const auto lit = std::count_if(opt.skies.begin(), opt.skies.end(), [](const Sky& s) { return !s.is_black(); });
    return (1 + opt.actions.size()) * opt.views.size() * (opt.skies.empty() ? 1 : size_t(lit));
}

void say(const std::string& line) { base::say("ptrace: " + line); }

// Files that are read for an edit are given up where others are asked for, or a signal came.  A page shows the line
// that is said where it takes long.
std::shared_ptr<base::WorkBudget> budget_of_edit(const Session& s, const std::shared_ptr<Readings>& readings) {
    const auto check = [&s, readings] {
        if (s.control.files_wait() || base::shutdown_requested()) throw base::GivenUp{};
        if (readings->said || !is_live(s.run.opt) || Clock::now() - readings->since < long_reading) return;
        readings->said = true;
        say(fmt::format("edit {}: reading the model", s.run.edits + 1));
    };
    return base::work_budget_from_environment(check);
}

// Reads what the edit asks for, and takes it over with its plan; true: the picture begins anew.  Throws Error, and
// GivenUp or Cancelled where more waits; all is as before then.
bool take(Session& s, Edited next, const Sky& sky, size_t i, const std::shared_ptr<Readings>& readings) {
    Options& opt = next.run.opt;
    base::Progress progress("ptrace");
    opt.files.work = budget_of_edit(s, readings);
    std::optional<render::SceneText> text;
    if (next.work == Work::files) {
        if (std::count(opt.scene_files.begin(), opt.scene_files.end(), "-"))
            base::fail("-", "the standard input cannot be read again");
        base::take_warnings();
        if (!opt.points_files.empty()) {
            read_points(opt);
            render::require_memory(opt.views[i].render_view);
        }
    }
    choose_focus(opt);
    if (next.work == Work::files)
        text = render::with_sky(render::read_room(opt.scene_files, opt.files, true), sky.file, opt.files);
    render::Setup setup = setup_of(opt, i, progress);
    setup.options.tell_limit = opt.render.ab != s.run.opt.render.ab;
    render::ViewPlan plan = render::plan_picture(*s.device, text ? *text : s.text, setup, s.plan);

    const bool begins = plan.fingerprint != s.plan.fingerprint;
    s.run = begins ? begun(std::move(next.run)) : gone_on(std::move(next.run));
    s.plan = std::move(plan);
    if (text) s.text = std::move(*text);
    return begins;
}

// Without those that ask for files, and the words of the edit.
Commands without_files(Commands commands) {
    const auto of_files = [](const render::Command& c) { return c.reads_files() || c.word == "note"; };
    commands.erase(std::remove_if(commands.begin(), commands.end(), of_files), commands.end());
    return commands;
}

// The files could not be rendered.  Those that were found, and those before, are watched; texts in place of files stay.
void keep_files(Session& s, const scene::ReadOptions& failed) {
    scene::ReadOptions& files = s.run.opt.files;
    base::note_files(*failed.read, base::noted_now(*files.read));
    files.read = failed.read;
    files.overlays = failed.overlays;
    s.control.watch(*files.read);
}

// "go" is an edit where the commands so far ask for a preview.
void add_waiting(Session& s, Commands& commands) {
    bool preview = s.run.opt.preview;
    for (const render::Command& c : commands)
        if (c.word != "note" && !c.reads_files()) preview = c.word == "preview";
    s.control.set_preview(preview);
    for (render::Command& c : s.control.take_edits()) commands.push_back(std::move(c));
}

}  // namespace

Session::Session(Options options)
    : run(run_of(std::move(options))),
      control(run.opt.control, run.opt.watch),
      report(run.opt.report_s, pictures(run.opt)) {}

render::Setup setup_of(const Options& opt, size_t i, base::Progress& progress) {
    render::Setup setup{opt.views[i].render_view, opt.render, opt.files};
    setup.options.tell_tree = [&](double share) {
        if (progress.due()) progress.show(fmt::format("builds the tree of all surfaces, {:.0f} %", 100 * share));
    };
    return opt.preview ? render::preview_of(setup) : setup;
}

void choose_focus(Options& opt) {
    if (opt.focus_file.empty()) return;
    image::DrawRegions draw;
    image::MaskSet masks = region::open(opt.focus_file, draw, region::Check::empty, false, opt.files.read.get());
    for (auto& [name, v] : opt.views) {
        if (draw) masks = draw(v.view, v.nx, v.ny);
        v.focus = render::focus_on(masks, v.nx, v.ny, opt.focus_share, opt.focus_file);
        if (v.focus.empty())
            base::warn(opt.focus_file,
                       "its regions are so large, or -focus-share so small, that none of their pixels gets a "
                       "second sample");
    }
}

bool carry_out(Session& s, Commands commands, const Sky& sky, size_t i) {
    bool told = false;  // the failure
    const auto readings = std::make_shared<Readings>();
    for (size_t said = 0;; add_waiting(s, commands)) {
        Edited next = edited(s.run, commands, i);
        for (; said < next.refused.size(); ++said) say(next.refused[said]);
        if (next.work == Work::nothing) return s.run = std::move(next.run), false;
        const bool reads = next.work == Work::files;
        scene::ReadOptions& files = next.run.opt.files;
        if (reads) files.read = std::make_shared<base::FilesRead>();
        const scene::ReadOptions how = files;
        const std::string note = next.run.note;
        const bool mended = reads && !s.failure.empty();
        const auto deaf_until = next.run.opt.preview ? readings->deaf_until() : Clock::time_point();
        s.control.set_preview(next.run.opt.preview, deaf_until, files.overlays);
        try {
            const bool begins = take(s, std::move(next), sky, i, readings);
            if (reads) s.failure.clear();
            if (!begins && s.failure.empty() && !s.run.opt.preview && (mended || !note.empty()))
                say("same " + std::to_string(s.run.edits) + " " + note);  // whoever asked waits for no picture
            s.control.set_preview(s.run.opt.preview, deaf_until);
            s.control.watch(*s.run.opt.files.read);
            if (begins && !told && !s.run.opt.preview && !s.failure.empty()) say(s.failure);
            return begins;
        } catch (const base::GivenUp&) {
        } catch (const device::Cancelled&) {
        } catch (const base::Error& e) {
            say(e.text);
            if (!reads) return s.control.set_preview(s.run.opt.preview), false;
            s.failure = e.text, told = true;
            keep_files(s, how);
            commands = without_files(std::move(commands));
            said = edited(s.run, commands, i).refused.size();
        }
        if (base::shutdown_requested()) return false;
    }
}

// Once for each view, with its first picture of the run.
void warn_of_odd_eye(Session& s, size_t i) {
    const view::View& v = s.plan.view;
    if (!s.eyes_looked_at.insert(i).second || s.run.opt.views[i].render_view.points || v.type == 'l') return;
    const std::string odd = render::odd_about_eye(*s.plan.scene.tables, v.vp), name = s.run.opt.views[i].name;
    if (!odd.empty()) base::warn(name.empty() ? "-vp" : "view " + name, odd);
}

void plan_first(Session& s, const Sky& sky, size_t i) {
    const bool is_first = s.plan.fingerprint.empty();
    for (bool planned = false; !planned && !base::shutdown_requested();) {
        base::Progress progress("ptrace");
        render::Setup setup = setup_of(s.run.opt, i, progress);
        setup.reading.work = budget_of_edit(s, std::make_shared<Readings>());
        setup.options.tell_limit = is_first;
        try {
            s.plan = render::plan_picture(*s.device, s.text, setup, s.plan);
            planned = true;
        } catch (const base::GivenUp&) {
        } catch (const device::Cancelled&) {}
        Commands commands;
        if (!planned) add_waiting(s, commands), planned = carry_out(s, std::move(commands), sky, i);
    }
    if (!s.plan.fingerprint.empty()) warn_of_odd_eye(s, i);
}

void answer_what(const Session& s, const std::string& rest) {
    try {
        const std::vector<std::string> words = base::split_words(rest);
        const std::string place = s.run.opt.control;
        if (words.size() != 2) base::fail(place, "what: needs two fractions of the picture");
        const double x = base::to_real(words[0], place), y = base::to_real(words[1], place);
        const std::string seen = render::seen_at(s.plan.scene, s.text.scene, s.plan.view, x, y);
        say("what " + words[0] + " " + words[1] + "\t" + std::to_string(s.run.edits) + "\t" + seen);
    } catch (const base::Error& e) {
        say(e.text);
    }
}
