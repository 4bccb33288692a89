// SPDX-License-Identifier: BSD-3-Clause
// The newest picture as a file, as bytes.
#pragma once
#include <string>
#include "image/picture.h"

namespace live {

// kind: "hdr" (RGBE) or "exr" (32-bit floats), with the picture's header.  Empty: no such kind.  Throws Error.
std::string picture_file(const image::Picture& picture, const std::string& kind);

}  // namespace live
