// SPDX-License-Identifier: BSD-3-Clause
// See cli.h.  CLI11 2.1 takes "-until" for the bundled letters -u -n -t ..., so a word with one dash
// that names a long option is handed over with two; its messages are turned back.
#include "base/cli.h"

#include <algorithm>
#include <memory>

#include "base/error.h"
#include "base/run.h"

namespace base {
namespace {

class OneDashFormatter : public CLI::Formatter {
public:
    std::string make_option_name(const CLI::Option* opt, bool is_positional) const override {
        if (is_positional) return opt->get_name(true, false);
        std::string names;
        for (const auto& list : {opt->get_snames(), opt->get_lnames()})
            for (const std::string& name : list) names += (names.empty() ? "-" : ", -") + name;
        return names;
    }
};

// "--every: text" reads "-every: text"; one line.
std::string one_dash(std::string text) {
    for (size_t at = 0; (at = text.find("--", at)) != std::string::npos; ++at)
        if (at == 0 || text[at - 1] == ' ') text.erase(at, 1);
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

std::string two_dashes(const CLI::App& app, const std::string& word) {
    if (word.size() < 3 || word[0] != '-' || word[1] == '-') return word;
    const std::string name =
        word.substr(1, word.find('=') == std::string::npos ? std::string::npos : word.find('=') - 1);
    return app.get_option_no_throw("--" + name) ? "-" + word : word;
}

}  // namespace

std::optional<int> parse_cli(CLI::App& app, int argc, char** argv, const std::string& version) {
    return parse_cli(app, std::vector<std::string>(argv + std::min(argc, 1), argv + argc), version);
}

std::optional<int> parse_cli(CLI::App& app, std::vector<std::string> words, const std::string& version) {
    app.set_help_flag("--help", "print this text");
    app.set_version_flag("--version", version, "print the version");
    app.formatter(std::make_shared<OneDashFormatter>());
    for (CLI::Option* opt : app.get_options())
        if (!opt->get_positional() && opt->get_items_expected_max() == 1)
            opt->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    for (std::string& word : words) word = two_dashes(app, word);
    std::reverse(words.begin(), words.end());  // CLI11 eats from the back
    try {
        app.parse(std::move(words));
    } catch (const CLI::CallForHelp&) {
        const std::string text = app.help();
        write_stdout(text.data(), text.size());
        return 0;
    } catch (const CLI::CallForVersion&) {
        const std::string text = app.get_name() + " " + version + "\n";
        write_stdout(text.data(), text.size());
        return 0;
    } catch (const CLI::ExtrasError& e) {
        const std::string text = one_dash(e.what());
        const size_t colon = text.rfind(": ");
        fail(colon == std::string::npos ? "" : text.substr(colon + 2), "not an option or operand here");
    } catch (const CLI::ParseError& e) {
        fail("", one_dash(e.what()));
    }
    return std::nullopt;
}

}  // namespace base
