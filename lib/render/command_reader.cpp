// SPDX-License-Identifier: BSD-3-Clause
// See command_reader.h.
#include "render/command_reader.h"

#include <fmt/core.h>

#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"

namespace render {
namespace {

constexpr int patience_for_text_s = 10;
constexpr long most_text = 1 << 26;

// Splits "  next desk " into next and desk.
Command parse(const std::string& line) {
    const char* blanks = " \t\r";
    const size_t from = line.find_first_not_of(blanks);
    if (from == std::string::npos) return {};
    const size_t end = line.find_first_of(blanks, from), rest = line.find_first_not_of(blanks, end);
    if (rest == std::string::npos) return {line.substr(from, end - from), ""};
    return {line.substr(from, end - from), line.substr(rest, line.find_last_not_of(blanks) + 1 - rest)};
}

// BYTES of "overlay FILE BYTES", whose FILE becomes the rest; -1: another line.
long bytes_of_overlay(Command& c) {
    const size_t blank = c.rest.find_last_of(" \t");
    long long bytes;
    if (c.word != "overlay" || blank == std::string::npos) return -1;
    if (!base::parse_integer(c.rest.substr(blank + 1), bytes) || bytes < 0 || bytes > most_text) return -1;
    c.rest.erase(c.rest.find_last_not_of(" \t", blank) + 1);
    return long(bytes);
}

}  // namespace

std::optional<Command> CommandReader::next() {
    using Clock = std::chrono::steady_clock;
    while (!overlay_) {
        const std::optional<std::string> line = pipe_.line();
        if (!line) return std::nullopt;
        Command command = parse(*line);
        if (command.word.empty()) continue;
        overlay_bytes_ = bytes_of_overlay(command);
        if (overlay_bytes_ < 0) return command;
        overlay_ = std::move(command);
        overlay_since_ = Clock::now();
    }
    overlay_->text = pipe_.bytes(size_t(overlay_bytes_));
    if (overlay_->text) return std::exchange(overlay_, std::nullopt);
    if (Clock::now() - overlay_since_ < std::chrono::seconds(patience_for_text_s)) return std::nullopt;
    const std::string file = std::exchange(overlay_, std::nullopt)->rest;
    base::fail(pipe_.path(), fmt::format("the {} bytes for {} did not arrive", overlay_bytes_, base::excerpt(file)));
}

}  // namespace render
