// SPDX-License-Identifier: BSD-3-Clause
// vcmetrics' command line: read, and what does not go together.  The options are in declare.cpp.
#include "options.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "base/file_status.h"
#include "base/files_read.h"
#include "base/run.h"
#include "base/text_file.h"
#include "base/warnings.h"
#include "base/model_folder.h"
#include "declare.h"
#include "glare/actions.h"
#include "image/stream.h"

namespace {
void expand_globs(std::vector<std::string>& files) {
    std::vector<std::string> out;
    for (const std::string& f : files) {
        std::vector<std::string> found;
        if (f.find_first_of("*?[") != std::string::npos && base::status_of(f).kind == base::FileKind::none)
            found = base::files_like(f);
        if (found.empty()) found = {f};
        out.insert(out.end(), found.begin(), found.end());
    }
    files.swap(out);
}

// A view on the command line starts afresh, so that its type and both sizes must be given.
bool says_view(const base::OptionTable& t) {
    const auto& said = t.parsed();
    const bool any = std::any_of(said.begin(), said.end(),
                                 [](const auto& s) { return s.option->group() == "View" && s.option->name != "-vf"; });
    if (any && !(t.given("-vt") && t.given("-vh") && t.given("-vv")))
        base::fail("view", "a view on the command line replaces the picture's own and needs at least -vt, -vh and -vv");
    return any;
}

void check_said(const base::OptionTable& t, const Options& o) {
    if (t.given("-metrics") && o.metrics.empty()) base::fail("-metrics", "there is no column in this list");
    if (t.given("-until") && o.until.empty())
        base::fail("-until", "the rule is empty; write for example 'DGP 1%, Ev 0.5% or 0.1'");
}

// Refuses options that need intervals of luxpipe's own columns.
void check_intervals(const Options& o) {
    const bool against = !o.against.empty();
    const bool difference = o.difference && !o.tolerances;
    if (!o.ci && !against && !difference && o.until.empty()) return;
    const char* const option = o.ci ? "-ci" : against ? "-against" : difference ? "-difference" : "-until";
    if (o.mode != OutputMode::vcmetrics || o.list_sources)
        base::fail(option, "works on vcmetrics' own columns and cannot be used with -like or -sources");
    if (o.settings.field_cut || o.settings.fill)
        base::fail(option, "needs the whole picture as it is and cannot be used with -G or -I");
}

// Of an action: mEDI, not mDER.
bool is_illuminance(const std::string& name) {
    const auto action = glare::action_column(name);
    return action && action->name == action->action;
}

void check(const Options& o) {
    if (o.settings.mask_file && o.settings.zones) base::fail("-A", "a mask and zones (-l, -L) cannot be used together");
    if (o.mode != OutputMode::vcmetrics && !o.difference && (o.list_sources || !o.metrics.empty()))
        base::fail("-like", "prints its own columns and cannot be used with -metrics or -sources");
    if (o.mode != OutputMode::vcmetrics && !o.until.empty())
        base::fail("-until", "works on vcmetrics' own columns and cannot be used with -like");
    const bool of_actions = std::all_of(o.metrics.begin(), o.metrics.end(), is_illuminance);
    if ((o.like_rtrace && !o.metrics.empty()) || (o.each && !of_actions))
        base::fail("-metrics", "are of grids as a whole, and cannot be used with -each or -like rtrace, of each point");
    if (o.list_sources && !o.until.empty()) base::fail("-until", "works on metrics and cannot be used with -sources");
    check_intervals(o);
    if (o.last && (!o.until.empty() || o.max_frames || o.max_seconds || o.difference))
        base::fail("-last", "cannot be used with -until, -max-frames, -max-seconds or -difference");
    if (!o.control.empty() && o.until.empty() && !o.max_frames)
        base::fail("-control", "needs -until or -max-frames, which say when a picture ends");
    if (!o.control.empty() && !o.files.empty()) base::fail("-control", "works on a stream, not on files");
    if (o.outlines && !(o.list_sources && o.format == report::TableFormat::jsonl))
        base::fail("-outlines", "belongs to -sources and -format jsonl");
    const std::string over = image::ending_of(o.over_file);
    if (!o.over_file.empty() && ((over != ".png" && over != ".svg") || o.mode != OutputMode::vcmetrics))
        base::fail("-over", "writes a .png of vcmetrics' own columns, or a .svg of points");
    if (!o.report_file.empty()) {
        const bool own = o.mode == OutputMode::vcmetrics && !o.list_sources && !o.difference;
        if (image::ending_of(o.report_file) != ".html" || !own)
            base::fail("-report", "writes an .html file of vcmetrics' own columns");
        image::require_writable_ending(o.report_file, {".html"});
        if (!o.plan_map.empty() && image::ending_of(o.plan_map) != ".svg")
            base::fail("-plan", "takes a map of vcmetrics -over, an .svg file, and a table of numbers");
        for (const std::string& file : o.scene)
            if (!base::may_read(file)) base::fail_system(file, "cannot be read");
    } else if (!o.scene.empty() || !o.numbers_file.empty() || !o.overlays.empty() || !o.plan_map.empty()) {
        base::fail("-scene, -numbers, -overlay, -plan", "belong to -report");
    }
    std::vector<std::string> inputs = o.files.empty() ? std::vector<std::string>{"-"} : o.files;
    inputs.insert(inputs.end(), {o.regions_file, o.settings.mask_file.value_or(""), o.against});
    inputs.insert(inputs.end(), o.scene.begin(), o.scene.end());
    inputs.insert(inputs.end(), o.points_files.begin(), o.points_files.end());
    base::refuse_to_overwrite({o.over_file, o.check_file, o.report_file}, inputs);
    if (o.go_on && (o.until.empty() || !o.control.empty()))
        base::fail("-go-on", "needs -until, and cannot be used with -control");
    if (!o.against.empty() && o.against != "previous" && o.against != "first" && !std::ifstream(o.against))
        base::fail("-against", "\"" + o.against + "\" is neither previous nor first, nor a file that can be read");
    if (!o.files.empty() && !o.against.empty()) base::fail("-against", "works on a stream, not on files");
    if (o.tolerances && !o.difference) base::fail("-tolerance", "belongs to -difference");
    if (!o.spectra.empty() && (!o.files.empty() || o.difference || o.mode != OutputMode::vcmetrics))
        base::fail("-spectrum", "is of lights, and cannot be used with pictures, -difference or -like");
    if (!o.difference) return;

    if (o.files.size() != 2) base::fail("-difference", fmt::format("takes two inputs, not {}", o.files.size()));
    const bool no_table = o.mode == OutputMode::evalglare && (o.evalglare.ev_only || o.evalglare.fast);
    if (!o.until.empty() || !o.check_file.empty() || o.list_sources || no_table)
        base::fail("-difference", "cannot be used with -until, -sources, -c, -V, -1, -2 or -3");
}

// What a report shows where the command line does not say it.
void complete_for_report(Options& o) {
    const bool is_changed = o.settings.field_cut || o.settings.fill;
    if (!is_changed && !o.ci) o.ci = .95;
    if (o.metrics.empty()) {
        o.metrics = {"Ev", is_changed ? "DGP" : "DGPf"};
        if (!o.regions_file.empty()) o.metrics.push_back("TAL");
        if (!o.contrast_pairs.empty()) o.metrics.push_back("CR");
    }
    o.scene_options.raypath = base::raypath_from_environment();
    o.scene_options.work = base::work_budget_from_environment();
    o.scene = base::open_folders(o.scene, o.scene_options);
    for (const auto& [file, text] : o.overlays)
        o.scene_options.overlays = base::with_overlay(o.scene_options.overlays, file, base::read_text_file(text));
}

}  // namespace

std::optional<int> parse_options(int argc, char** argv, Options& o) {
    view::View view;
    base::OptionTable table("vcmetrics", LUXPIPE_VERSION, "[options] [picture ...]");
    declare_options(table, o, view);
    const auto operands = table.parse(argc, argv);
    if (!operands) return 0;

    base::note_files(*o.scene_options.read, table.files_read());
    o.command = table.command();
    if (!o.warnings) base::set_warning_sink({});
    if (says_view(table)) o.view = view;
    o.files = *operands;
    expand_globs(o.files);
    if (!o.report_file.empty() && o.mode == OutputMode::vcmetrics) complete_for_report(o);
    check_said(table, o);
    check(o);
    const bool own_rows = o.mode == OutputMode::vcmetrics && !o.difference;
    if (own_rows && o.format == report::TableFormat::tsv && base::stdout_is_terminal())
        o.format = report::TableFormat::aligned;
    if (o.evalglare.fast) o.settings.background = 0;  // the fast modes ignore -q
    return std::nullopt;
}
