// SPDX-License-Identifier: BSD-3-Clause
// See state.h.
#include "live/state.h"

#include <algorithm>

#include "live/json.h"
#include "live/steps.h"

namespace live {

Text text_of(const State& s, const Texts& texts, size_t n) {
    static const Text none{""};
    return n < texts.size() && texts[n] ? texts[n] : s.files[n].text ? s.files[n].text : none;
}

Look look_of(const State& s, const Texts& texts, const std::string& view) {
    Look look{Texts(s.files.size()), view};
    for (size_t n = 0; n < s.files.size(); ++n)
        if (s.files[n].kind == TextFile::Kind::scene) look.texts[n] = text_of(s, texts, n);
    return look;
}

const Variant* find_variant(const Model& model, const std::string& name) {
    for (const Variant& v : model.variants)
        if (v.name == name) return &v;
    return nullptr;
}

const Result* result_of(const State& s, const Look& look) {
    const Look whole = look_of(s, look.texts, look.view);
    for (const Result& r : s.results)
        if (r.look == whole) return &r;
    return nullptr;
}

std::string against_of(const State& s) {
    const Variant* base = find_variant(s.now, s.now.base);
    const Result* known = base ? result_of(s, base->look) : nullptr;
    const int64_t edit = known ? known->edit - s.pipe(Which::picture).first_edit : -1;
    return edit >= 0 ? std::to_string(edit) : s.against;
}

bool picture_waits(const State& s) {
    const auto broken = [](const Message& m) { return m.stands && m.cause == Message::Cause::scene; };
    return !s.pipe(Which::picture).sent.empty() && std::none_of(s.messages.begin(), s.messages.end(), broken);
}

std::optional<size_t> regions_file(const State& s) {
    for (size_t n = 0; n < s.files.size(); ++n)
        if (s.files[n].kind == TextFile::Kind::regions) return n;
    return {};
}

bool has_ended(const State& s) {
    const auto ended = [](const Pipe& p) { return p.own && p.stage == Pipe::Stage::ended; };
    return std::any_of(s.pipes.begin(), s.pipes.end(), ended);
}

namespace {

std::string json_of_variants(const State& s, bool whole) {
    return json::list_of(s.now.variants, [&](const Variant& v) {
        const Result* known = result_of(s, v.look);
        return json::object({{"name", json::text(v.name)},
                             {"edit", std::to_string(known ? known->edit : -1)},
                             {"shown", json::truth(look_of(s, v.look.texts, v.look.view) == look_now(s))},
                             {"numbers", json::list(known && whole ? known->numbers : std::vector<std::string>())}});
    });
}

std::string json_of_steps(const State& s) {
    const auto words = [](const std::vector<Change>& all) { return json::text(all.empty() ? "" : all.back().words); };
    return "[" + std::to_string(s.changes) + "," + std::to_string(s.undo.size()) + "," + std::to_string(s.redo.size()) +
           "," + words(s.undo) + "," + words(s.redo) + "]";
}

}  // namespace

std::string json_of(const State& s, bool whole) {
    size_t n = 0;
    const auto text = [&](const File& f) {
        return json::pair(int64_t(f.version), json::truth(bool(s.now.texts[n++])));
    };
    const auto edit = [](const auto& e) { return json::pair(e.first, json::text(e.second)); };
    const auto place = [](const auto& p) { return json::list({p.first, p.second}); };
    const auto notice = [](const Message& m) { return json::pair(int64_t(m.number), json::text(m.text)); };
    std::vector<std::string> all;
    std::vector<Message> standing;
    for (const Message& m : s.messages) {
        all.push_back(m.text);
        if (m.stands) standing.push_back(m);
    }
    return json::object({
        {"texts", json::list_of(s.files, text)},
        {"edits", json::list_of(s.edits, edit)},
        {"places", json::list_of(s.now.places, place)},
        {"variants", json_of_variants(s, whole)},
        {"steps", json_of_steps(s)},
        {"before", std::to_string(s.before ? s.before->header.edit.value_or(0) : -1)},
        {"day", json_of_day(s)},
        {"first", json_of_first(s)},
        {"waits", json::truth(picture_waits(s))},
        {"plan", json_of_plan(s)},
        {"base", json::text(s.now.base)},
        {"against", json::text(s.against)},
        {"earlier", json::list(s.earlier)},
        {"views", json::list(s.now.views)},
        {"notices", json::list_of(standing, notice)},
        {"messages", json::list(all)},
        {"current", std::to_string(standing.size())},
        {"paused", json::truth(s.paused)},
        {"rests", json::truth(s.rest.now)},
        {"again", json::truth(has_ended(s))},
    });
}

}  // namespace live
