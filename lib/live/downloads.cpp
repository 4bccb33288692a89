// SPDX-License-Identifier: BSD-3-Clause
// See downloads.h.  OpenEXR's writer takes a name, so it writes to a private folder that is removed at once.
#include "live/downloads.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "image/stream.h"

namespace live {

namespace {

class PrivateFolder {
public:
    PrivateFolder() {
        const char* folder = std::getenv("TMPDIR");
        path_ = std::string(folder && *folder ? folder : "/tmp") + "/luxpipe-XXXXXX";
        errno = 0;
        if (!mkdtemp(path_.data())) base::fail_system(path_, "cannot be made");
    }
    ~PrivateFolder() {
        unlink(file().c_str());
        rmdir(path_.c_str());
    }
    std::string file() const { return path_ + "/picture.exr"; }

private:
    std::string path_;
};

}  // namespace

std::string picture_file(const image::Picture& picture, const std::string& kind) {
    if (kind == "hdr") return image::picture_bytes(picture, image::Format::rgbe);
    if (kind != "exr") return "";
    const PrivateFolder folder;
    image::write_exr(folder.file(), picture);
    std::ifstream in(folder.file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace live
