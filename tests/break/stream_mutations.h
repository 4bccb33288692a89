// SPDX-License-Identifier: BSD-3-Clause
// Ways to spoil a stream of pictures.
#pragma once
#include <string>
#include <vector>

#include "dice.h"

namespace breaking {

// A stream as its pictures; each knows where its pixels begin.
struct Pieces {
    struct Piece {
        std::string bytes;
        size_t pixels = 0;
    };
    std::vector<Piece> all;
    std::string joined() const;
};

Pieces cut_into_pictures(const std::string& stream);

// Spoils the bytes in one of two dozen ways; says which.  Others: streams to take pictures from.
std::string mutate_stream(std::string& stream, const std::vector<std::string>& others, Dice& dice);

}  // namespace breaking
