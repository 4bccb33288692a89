// SPDX-License-Identifier: BSD-3-Clause
// The one exception of the libraries, and the one way to warn.
// A message reads "tool: place: fact"; the library knows place and fact, base::run() adds the tool.
// lib/ throws and warns, it never prints and never exits.
#pragma once
#include <exception>
#include <string>
#include <utility>

namespace base {

enum class Kind { input = 1, system = 2 };  // also the exit status

struct Error : std::exception {
    Kind kind;
    std::string where;    // "office.rad:14", "-vp", "stdin"; may be empty
    std::string message;  // 'modifier "glas" is not defined'
    std::string text;     // where: message
    Error(Kind k, std::string place, std::string fact)
        : kind(k),
          where(std::move(place)),
          message(std::move(fact)),
          text(where.empty() ? message : where + ": " + message) {}
    const char* what() const noexcept override { return text.c_str(); }
};

[[noreturn]] inline void fail(std::string where, std::string fact) {
    throw Error(Kind::input, std::move(where), std::move(fact));
}
[[noreturn]] void fail_system(std::string where, std::string fact);  // appends strerror(errno) if errno is set

// Warnings are collected by cause (the fact) and printed by base::run(): the first place at once,
// further ones of the same cause only counted and summed up at the end.  Thread safe.
void warn(std::string where, std::string fact);

}  // namespace base
