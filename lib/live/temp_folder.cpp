// SPDX-License-Identifier: BSD-3-Clause
// See temp_folder.h.
#include "live/temp_folder.h"

#include <stdlib.h>
#include <unistd.h>  // macOS has mkdtemp there

#include <cerrno>

#include "base/error.h"
#include "image/stream.h"

namespace live {

TempFolder::TempFolder() {
    std::string name = std::filesystem::temp_directory_path() / "vcview.XXXXXX";
    errno = 0;
    if (!mkdtemp(name.data())) base::fail_system(name, "cannot be made");
    path_ = name;
}

TempFolder::~TempFolder() {
    std::error_code gone;
    std::filesystem::remove_all(path_, gone);
}

std::string TempFolder::write(const std::string& of, const std::string& text) const {
    image::write_bytes(name(of), text);
    return name(of);
}

}  // namespace live
