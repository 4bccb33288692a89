// SPDX-License-Identifier: BSD-3-Clause
// Writes commands to a FIFO that a renderer reads, without ever waiting for it.
#pragma once
#include <string>

namespace live {

enum class Written { whole, busy, nobody };
// All bytes, or none: `busy` where what has not been read yet leaves no room for them.
Written write_whole(const std::string& fifo, const std::string& bytes);

}  // namespace live
