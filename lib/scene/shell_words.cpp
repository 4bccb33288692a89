// SPDX-License-Identifier: BSD-3-Clause
// Words of a command line.
#include "scene/shell_words.h"
#include <cctype>
#include "base/error.h"
#include "base/file_status.h"

namespace scene {

namespace {

// An unquoted pattern becomes the files it matches, or stays as it is.
void add_word(std::vector<std::string>& words, const std::string& word, bool pattern) {
    std::vector<std::string> found;
    if (pattern && word.size() < 4096) found = base::files_like(word);
    if (found.empty()) found = {word};
    words.insert(words.end(), found.begin(), found.end());
}

}  // namespace

bool in_a_path(char after_backslash) {
    return std::isalnum(static_cast<unsigned char>(after_backslash)) != 0 || after_backslash == '.';
}

CommandLine split_command(const std::string& line, const std::string& place) {
    CommandLine r;
    r.stages.emplace_back();
    std::string word;
    bool in_word = false, pattern = false, redirected = false;
    const size_t n = line.size();
    auto flush = [&] {
        if (in_word && redirected) r.stages.back().input = word;
        else if (in_word) add_word(r.stages.back().words, word, pattern);
        redirected = redirected && !in_word;
        word.clear();
        in_word = pattern = false;
    };
    auto end_stage = [&](size_t at) {
        flush();
        if (redirected && !r.needs_shell) r.needs_shell = '<';
        r.stages.back().end = at;
    };
    size_t i = 0;
    for (; i < n; i++) {
        const char c = line[i];
        if (c == '\\') {
            if (i + 1 < n && (line[i + 1] == '\n' || line.compare(i + 1, 2, "\r\n") == 0)) {
                i += line[i + 1] == '\n' ? 1 : 2;
            } else if (++i < n) {
                if (in_a_path(line[i])) word += '/';
                word += line[i];
                in_word = true;
            }
        } else if (c == '\'' || c == '"') {
            in_word = true;
            const size_t start = i;
            for (i++; i < n && line[i] != c; i++) {
                if (c == '"' && (line[i] == '$' || line[i] == '`') && !r.needs_shell) r.needs_shell = line[i];
                if (c == '"' && line[i] == '\\' && i + 1 < n &&
                    std::string("\\\"$`\n").find(line[i + 1]) != std::string::npos && line[++i] == '\n')
                    continue;
                word += line[i];
            }
            if (i >= n) base::fail(place, std::string("a quote ") + c + " does not end: " + line.substr(start, 40));
        } else if (c == ' ' || (c >= '\t' && c <= '\r')) {
            flush();
        } else if (c == '#' && !in_word) {
            break;
        } else if (c == '|' && line.compare(i, 2, "||") != 0) {
            end_stage(i);
            r.stages.emplace_back();
            r.stages.back().begin = i + 1;
        } else if (c == '<' && !in_word && !redirected && r.stages.size() == 1 && r.stages[0].input.empty() &&
                   (i + 1 == n || std::string("<>&(").find(line[i + 1]) == std::string::npos)) {
            redirected = true;
        } else {
            if (std::string("|&;<>()$`").find(c) != std::string::npos && !r.needs_shell) r.needs_shell = c;
            pattern |= c == '*' || c == '?' || c == '[';
            word += c;
            in_word = true;
        }
    }
    end_stage(i);
    return r;
}

}  // namespace scene
