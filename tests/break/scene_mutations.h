// SPDX-License-Identifier: BSD-3-Clause
// Ways to spoil the files of a scene, as words and as bytes.
#pragma once
#include <string>
#include <vector>

#include "dice.h"

namespace breaking {

// Changes the bytes of a file; says how.  Others: files to take words and stretches from.
std::string mutate_file(std::string& bytes, const std::vector<std::string>& others, Dice& dice);

// Other white space between the words, and comments before and after: means the same to every reader of scenes.
// Lines of commands stay as they are.
std::string respace(const std::string& scene, Dice& dice);

}  // namespace breaking
