// SPDX-License-Identifier: BSD-3-Clause
// Reads both sides, compares them and prints a line for each metric (compare_inputs.h).
#include "compare_inputs.h"
#include <sstream>
#include <unistd.h>
#include "base/error.h"
#include "base/run.h"
#include "base/split.h"
#include "base/text_file.h"
#include "glare/columns.h"
#include "report/compare.h"
#include "measure_stream.h"

namespace {
using namespace glare;
using namespace report;

// Rules as typed, or the lines of a file (# begins a comment).
std::vector<Tolerance> rules_of(const std::string& text) {
    if (text.empty()) return {};
    if (access(text.c_str(), F_OK) != 0) return parse_tolerances(text, "-tolerance");
    std::istringstream in(base::read_text_file(text));
    std::vector<Tolerance> out;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        for (const Tolerance& t : parse_tolerances(line, text + ":" + std::to_string(number))) out.push_back(t);
    }
    return out;
}

// Both sides with the same metrics: those of -metrics, or else of a record, or else all.
std::pair<NumberTable, NumberTable> both_sides(const Options& o) {
    std::optional<NumberTable> side[2] = {read_numbers(o.files[0]), read_numbers(o.files[1])};
    std::vector<std::string> metrics = o.metrics;
    for (const auto& s : side)
        if (s && o.metrics.empty()) metrics = s->names;
    if (metrics.empty()) {
        metrics = compared_columns();
        if (!o.regions_file.empty()) metrics.push_back("TAL");
        if (!o.contrast_pairs.empty()) metrics.push_back("CR");
    }
    for (int k = 0; k < 2; ++k)
        if (!side[k]) side[k] = measure_table(o, o.files[k], metrics);
        else if (!o.metrics.empty()) side[k] = only(*side[k], o.metrics);
    return {*side[0], *side[1]};
}

// A rule of -tolerance may name any metric that is compared here, or would be with other -metrics.
std::vector<std::string> metrics_there_are(const NumberTable& compared) {
    std::vector<std::string> names = base::split_words(glare::column_names());
    names.insert(names.end(), compared.names.begin(), compared.names.end());
    return names;
}

}  // namespace

int compare_inputs(const Options& o) {
    const std::vector<Tolerance> rules = rules_of(o.tolerances);
    const auto [first, second] = both_sides(o);
    require_known(rules, metrics_there_are(first));
    const std::vector<std::string> names = {"row", "metric", "first", "second", "difference", "tolerance", "within"};
    std::string text = header_line(names, o.format);
    bool all_within = true;
    for (const Difference& d : compare_tables(first, second, rules)) {
        text += table_line(
            names,
            {text_cell(d.row), text_cell(d.metric), number_cell(d.first, 10), number_cell(d.second, 10),
             number_cell(d.second - d.first, 4), text_cell(d.tolerance.text()), text_cell(d.within ? "yes" : "no")},
            o.format);
        all_within = all_within && d.within;
    }
    base::write_stdout(text.data(), text.size());
    return all_within ? 0 : 5;
}
