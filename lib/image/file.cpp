// SPDX-License-Identifier: BSD-3-Clause
// Whole files, their format chosen by the ending of their name.
#include <algorithm>
#include <cctype>
#include <cerrno>

#include "base/error.h"
#include "base/file_status.h"
#include "base/split.h"
#include "base/tempfile.h"
#include "image/file_format.h"
#include "image/stream.h"

namespace image {

std::string ending_of(const std::string& path) {
    const size_t slash = path.rfind('/');
    const size_t dot = path.rfind('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
    std::string e = path.substr(dot);
    for (char& c : e) c = char(std::tolower((unsigned char)c));
    return e;
}

namespace {
// ".hdr, .pic or .exr"
std::string one_of(const std::vector<std::string>& endings) {
    std::string text = endings[0];
    for (size_t k = 1; k < endings.size(); ++k) text += (k + 1 < endings.size() ? ", " : " or ") + endings[k];
    return text;
}
}  // namespace

void require_writable_ending(const std::string& path, const std::vector<std::string>& more) {
    std::vector<std::string> all = base::split_words(endings());
    all.insert(all.end(), more.begin(), more.end());
    if (std::find(all.begin(), all.end(), ending_of(path)) == all.end())
        base::fail(path, "the ending of the name must be " + one_of(all));
    const base::FileKind there = base::status_of(path).kind;
    if (there != base::FileKind::none && there != base::FileKind::ordinary) return;  // a FIFO is written where it is
    const size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    errno = 0;
    if (!base::may_write_in(folder)) base::fail_system(path, "cannot be written");
}

void write_bytes(const std::string& path, const std::string& bytes) {
    base::TempFile temp(path);
    temp.write(bytes.data(), bytes.size());
    temp.keep();
}

Picture read_file(const std::string& path, Pixels pixels, const base::Opener& by) {
    StreamReader in(path, pixels, by);
    Picture picture;
    in.next(picture);
    Picture further;
    if (in.next(further)) base::fail(path, "holds several pictures, but one was expected");
    return picture;
}

void write_file(const std::string& path, const Picture& picture, const WriteOptions& options) {
    require_writable_ending(path);
    format_by_ending(ending_of(path))->write(path, picture, options);
}

}  // namespace image
