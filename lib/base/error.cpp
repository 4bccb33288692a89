// SPDX-License-Identifier: BSD-3-Clause
// Errors of the system and the collection of warnings.
// Warnings of the same fact have one cause: the first place is shown at once (when a tool has opened the sink), and
// further places are only counted, so that a scene of a million bad polygons gives two lines.
#include "base/error.h"

#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>

#include "base/warnings.h"

namespace base {
namespace {

constexpr size_t most_causes = 200;  // beyond it new causes share one entry: memory stays bounded

struct Warnings {
    std::mutex lock;
    std::map<std::string, long> count;  // by fact
    std::function<void(const std::string&)> sink;
};

Warnings& warnings() {
    static Warnings w;
    return w;
}

}  // namespace

void fail_system(std::string where, std::string fact) {
    const int code = errno;
    if (code) fact += std::string(": ") + std::strerror(code);
    throw Error(Kind::system, std::move(where), std::move(fact));
}

void warn(std::string where, std::string fact) {
    Warnings& w = warnings();
    const std::lock_guard<std::mutex> hold(w.lock);
    if (w.count.size() >= most_causes && !w.count.count(fact)) {
        where.clear();
        fact = "further warnings of other kinds";
    }
    if (++w.count[fact] == 1 && w.sink) w.sink(where.empty() ? fact : where + ": " + fact);
}

void set_warning_sink(std::function<void(const std::string&)> sink) {
    Warnings& w = warnings();
    const std::lock_guard<std::mutex> hold(w.lock);
    w.sink = std::move(sink);
}

bool warnings_are_shown() {
    Warnings& w = warnings();
    const std::lock_guard<std::mutex> hold(w.lock);
    return bool(w.sink);
}

std::vector<std::pair<std::string, long>> take_warnings() {
    Warnings& w = warnings();
    const std::lock_guard<std::mutex> hold(w.lock);
    std::vector<std::pair<std::string, long>> all(w.count.begin(), w.count.end());
    w.count.clear();
    return all;
}

}  // namespace base
