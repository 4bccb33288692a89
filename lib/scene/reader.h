// SPDX-License-Identifier: BSD-3-Clause
// The reader of scene text behind read_scene(): statements (reader.cpp) and the "!commands" between them
// (commands.cpp).
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>
#include "base/text_reader.h"
#include "scene/builder.h"
#include "scene/shell_words.h"
#include "scene/transform.h"

namespace scene {

// Steps of base::WorkBudget: one for so many bytes, so many for a file opened and for a copy that xform makes.
constexpr uint64_t work_bytes = 1000, work_file = 10, work_copy = 10;

class SceneReader {
public:
    SceneReader(Scene& scene, const ReadOptions& options, const Limits& limits)
        : scene_(scene), options_(options), limits_(limits), work_(*options.work), builder_(scene, limits) {}
    void read_file(const std::string& path, const std::string& asked_by);
    void read_statements(const std::string& text, const std::string& name, uint32_t line);

private:
    // Counts how deep we are, also when an exception passes; throws Error beyond the limit.
    class Deeper {
    public:
        Deeper(int& depth, int limit, const std::string& place);
        ~Deeper() { --depth_; }

    private:
        int& depth_;
    };

    void content(base::TextReader& in, const std::string& path);
    void statements(base::TextReader& in);
    void octree(base::TextReader& in);
    void mesh(const base::TextReader& in, const std::string& path);
    void primitive(base::TextReader& in);
    void command(base::TextReader& in);
    void run(const CommandLine& line, const std::string& text, size_t stage, const base::TextReader& from);
    void cat(const std::vector<std::string>& files, const base::TextReader& from);
    std::string text_of(const std::string& file, const base::TextReader& from, size_t limit);
    void read_text(const std::string& text, const base::TextReader& from);
    void read_included(const std::string& name, const base::TextReader& from);
    std::string run_shell(const std::string& text, const std::string& place) const;
    long long count(base::TextReader& in, const char* what);

    Scene& scene_;
    const ReadOptions& options_;
    const Limits& limits_;
    base::WorkBudget& work_;
    SceneBuilder builder_;
    Primitive primitive_;
    std::vector<const Transform*> transforms_;         // innermost last
    std::vector<std::pair<uint64_t, uint64_t>> open_;  // device and inode of the files being read
    int depth_ = 0;
    uint64_t primitives_ = 0;
};

}  // namespace scene
