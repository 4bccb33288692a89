// SPDX-License-Identifier: BSD-3-Clause
// See answers.h.
#include "live/answers.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/number.h"
#include "base/split.h"
#include "base/value.h"
#include "display/tone.h"
#include "image/exr.h"
#include "image/header.h"
#include "image/stream.h"
#include "live/json.h"
#include "live/pixel.h"
#include "live/regions.h"

namespace live {

namespace {

constexpr double patience = 3;  // seconds, for an answer of ptrace

double number(const Arguments& arguments, const char* name, double fallback) {
    const std::string text = arguments(name);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return text.empty() || *end || !std::isfinite(value) ? fallback : value;
}

// A number of digits alone.  Nothing: the text is another, or the number is too large.
std::optional<size_t> count(const Arguments& arguments, const char* name) {
    const std::string text = arguments(name);
    if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos) return {};
    return size_t(std::stoul(text));
}

std::string table(const display::ColourTable& t) {
    std::vector<double> colours;
    for (const display::Colour& c : t.colours) colours.insert(colours.end(), c.begin(), c.end());
    return json::object({{"thresholds", json::numbers(t.thresholds)}, {"colours", json::numbers(colours)}});
}

Answer falsecolor(const Arguments& arguments) {
    display::ToneOptions o;
    const double top = number(arguments, "top", 0);
    o.decades = number(arguments, "decades", o.decades);
    if (!arguments("divisions").empty()) o.divisions = int(count(arguments, "divisions").value_or(0));
    o.mask_cdm2 = number(arguments, "mask", 0);
    if (arguments("style") == "bands") o.style = display::ToneOptions::Style::bands;
    if (!(top > 0 && o.decades >= 0 && o.decades <= 12 && o.divisions >= 2 && o.divisions <= 64 && o.mask_cdm2 >= 0))
        return plain(400, "no such scale");
    return {200, "application/json", table(display::falsecolor_table({top, o.decades}, o))};
}

// Adds what the page needs of a picture to show it.
std::string with_facts(json::Members all, const image::Picture& p) {
    const image::Header& h = p.header;
    const display::Exposure e = display::automatic_exposure(p);
    all.insert(all.end(), {{"width", std::to_string(p.width)},
                           {"height", std::to_string(p.height)},
                           {"aspect", json::number(h.pixel_aspect)},
                           {"exposure", json::numbers({e.scale, e.white2})},
                           {"top", json::number(display::falsecolor_scale(p, {}).top)},
                           {"name", json::text(image::label(h))}});
    if (h.frames) all.emplace_back("frames", std::to_string(*h.frames));
    if (h.edit) all.insert(all.end(), {{"edit", std::to_string(*h.edit)}, {"what", json::text(h.edited)}});
    if (h.view) all.emplace_back("view", json::text(view::to_options(*h.view)));
    return json::object(all);
}

const File* named(const State& s, const Arguments& arguments) {
    const auto n = count(arguments, "n");
    return n && *n < s.files.size() ? &s.files[*n] : nullptr;
}

Answer file(const State& s, const Arguments& arguments) {
    const File* f = named(s, arguments);
    if (!f) return plain(404, "no such file");
    if (!f->trouble.empty()) return plain(409, f->trouble);
    return {200, "text/plain; charset=utf-8", f->text ? *f->text : "", f->tag};
}

// The outlines in the newest picture, of the file as it is now.
Answer outlines(const State& s, const Arguments& arguments) {
    const File* f = named(s, arguments);
    if (!f || f->kind != TextFile::Kind::regions || !s.picture) return plain(404, "no regions, or no picture yet");
    try {
        return {200, "application/json", region_outlines(f->text ? *f->text : "", f->path, *s.picture)};
    } catch (const base::Error& e) {
        return plain(409, e.text);
    }
}

// The text that stands for a file, with its version; 204: it is the file's own.
Answer overlaid(const State& s, const Arguments& arguments) {
    const File* f = named(s, arguments);
    if (!f) return plain(404, "no such file");
    const Text& t = s.now.texts[size_t(f - s.files.data())];
    return {t ? 200u : 204u, "text/plain; charset=utf-8", t ? *t : "", std::to_string(f->version)};
}

// Length of the text, the text, the pixels.
Answer packed(const std::string& text, const image::Picture* picture) {
    Answer answer{200, "application/octet-stream", {}};
    const uint32_t length = uint32_t(text.size());
    for (int k = 0; k < 4; ++k) answer.body += char(length >> 8 * k & 255);
    answer.body += text;
    if (picture)
        answer.body.append(reinterpret_cast<const char*>(picture->rgb.data()), picture->rgb.size() * sizeof(float));
    return answer;
}

// The picture of a variant; without a name: of the edit before.
Answer variant(const State& s, const std::string& name) {
    const Variant* v = find_variant(s.now, name);
    const Result* known = v ? result_of(s, v->look) : nullptr;
    const auto picture = known ? known->picture : name.empty() ? s.before : nullptr;
    return picture ? packed(with_facts({{"picture", "0"}}, *picture), picture.get()) : plain(404, "no picture");
}

}  // namespace

