// SPDX-License-Identifier: BSD-3-Clause
// DGPf over the hours of the sky's date.  A second pipe of the same programs renders the scene small, hour by hour,
// while the picture of the page is good enough; it begins anew when the model, the view or the date is another one.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>
#include "live/fifo.h"
#include "live/files.h"
#include "live/live.h"

namespace live {

class Day {
public:
    // control: FIFO of that pipe's ptrace; its first line is the sign to begin.  lines: FIFO of all that the pipe
    // writes; its first line says that it has begun.  Both empty: there is no such pipe.
    Day(std::string control, const std::string& lines, const Files& files, Live& live);
    void look();  // at the clock's pace

private:
    void begin();  // anew, where the model, the view or the date is another one
    bool send(const std::string& bytes);
    void ask_next();
    void take(const std::string& line);
    void show();
    void end_at(int hour);  // there is no light before it, or after it
    std::optional<int> next_hour() const;

    const std::string control_;
    const Files& files_;
    Live& live_;
    Live::Numbers seen_;
    std::optional<FifoLines> lines_;
    enum class Pipe { asleep, called, awake } pipe_ = Pipe::asleep;
    std::vector<std::string> texts_;  // of the files; the sky's at noon
    std::string view_;
    std::optional<size_t> sky_;  // the file with the sky
    bool given_ = false;         // the pipe has these texts
    std::optional<int> asked_;   // an hour, and the edit that it has become
    std::optional<std::string> edit_;
    std::vector<std::string> columns_;
    std::map<std::string, std::array<double, 4>> rows_;  // by edit: DGPf, its interval, Ev
    std::map<int, std::array<double, 4>> hours_;
    bool ends_[2] = {};  // nothing is to come before, after these hours
};

}  // namespace live
