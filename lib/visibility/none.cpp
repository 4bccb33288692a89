// SPDX-License-Identifier: BSD-3-Clause
// Without the tracer's libraries: no scene is read.
#include "base/error.h"
#include "visibility/visibility.h"

namespace visibility {

std::unique_ptr<region::SceneView> open_scene(const std::vector<std::string>& files, const base::ReadOptions&) {
    if (files.empty()) return nullptr;
    base::fail(files[0], "this program was built without the tracer (LUXPIPE_PTRACE=OFF) and reads no scenes");
}

}  // namespace visibility
