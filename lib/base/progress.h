// SPDX-License-Identifier: BSD-3-Clause
// One line of talk on stderr that is rewritten in place; silent unless stderr is a terminal.
#pragma once
#include <chrono>
#include <string>

namespace base {

class Progress {
public:
    explicit Progress(std::string tool);
    ~Progress();  // removes the line
    bool shown() const { return shown_; }
    bool due() const;                    // true five times a second, if shown: build the text only then
    void show(const std::string& text);  // "tool: text"
    void clear();

private:
    std::string tool_;
    bool shown_, dirty_ = false;
    std::chrono::steady_clock::time_point next_;
};

}  // namespace base
