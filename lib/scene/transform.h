// SPDX-License-Identifier: BSD-3-Clause
// The xform command: its words, its arrays, and what one transform does to each type of primitive.
#pragma once
#include <functional>
#include <string>
#include <vector>
#include "scene/primitive.h"

namespace scene {

// One run of xform, arrays and -f files replaced.
struct Transform {
    std::string prefix;    // -n ("a.b"); names of surfaces become prefix.name
    std::string modifier;  // -m; for surfaces only
    bool invert = false;   // -I
    Xform matrix;
    std::vector<std::string> words;  // the transform's own words, for string arguments of functions
};
void apply(const Transform& t, Primitive& p);

struct XformCommand {
    std::vector<std::string> files;  // none: the input of the pipe
    std::vector<std::string> words;  // the options
};
// words[0] is "xform".
XformCommand parse_xform_command(const std::vector<std::string>& words, const std::string& place);
// Calls body for each copy that -f and -a make, in the order of the output.
using OpenFile = std::function<std::string(const std::string& name)>;  // text of an -f file
void each_copy(const XformCommand& command, const std::string& place, uint64_t limit, const OpenFile& read_text,
               const std::function<void(const Transform&)>& body);

}  // namespace scene
