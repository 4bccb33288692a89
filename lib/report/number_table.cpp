// SPDX-License-Identifier: BSD-3-Clause
// Recorded tables and evalglare's lines as columns of numbers (number_table.h).
#include "report/number_table.h"
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include "base/error.h"
#include "report/errors.h"

namespace report {
namespace {

// evalglare's column names and ours; av_lum_pos2 is left out (its value is divided twice), dgp_ext is always 0.
const std::map<std::string, std::string> evalglare_names = {{"dgp", "DGP"},
                                                            {"dgi", "DGI"},
                                                            {"ugr", "UGR"},
                                                            {"vcp", "VCP"},
                                                            {"cgi", "CGI"},
                                                            {"Lveil", "Lveil"},
                                                            {"Ev_calc", "Ev"},
                                                            {"E_v", "Ev"},
                                                            {"abs_max", "Lmax"},
                                                            {"av_lum", "Lavg"},
                                                            {"lum_backg", "Lb"},
                                                            {"E_v_dir", "Edir"},
                                                            {"lum_sources", "L_sources"},
                                                            {"omega_sources", "omega_sources"},
                                                            {"Lveil_cie", "LveilCIE"},
                                                            {"dgr", "DGR"},
                                                            {"ugp", "UGP"},
                                                            {"ugr_exp", "UGRexp"},
                                                            {"dgi_mod", "DGImod"},
                                                            {"av_lum_pos", "LavgPos"},
                                                            {"med_lum", "Lmed"},
                                                            {"med_lum_pos", "LmedPos"},
                                                            {"med_lum_pos2", "LmedPos2"},
                                                            {"ugp2", "UGP2"},
                                                            {"dgp_ext", ""},
                                                            {"av_lum_pos2", ""}};

// Columns that tell rows apart; "seconds" tells nothing.
bool is_label(const std::string& name) {
    static const std::set<std::string> labels{"file",  "view",   "sky",  "state", "edit",
                                              "frame", "source", "grid", "point"};
    return labels.count(name) > 0;
}

// A file is known by its name in whatever folder it lies; slashes of other names, such as states of groups, are theirs.
std::string label_of(const std::string& column, const std::string& cell) {
    return column == "file" ? name_in_folder(cell) : cell;
}

// Columns of words about a row.
bool is_note(const std::string& name) { return name == errors_column || name == paths_column || name == hour_column; }

bool is_metric(const std::string& name) {
    return !is_label(name) && !is_note(name) && name != "seconds" && name != "settled" && name != "class" &&
           name != "classf" && name != "tails";
}

double number(const std::string& text, const std::string& place) {
    if (text == "null") return std::nan("");
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end) base::fail(place, "\"" + text + "\" is not a number");
    return value;
}

std::vector<std::string> split_cells(const std::string& line, char by) {
    std::vector<std::string> out(1);
    bool quoted = false;
    for (char c : line) {
        if (c == '"' && by == ',') quoted = !quoted;
        else if (c == by && !quoted) out.emplace_back();
        else out.back() += c;
    }
    return out;
}

class TableReader {
public:
    TableReader(const std::string& path, const RowUse& use) : in_(path, std::ios::binary), use_(use) {
        if (!in_) base::fail_system(path, "cannot be read");
        table_.name = path;
    }
    bool read() {
        if (in_.peek() == 0x76) return false;  // OpenEXR
        std::string line;
        for (long n = 1; next_line(line); ++n) {
            place_ = table_.name + ":" + std::to_string(n);
            if (line.compare(0, 2, "#?") == 0 || line.find('\0') != std::string::npos) return false;
            if (!line.empty() && line[0] != '#') take(line);
        }
        if (rows_ == 0) base::fail(table_.name, "holds no line of metrics");
        return true;
    }

private:
    static constexpr size_t longest_line = 1 << 20;

