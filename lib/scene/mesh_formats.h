// SPDX-License-Identifier: BSD-3-Clause
// The readers behind read_mesh().
#pragma once
#include "scene/mesh.h"
#include "scene/source.h"

namespace scene {

void read_rtm(Source& in, const Limits& limits, Mesh& mesh);
void read_obj(Source& in, Mesh& mesh);

}  // namespace scene
