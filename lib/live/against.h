// SPDX-License-Identifier: BSD-3-Clause
// What vcmetrics -against compares with, in a file that it reads again: the number of the edit of the base, or the word
// that the file held at the start.
#pragma once
#include <string>
#include "live/live.h"

namespace live {

class Against {
public:
    Against(std::string file, Live& live);  // empty: there is none
    void say();

private:
    const std::string file_;
    Live& live_;
    std::string word_ = "previous", said_;
};

}  // namespace live
