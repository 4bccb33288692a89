// SPDX-License-Identifier: BSD-3-Clause
// How near two words are to each other, for "did you mean".
#pragma once
#include <string>
#include <vector>

namespace base {

// Letters to insert, delete, exchange or swap to turn one word into the other: Damerau's distance in its restricted
// form (F. J. Damerau, CACM 7(3), 1964).
int edit_distance(const std::string& a, const std::string& b);

// The largest distance at which a word may be a misspelling of another of that length.
inline int largest_slip(size_t length) { return length < 6 ? 1 : int(length / 3); }

// The word of the list that is meant by another one, small and capital letters being alike; empty: none is.
std::string meant_by(const std::string& word, const std::vector<std::string>& list);
// "; did you mean DGPf?", or nothing.
std::string question(const std::string& word, const std::vector<std::string>& list);

}  // namespace base
