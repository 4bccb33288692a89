// SPDX-License-Identifier: BSD-3-Clause
// Options and the fingerprint: every option of ptrace is part of it (.moves_pixels()) or is listed here with what makes
// it harmless.  Frames with different fingerprints are never summed; an option that moves pixels and were not part of
// it would let ptaccum sum frames of different pictures.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <map>
#include <sstream>

#include "declare.h"
#include "render/fingerprint.h"

namespace {

const std::map<std::string, const char*> harmless_groups = {
    {"", "refused, or read past"},
    {"View", "the view is a part of the fingerprint"},
    {"Several pictures", "their views and skies are parts of the fingerprint"},
    {"Messages", "messages"},
    {"General", "questions"},
};

const std::map<std::string, const char*> harmless = {
    {"-x", "the size is a part of the fingerprint"},
    {"-y", "the same"},
    {"-pa", "the same"},
    {"-dp", "no effect"},
    {"-u", "no effect"},
    {"-ms", "no effect"},
    {"-any-reflectance", "lets a scene through that is refused otherwise"},
    {"-f", "definitions are a part of the scene"},
    {"-frames", "frame k is the same in every range"},
    {"-seed", "frames of different seeds may be summed; the header names the seed"},
    {"-focus", "its pixels are a part of the fingerprint"},
    {"-focus-share", "their samples are a part of the fingerprint"},
    {"-picture", "frames are the same, their sum is written"},
    {"-pixel", "tables in place of frames"},
    {"-moments", "moments are no pixels; frames are the same without"},
    {"-action", "tables of its renderings are a part of the scene"},
    {"-bands", "as for -action"},
    {"-daylight", "as for -action"},
    {"-lamp", "as for -action"},
    {"-device", "the same bits on every device"},
    {"-n", "the same bits on any number of threads"},
    {"-o", "a name"},
    {"-M", "a name"},
    {"-control", "a name"},
    {"-watch", "frames after an edit are those of a run of its own"},
    {"-MF", "a name"},
    {"-exec", "what the commands print is a part of the scene"},
    {"-rif", "stands for scene files, options and views"},
};

std::string fingerprint(const render::RenderOptions& options) {
    return render::fingerprint({}, {}, {}, 8, 8, options, {});
}

bool changes(const std::string& option, size_t arguments, const char* value) {
    render::RenderOptions render;
    const std::string before = fingerprint(render);
    base::OptionTable table;
    render::declare_options(table, render);
    std::vector<std::string> words{arguments ? option : option + value};
    words.resize(1 + arguments, value);
    std::string wrong;
    return table.read_header_words(words, wrong) && fingerprint(render) != before;
}

}  // namespace

TEST_CASE("an option of ptrace is a part of the fingerprint, or is known to be harmless") {
    Options options;
    std::optional<scene::RadInput> rad_input;
    base::OptionTable table("ptrace", "1", "");
    declare_options(table, options, rad_input, {});
    size_t moving = 0;
    for (const base::Option& o : table.options()) {
        CAPTURE(o.spelling);
        const bool listed = harmless.count(o.name) || harmless_groups.count(o.group());
        CHECK_MESSAGE(o.pixels != listed, "say .moves_pixels(), or name it in this test with the reason why not");
        if (!o.pixels) continue;

        bool changed = false;
        for (const char* value : {"0", "1", "+", "-", "plain"}) changed = changed || changes(o.name, o.count, value);
        CHECK_MESSAGE(changed, "not in lib/render/options.cpp, whose options the fingerprint holds");
        ++moving;
    }
    CHECK(moving > 15);
}

TEST_CASE("-sampling shared is the former name of -sampling reuse") {
    std::string found[2];
    for (const std::string name : {"reuse", "shared"}) {
        render::RenderOptions render;
        render.sampling = render::Sampling::plain;
        base::OptionTable table;
        render::declare_options(table, render);
        table.read_words({"-sampling", name});
        CHECK(render.sampling == render::Sampling::reuse);
        found[name == "shared"] = fingerprint(render);
    }
    CHECK(found[0] == found[1]);
}
