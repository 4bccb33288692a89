// SPDX-License-Identifier: BSD-3-Clause
// Every recorded run of evalglare 3.06 that printed a number (tests/golden/glare/README.md), repeated with
// `vcmetrics -like evalglare`: every number within 5e-5 relative (below 0.2, and every DGP: 1e-5 absolute), same words,
// same exit status, for 99 % of the rows.  evalglare's own builds differ in 107 of them; a row counts if it equals
// either build as a whole.  Rows of one source are compared as a set: after merges the order depends on the last bit.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

const std::string folder = std::string(LUXPIPE_TESTS) + "/golden/glare";

struct Row {
    std::string image, arguments, out;
    int status;
};

std::string unescape(const std::string& s) {
    std::string out;
    for (size_t i = 0; i < s.size(); ++i) {
        if (s[i] != '\\' || i + 1 == s.size()) {
            out += s[i];
            continue;
        }
        const char c = s[++i];
        out += c == 'n' ? '\n' : c == 't' ? '\t' : c;
    }
    return out;
}

std::vector<Row> read_rows(const std::string& file) {
    std::ifstream in(folder + "/" + file);
    REQUIRE(in);
    std::vector<Row> rows;
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::vector<std::string> cell;
        std::istringstream cells(line);
        for (std::string c; std::getline(cells, c, '\t');) cell.push_back(c);
        REQUIRE(cell.size() >= 4);
        rows.push_back({cell[0], cell[1], unescape(cell[2]), std::atoi(cell[3].c_str())});
    }
    return rows;
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> out;
    for (std::string w; in >> w;) out.push_back(w);
    return out;
}

bool same_word(const std::string& a, const std::string& b, bool dgp) {
    if (a == b) return true;
    char *ea, *eb;
    const double x = std::strtod(a.c_str(), &ea), y = std::strtod(b.c_str(), &eb);
    if (*ea || *eb) return false;
    if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && std::isnan(y);
    return std::fabs(x - y) <= (dgp || std::fabs(y) < 0.2 ? 1e-5 : 5e-5 * std::fabs(y));
}

// `skip` words at the start are not compared.
bool same_line(const std::string& a, const std::string& b, size_t skip = 0) {
    const auto x = words_of(a), y = words_of(b);
    if (x.size() != y.size()) return false;
    for (size_t k = skip; k < x.size(); ++k)
        if (!same_word(x[k], y[k], k == 1 && y[0].compare(0, 4, "dgp,") == 0)) return false;
    return true;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> out;
    for (std::string l; std::getline(in, l);) out.push_back(l);
    return out;
}

bool is_source(const std::string& line) {
    return !line.empty() && std::isdigit(static_cast<unsigned char>(line[0])) && words_of(line).size() == 22;
}

// Of a cut record the whole lines are compared, and the number of lines follows from the first one (count of sources).
bool same_output(const std::string& got, std::string want) {
    std::vector<std::string> ours = lines_of(got), theirs;
    const size_t cut = want.find("[[CUT ");
    if (cut == std::string::npos) {
        theirs = lines_of(want);
        if (ours.size() != theirs.size()) return false;
    } else {
        const std::string head = want.substr(0, want.rfind('\n', cut)), tail = want.substr(want.find('\n', cut) + 1);
        theirs = lines_of(head);
        for (const std::string& l : lines_of(tail)) theirs.push_back(l);
        const double length = std::atof(want.c_str() + cut + 6);
        if (std::fabs(double(got.size()) - length) > 0.01 * length) return false;
    }
    std::multimap<std::string, std::string> sources;  // by number of pixels and x, which identify nearly all
    std::vector<std::string> rest;
    for (const std::string& l : ours)
        if (is_source(l)) sources.emplace(words_of(l)[1] + " " + words_of(l)[2].substr(0, words_of(l)[2].find('.')), l);
        else rest.push_back(l);
    size_t at = 0;
    for (const std::string& l : theirs) {
        if (!is_source(l)) {
            if (cut != std::string::npos && at < rest.size() && words_of(rest[at]).size() != words_of(l).size()) ++at;
            if (cut != std::string::npos && rest.size() > 100) {  // patches, pixel by pixel: any line
                if (std::none_of(rest.begin(), rest.end(), [&](const std::string& o) { return same_line(o, l); }))
                    return false;
                continue;
            }
            if (at >= rest.size() || !same_line(rest[at++], l)) return false;
            continue;
        }
        const auto range =
            sources.equal_range(words_of(l)[1] + " " + words_of(l)[2].substr(0, words_of(l)[2].find('.')));
        auto found = range.first;
        while (found != range.second && !same_line(found->second, l, 1)) ++found;
        if (found == range.second) return false;
        sources.erase(found);
    }
    return cut != std::string::npos || sources.empty();
}

std::string run(const Row& row, int& status) {
    const bool from_stdin = row.image[0] == '<';
    const std::string image = "images/" + (from_stdin ? row.image.substr(1) : row.image);
    const std::string command = "cd '" + folder + "' && '" VCMETRICS "' -like evalglare " + row.arguments +
                                (from_stdin ? " < " : " ") + image + " 2>/dev/null";
    FILE* pipe = popen(command.c_str(), "r");
    std::string out;
    char buffer[65536];
    for (size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) out.append(buffer, n);
    const int code = pclose(pipe);
    status = WIFEXITED(code) ? WEXITSTATUS(code) : -1;
    return out;
}

}  // namespace

TEST_CASE("recorded lines of evalglare come out again for 99 % of the rows") {
    const std::vector<Row> rows = read_rows("evalglare.tsv");
    std::map<std::pair<std::string, std::string>, std::string> other_build;
    for (const Row& r : read_rows("evalglare_nofma.tsv")) other_build[{r.image, r.arguments}] = r.out;
    // read right here, wrongly by evalglare: XYZE pixels, bottom row first, columns first
    const std::set<std::string> left_out = {"xyze.hdr", "yup.hdr", "xmajor.hdr"};
    std::vector<const Row*> jobs;
    for (const Row& r : rows)
        if (!left_out.count(r.image) &&
            std::any_of(r.out.begin(), r.out.end(), [](unsigned char c) { return std::isdigit(c); }))
            jobs.push_back(&r);
    REQUIRE(jobs.size() > 1300);

    std::vector<char> ok(jobs.size(), 0);
    std::atomic<size_t> next{0};
    const auto work = [&] {
        for (size_t k; (k = next++) < jobs.size();) {
            int status = 0;
            const std::string got = run(*jobs[k], status);
            const auto other = other_build.find({jobs[k]->image, jobs[k]->arguments});
            ok[k] = status == jobs[k]->status &&
                    (same_output(got, jobs[k]->out) || (other != other_build.end() && same_output(got, other->second)));
        }
    };
    std::vector<std::thread> threads;
    for (unsigned k = 0; k < std::max(1u, std::thread::hardware_concurrency()); ++k) threads.emplace_back(work);
    for (std::thread& t : threads) t.join();

    size_t equal = 0;
    for (size_t k = 0; k < jobs.size(); ++k) {
        equal += ok[k];
        if (!ok[k]) MESSAGE("differs (docs/differences-evalglare.md): " << jobs[k]->image << " " << jobs[k]->arguments);
    }
    MESSAGE(equal << " of " << jobs.size() << " rows agree");
    CHECK(double(equal) >= 0.99 * double(jobs.size()));
}
