// SPDX-License-Identifier: BSD-3-Clause
// Shared by the pattern and material types: their strings as expressions, function names, coordinates, files and the
// transform at the end.
#pragma once
#include <functional>
#include "cal/pattern.h"
#include "cal/program.h"
#include "cal/tables.h"

namespace cal {

class Parts {
public:
    Parts(Library& library, const PatternSpec& pattern, Code& code);
    uint32_t compile(const std::function<std::vector<int>()>& make);  // `make` uses the functions below

    void file(size_t at);                          // string `at` names the .cal file
    void no_more_than_transform(size_t at) const;  // the strings from `at` on are a transform, or absent
    size_t transform_at(size_t from) const;        // first string from `from` that begins a transform
    int expression(size_t at);
    int parameters(size_t at);                            // of the function named by string `at`; -1 if none
    int call(size_t at, const std::vector<int>& values);  // the function named by string `at`
    std::vector<int> coordinates(size_t from);            // strings up to the transform
    // As coordinates(); a name that is a function is called with `values`.
    std::vector<int> coordinates_of(size_t from, const std::vector<int>& values);
    uint32_t data(size_t at, size_t dimensions);
    uint32_t picture(size_t at);
    std::optional<SpectralTables> spectral(size_t at);  // string `at`, if it is a hyperspectral picture
    DataFile read(size_t at);
    int text(size_t font_at, size_t real_count);           // ink (1 or 0) of a text pattern with 9 + .. reals
    std::vector<int> to_world(const std::vector<int>& v);  // rotates a displacement or direction, its length kept
    [[noreturn]] void fail(const std::string& fact) const;

    GraphBuilder& builder() { return *builder_; }

    const PatternSpec& spec;
    Graph* graph = nullptr;

private:
    Library& library_;
    Code& code_;
    GraphBuilder* builder_ = nullptr;
    base::Xform xform_;  // object -> world
    std::string context_;
};

}  // namespace cal
