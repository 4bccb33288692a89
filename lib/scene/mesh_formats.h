// SPDX-License-Identifier: BSD-3-Clause
// The readers behind read_mesh().
#pragma once
#include "scene/mesh.h"
#include "base/text_reader.h"

namespace scene {

void read_rtm(base::TextReader& in, const Limits& limits, Mesh& mesh);
void read_obj(base::TextReader& in, Mesh& mesh);

}  // namespace scene