    // As std::getline, but of a file without end (/dev/zero) it takes no more than a line may have.
    bool next_line(std::string& line) {
        line.clear();
        for (int c; (c = in_.get()) != EOF && c != '\n';) {
            line += char(c);
            if (line.size() > longest_line) base::fail(table_.name, "holds a line of more than a million characters");
        }
        if (!line.empty() && line.back() == '\r') line.pop_back();  // lines of Windows end in CR LF
        return !line.empty() || in_.good();
    }
    void take(const std::string& line) {
        if (line[0] == '{') return json(line);
        const size_t colon = line.find(": ");
        if (line.compare(0, 4, "dgp,") == 0 && colon != std::string::npos) return evalglare(line, colon);
        if (line == header_line_) return;  // tables joined by cat
        if (separator_) return plain(line);
        if (line.find('\t') != std::string::npos || is_label(line.substr(0, line.find(',')))) {
            separator_ = line.find('\t') != std::string::npos ? '\t' : ',';
            header_line_ = line;
            header_ = split_cells(line, separator_);
            for (const std::string& h : header_) {
                if (is_metric(h)) table_.names.push_back(h);
                if (is_label(h)) table_.labels.push_back(h);
                if (is_note(h)) table_.notes.push_back(h);
            }
            return;
        }
        const bool bare = line.find_first_not_of("0123456789.+-e") == std::string::npos;
        if (bare) return add({"Ev"}, {number(line, place_)});  // evalglare -V
        const bool detail =
            line.compare(0, 5, "band:") == 0 || line.compare(0, 7, "zoning:") == 0 ||
            line.compare(0, 8, "masking:") == 0 ||
            std::isdigit(static_cast<unsigned char>(line[0]));  // sources and statistics of -d: not compared
        if (!detail) base::fail(place_, "is neither a table of vcmetrics nor a line of evalglare");
    }
    void plain(const std::string& line) {
        const std::vector<std::string> cells = split_cells(line, separator_);
        if (cells.size() != header_.size())
            base::fail(place_, "has " + std::to_string(cells.size()) + " columns, the header " +
                                   std::to_string(header_.size()));
        std::vector<double> row;
        std::vector<std::string> label, note;
        for (size_t k = 0; k < cells.size(); ++k) {
            if (is_metric(header_[k])) row.push_back(number(cells[k], place_));
            if (is_label(header_[k])) label.push_back(label_of(header_[k], cells[k]));
            if (is_note(header_[k])) note.push_back(cells[k]);
        }
        use(row, label, note);
    }
    void evalglare(const std::string& line, size_t colon) {
        std::vector<std::string> names;
        std::vector<double> row;
        std::istringstream words(line.substr(colon + 2));
        for (const std::string& name : split_cells(line.substr(0, colon), ',')) {
            std::string word;
            if (!(words >> word)) base::fail(place_, "evalglare's line ends before \"" + name + "\"");
            const auto known = evalglare_names.find(name);
            if (known == evalglare_names.end())
                base::fail(place_, "\"" + name + "\" is not a column of evalglare 3.06");
            if (known->second.empty()) continue;
            names.push_back(known->second);
            row.push_back(number(word, place_));
        }
        add(names, row);
    }
    // An object as table.cpp writes it: {"frame": 64, "Ev": 2800, "Ev.lo": 2750, "Ev.hi": 2850}
    void json(const std::string& line) {
        std::vector<std::string> names, labels, label, notes, note;
        std::vector<double> row;
        for (size_t at = 1; (at = line.find('"', at)) != std::string::npos;) {
            const size_t end = line.find('"', at + 1), colon = end == std::string::npos ? end : line.find(':', end);
            if (colon == std::string::npos) base::fail(place_, "is not a JSON object of metrics");
            const std::string name = line.substr(at + 1, end - at - 1);
            const size_t start = line.find_first_not_of(' ', colon + 1);
            if (start != std::string::npos && line[start] == '"') {
                at = line.find('"', start + 1);
                if (at == std::string::npos) base::fail(place_, "is not a JSON object of metrics");
                if (is_label(name)) {
                    labels.push_back(name);
                    label.push_back(label_of(name, line.substr(start + 1, at - start - 1)));
                }
                if (is_note(name)) notes.push_back(name), note.push_back(line.substr(start + 1, at - start - 1));
                ++at;
                continue;
            }
            const size_t stop = line.find_first_of(",} ", start);
            if (start == std::string::npos || stop == std::string::npos)
                base::fail(place_, "is not a JSON object of metrics");
            const std::string value = line.substr(start, stop - start);
            if (is_metric(name)) names.push_back(name), row.push_back(number(value, place_));
            if (is_label(name)) labels.push_back(name), label.push_back(value);
            at = stop;
        }
        if (rows_ == 0) table_.labels = labels, table_.notes = notes;
        add(names, row, label, note);
    }
    void add(const std::vector<std::string>& names, const std::vector<double>& row,
             const std::vector<std::string>& label = {}, const std::vector<std::string>& note = {}) {
        if (rows_ == 0) table_.names = names;
        if (table_.names != names) base::fail(place_, "has different metrics than the lines before it");
        use(row, label, note);
    }
    void use(const std::vector<double>& row, const std::vector<std::string>& label,
             const std::vector<std::string>& note) {
        ++rows_;
        use_(table_, {row, label, note});
    }

    std::ifstream in_;
    NumberTable table_;  // without rows
    const RowUse& use_;
    size_t rows_ = 0;
    std::string place_, header_line_;
    std::vector<std::string> header_;
    char separator_ = 0;
};

}  // namespace

void NumberTable::add_row(const std::vector<double>& values, const std::vector<std::string>& label) {
    rows.push_back(values);
    std::string text;
    for (const std::string& part : label) text += (text.empty() ? "" : " ") + part;
    row_names.push_back(text);
}

std::string name_in_folder(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::optional<NumberTable> read_numbers(const std::string& path) {
    if (path == "-") return std::nullopt;
    constexpr size_t most_rows = 10000000;
    NumberTable all;
    const auto add = [&](const NumberTable& t, const NumberRow& row) {
        if (all.rows.empty()) all = t;
        if (all.rows.size() == most_rows) base::fail(path, "a table of more than ten million rows");
        all.add_row(row.values, row.labels);
    };
    return each_row(path, add) ? std::optional(std::move(all)) : std::nullopt;
}

bool each_row(const std::string& path, const RowUse& use) { return TableReader(path, use).read(); }

}  // namespace report
