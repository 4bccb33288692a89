// SPDX-License-Identifier: BSD-3-Clause
// vcregion without the tracer's libraries: regions by shape alone.
#include "base/error.h"
#include "visibility/visibility.h"

namespace visibility {

std::unique_ptr<region::SceneView> open_scene(const std::vector<std::string>& files, const base::ReadOptions&) {
    if (files.empty()) return nullptr;
    base::fail(files[0], "this vcregion was built without the tracer (LUXPIPE_PTRACE=OFF) and reads no scenes");
}

}  // namespace visibility
