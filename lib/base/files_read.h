// SPDX-License-Identifier: BSD-3-Clause
// The files that were read, as a value: for rules of make (ptrace -M), for programs that read again what has changed
// (-watch), and so that no output replaces one.  Whoever opens a file by name notes it where it is told to
// (base::Opener, ReadOptions::read).
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>
#include "base/overlay.h"

namespace base {

struct FileNote {
    std::string path;
    FileStamp stamp;                          // as it was the first time
    std::shared_ptr<const std::string> text;  // that stood for it then, or null
    bool read;                                // false: missed
};
using FilesRead = std::vector<FileNote>;  // each once, in the order in which they were first noted

void note_file_read(FilesRead& files, const std::string& path, const Overlays& overlays = {});
// Nothing stands under this name; a file that comes to be there would have been read.
void note_file_missed(FilesRead& files, const std::string& path);
void note_files(FilesRead& files, const FilesRead& more);
// The same files as they are on the disk now.
FilesRead noted_now(const FilesRead& files);
// Is each file, and the text over it, as it was?
bool are_unchanged(const FilesRead& files, const Overlays& overlays);
// Of those that were read.
std::vector<std::string> paths_of(const FilesRead& files);

// Throws Error (place: the output) if one of these inputs would be replaced by an output.  "-" among the inputs is the
// standard input.
void refuse_to_overwrite(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

// The files as they are on the disk now, compared with when they were noted.
struct FilesNow {
    bool changed = false;  // another file, size or time of change; come to be or gone
    bool gone = false;     // one of them is not there any more, or has become empty
    uint64_t state = 0;    // equal for equal states
};
FilesNow files_now(const FilesRead& files);

// "target: file file", and an empty rule for each file, so that make does not stop where one has been removed.
std::string make_rule(const std::string& target, const std::vector<std::string>& files);

}  // namespace base
