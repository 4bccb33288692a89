// SPDX-License-Identifier: BSD-3-Clause
// See same_content.h.
#include "base/same_content.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <mutex>
#include <vector>

#include "base/file_status.h"

namespace base {
namespace {

bool compare(const std::string& a, const std::string& b) {
    std::ifstream one(a, std::ios::binary), other(b, std::ios::binary);
    constexpr size_t block = 1 << 16;
    std::vector<char> x(block), y(block);
    while (one && other) {
        one.read(x.data(), block);
        other.read(y.data(), block);
        if (one.gcount() != other.gcount() || !std::equal(x.begin(), x.begin() + one.gcount(), y.begin())) return false;
    }
    return one.eof() && other.eof();
}

struct Answer {
    FileStamp a, b;
    bool same;
};

}  // namespace

bool same_content(const std::string& a, const std::string& b) {
    const FileStamp x = stamp_of(a), y = stamp_of(b);
    if (x.device == y.device && x.inode == y.inode) return true;
    if (x.size != y.size) return false;
    static std::mutex lock;
    static std::vector<Answer> answers;
    const std::lock_guard<std::mutex> hold(lock);
    const auto known =
        std::find_if(answers.begin(), answers.end(), [&](const Answer& k) { return k.a == x && k.b == y; });
    if (known != answers.end()) return known->same;
    answers.push_back({x, y, compare(a, b)});
    return answers.back().same;
}

}  // namespace base
