// SPDX-License-Identifier: BSD-3-Clause
// Things that a machine can lack: memory, disk, descriptors, processes, streams, /sys, the right to write.
#pragma once
#include <functional>
#include <string>

#include "dice.h"

namespace breaking {

struct Fault {
    std::string name;
    std::function<bool()> before;  // in the child; false: cannot be had here
    bool small_disk = false;       // the folder lies on a file system with little room left
    bool no_writing = false;       // the folder may be read only
    bool stdout_is_lost = false;   // what is written there can not be compared
};

Fault some_fault(Dice& dice);

// A mount namespace of our own, for small disks and a missing /sys; false where the system does not allow it.
bool enter_namespace();
bool mount_small_disk(const std::string& folder, size_t kilobytes);
void unmount_disk(const std::string& folder);

}  // namespace breaking
