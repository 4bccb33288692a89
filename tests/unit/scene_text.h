// SPDX-License-Identifier: BSD-3-Clause
// For tests of scene readers: a folder of its own, files typed in the test, and the error they give.
#pragma once
#include <stdlib.h>
#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include "base/error.h"
#include "scene/object.h"

// A fresh working directory, left and removed at the end.
struct Folder {
    std::filesystem::path before = std::filesystem::current_path(), path;
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "scene-test.XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path = name;
        std::filesystem::current_path(path);
    }
    ~Folder() {
        std::filesystem::current_path(before);
        std::filesystem::remove_all(path);
    }
    static void write(const std::string& name, const std::string& text) {
        std::ofstream out(name, std::ios::binary);
        out << text;
    }
};

inline std::string text_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream s;
    s << in.rdbuf();
    return s.str();
}

inline scene::Scene read_text(const std::string& text, const scene::ReadOptions& options = {},
                              const scene::Limits& limits = {}) {
    const Folder folder;
    Folder::write("t.rad", text);
    return scene::read_scene({"t.rad"}, options, limits);
}

// The message of the error that reading gives; "" if it gives none.
template <class Read>
std::string error_of(Read read) {
    try {
        read();
    } catch (const base::Error& e) {
        return e.what();
    }
    return "";
}
inline std::string error_in(const std::string& text, const scene::Limits& limits = {}) {
    return error_of([&] { read_text(text, {}, limits); });
}
