// SPDX-License-Identifier: BSD-3-Clause
// Temporary files for unit tests, and errors as text.
#pragma once
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/error.h"

// A folder of its own, removed at the end with the files made through name().
class TempFolder {
public:
    TempFolder() {
        char pattern[] = "/tmp/luxpipe-unit.XXXXXX";
        folder_ = mkdtemp(pattern);
    }
    ~TempFolder() {
        for (const std::string& n : names_) std::remove(n.c_str());
        rmdir(folder_.c_str());
    }
    std::string name(const std::string& file) {
        names_.push_back(folder_ + "/" + file);
        return names_.back();
    }
    std::string holding(const std::string& file, const std::string& bytes) {
        const std::string path = name(file);
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

private:
    std::string folder_;
    std::vector<std::string> names_;
};

inline std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// What f throws, as text; "" if nothing.
template <class F>
std::string error_text(F f) {
    try {
        f();
    } catch (const base::Error& e) {
        return e.text;
    }
    return "";
}
