// SPDX-License-Identifier: BSD-3-Clause
// See against.h.
#include "live/against.h"

#include <fstream>

namespace live {

Against::Against(std::string file, Live& live) : file_(std::move(file)), live_(live) {
    std::string asked;
    std::getline(std::ifstream(file_), asked);
    if (asked == "first") word_ = asked;
    else if (!asked.empty() && asked != "previous") live_.change([&](Design& d) { d.base = asked; });
}

void Against::say() {
    if (file_.empty()) return;
    const std::string now = live_.ask([&](const Design& d) {
        const Design::Variant* base = d.variant(d.base);
        return base && base->edit >= 0 ? std::to_string(base->edit) : word_;
    });
    if (now == said_) return;
    said_ = now;
    std::ofstream(file_) << now;
}

}  // namespace live
