// SPDX-License-Identifier: BSD-3-Clause
// The files that this process has read, for rules of make (ptrace -M); every function that opens one by name notes it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include "base/file_stamp.h"

namespace base {

void note_file_read(const std::string& path);
// Nothing stands under this name; a file that comes to be there would have been read.
void note_file_missed(const std::string& path);

// One of the files noted, as it was the first time.
struct FileNote {
    std::string path;
    FileStamp stamp;
    uint64_t overlay;  // overlay_number()
    bool read;         // false: missed
    uint64_t noted;    // the last time: files_noted_count() after it
};
// How often a file was noted; the files noted since then.
uint64_t files_noted_count();
std::vector<FileNote> files_noted_since(uint64_t count);
// Notes all of these again, if each file and the text over it are as they were; false: one is not.
bool note_unchanged_files(const std::vector<FileNote>& notes);

// Throws Error (place: the output) if one of these inputs would be replaced by an output.  "-" among the inputs is the
// standard input.
void refuse_to_overwrite(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);
// This one may be replaced: what is written holds all that it holds.
void may_replace(const std::string& path);

// Each once, in the order in which they were first read.
std::vector<std::string> files_read();

// Returns the paths noted so far and forgets them, for a program that reads files again (ptrace -watch).
std::vector<std::string> forget_files_read();

// The files noted as they are on the disk now, compared with when they were noted.
struct FilesNow {
    bool changed = false;  // another file, size or time of change; come to be or gone
    bool gone = false;     // one of them is not there any more, or has become empty
    uint64_t state = 0;    // equal for equal states
    size_t count = 0;
};
FilesNow files_now();

// "target: file file", and an empty rule for each file, so that make does not stop where one has been removed.
std::string make_rule(const std::string& target, const std::vector<std::string>& files);

}  // namespace base
