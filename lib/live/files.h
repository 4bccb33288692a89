// SPDX-License-Identifier: BSD-3-Clause
// The text files that the page may change: those that the command line names, and no others.  A writer says which state
// of the file it has read (its tag); a file that somebody else has changed since is left alone.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>
#include "base/error.h"
#include "base/file_status.h"

namespace live {

struct FileNow {
    std::string tag;   // of the contents; "none": there is no such file
    std::string text;  // its bytes
    std::string trouble;
};

class TextFile {
public:
    enum class Kind { regions, scene };
    TextFile(std::string name, Kind its, bool may_write) : path(std::move(name)), kind(its), writable(may_write) {}

    FileNow read() const;
    // False: the file is not what the tag says, and stays as it is.  Throws Error for regions that cannot be read, and
    // where it cannot be written.
    bool write(const std::string& text, const std::string& tag) const;
    // Has the file been replaced or written to since the last call?
    bool changed();

    std::string path;
    Kind kind;
    bool writable;

private:
    std::optional<base::FileStamp> stamp_;  // of the last look
};

using Files = std::vector<TextFile>;
constexpr size_t longest_file = size_t(1) << 20;

}  // namespace live