std::optional<Answer> answer_next(const Live& live, const Arguments& arguments) {
    const auto known = [&](const char* what) { return count(arguments, what).value_or(0); };
    const auto news =
        live.since({known("picture"), known("line"), known("files"), known("design")}, !arguments("end").empty());
    if (!news) return std::nullopt;
    json::Members all{{"picture", std::to_string(news->picture)},
                      {"line", std::to_string(news->line)},
                      {"files", std::to_string(news->files)},
                      {"design", std::to_string(news->design)},
                      {"lines", json::list(news->lines)}};
    if (!news->state.empty()) all.emplace_back("state", news->state);
    if (news->ended) all.emplace_back("ended", std::to_string(*news->ended));
    return packed(news->shown ? with_facts(all, *news->shown) : json::object(all), news->shown.get());
}

std::optional<Answer> answer_asked(Asked& asked, const std::string& option, const Arguments& arguments) {
    const auto found = asked.of(count(arguments, "picture").value_or(0));
    if (!found) return std::nullopt;
    if (found->status != 0)
        return plain(409, "vcmetrics " + option + " ends with status " + std::to_string(found->status));
    return Answer{200, option == "-report" ? "text/html; charset=utf-8" : "application/json", found->text};
}

std::optional<Answer> answer_what(const State& s, const Arguments& arguments) {
    const auto found = s.questions.find(place_of(arguments));
    if (found == s.questions.end() || !s.picture) return std::nullopt;
    const std::string edit = std::to_string(s.picture->header.edit.value_or(0)) + "\t", &answer = found->second.answer;
    if (!base::begins_with(answer, edit)) return std::nullopt;
    return Answer{200, "text/plain; charset=utf-8", answer.substr(edit.size()), ""};
}

bool is_to_be_asked(const State& s, const Arguments& arguments) {
    const auto found = s.questions.find(place_of(arguments));
    return found == s.questions.end() || s.at - found->second.at > patience;
}

Answer answer_query(const State& s, const std::string& path, const Arguments& arguments) {
    if (path == "/file") return file(s, arguments);
    if (path == "/overlay") return overlaid(s, arguments);
    if (path == "/variant") return variant(s, arguments("name"));
    if (path == "/outlines") return outlines(s, arguments);
    if (path == "/table") return falsecolor(arguments);
    if (path == "/srgb") return {200, "application/json", json::numbers(display::srgb_codes().thresholds)};
    if (path == "/pixel") {
        const auto x = count(arguments, "x"), y = count(arguments, "y");
        const std::string known = s.picture && x && y ? pixel_facts(*s.picture, int(*x), int(*y)) : "";
        return known.empty() ? plain(404, "no such pixel") : Answer{200, "application/json", known};
    }
    if (path == "/save") {
        const std::string as = arguments("as"), type = "application/octet-stream";
        if (s.picture && as == "hdr") return {200, type, image::picture_bytes(*s.picture, image::Format::rgbe)};
        if (s.picture && as == "exr") return {200, type, image::exr_bytes("luxpipe.exr", *s.picture)};
        return plain(404, "no such file");
    }
    return plain(404, "nothing here");
}

}  // namespace live
