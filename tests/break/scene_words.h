// SPDX-License-Identifier: BSD-3-Clause
// Where the words of a scene are, and which of them make a primitive.
#pragma once
#include <string>
#include <vector>

namespace breaking {

// A stretch of the bytes: a word.
struct Stretch {
    size_t from, length;
};

std::vector<Stretch> words_of(const std::string& bytes);

// The words of a primitive: modifier type name, then three counted lists of arguments.
struct Primitive {
    Stretch modifier, type, name;
    std::vector<Stretch> strings, reals;
};

// As far as the text is well formed; commands and comments in between end it only if their words do not pass for a
// primitive.
std::vector<Primitive> primitives_of(const std::string& scene);

}  // namespace breaking
