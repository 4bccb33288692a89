// SPDX-License-Identifier: BSD-3-Clause
// The text within the XML of a BSDF file: words, and long lists of numbers.
#pragma once
#include <cstring>
#include <string>

namespace scene {

std::string trimmed(const char* text);

// The same but for upper and lower case.
bool same_but_case(const std::string& a, const char* b);

// Numbers separated by blanks or commas, and the braces of tensor trees.  Throws Error (place) for anything else.
class BsdfNumbers {
public:
    BsdfNumbers(const char* text, const std::string& place)
        : at_(text), end_(text + std::strlen(text)), place_(place) {}
    char peek();  // the next character that is not a separator, 0 at the end
    void take() { at_++; }
    double number();
    float value();  // of a BSDF: not below 0

private:
    const char *at_, *end_;
    const std::string& place_;
};

}  // namespace scene
