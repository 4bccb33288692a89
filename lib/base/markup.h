// SPDX-License-Identifier: BSD-3-Clause
// Texts and bytes inside of HTML and SVG.
#pragma once
#include <string>

namespace base {

std::string escaped(const std::string& text);
std::string base64(const std::string& bytes);

}  // namespace base
