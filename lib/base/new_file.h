// SPDX-License-Identifier: BSD-3-Clause
// How a file is made and takes another one's place (tempfile.h).
#pragma once
#include <cstdint>
#include <string>

namespace base {

uint64_t random_bits();  // of the system, which nobody can guess
// Where a symbolic link leads, also if nothing is there yet.
std::string end_of_links(std::string path);

// -1: errno says why.  A file or link that is there already is not opened.
int make_new(const std::string& path, unsigned permissions);
int open_to_write(const std::string& path);            // what is there: a FIFO, a device
void take_permissions(int fd, const std::string& of);  // and the owner, as far as we may
// False: errno says why.
bool close_written(int fd);
bool replace_file(const std::string& path, const std::string& target);  // in one step
void remove_file(const char* path);                                     // async-signal-safe

}  // namespace base
