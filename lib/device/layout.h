// SPDX-License-Identifier: BSD-3-Clause
// Do a device's kernels lay out the records that they share with the host (kernels/records.h) as the host does?
#pragma once
#include <array>
#include <cerrno>
#include <string>

#include "base/error.h"
#include "kernels/dialect/host.h"

namespace device {

#define RECORD(type) +1
using RecordSizes = std::array<uint32_t, RECORDS>;
#undef RECORD

// of_device: fills in the sizes that the device gives.
template <class F>
void require_same_layout(const std::string& where, F&& of_device) {
    RecordSizes here{}, there{};
    kernels::record_sizes(here.data());
    of_device(there);
    errno = 0;
    if (here != there) base::fail_system(where, "the device lays out structures differently");
}

}  // namespace device
