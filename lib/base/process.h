// SPDX-License-Identifier: BSD-3-Clause
// Setup of every program before it reads its options: streams, stack, the words of its command line, its own path.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace base {

void ready_standard_files();

// The stack that the limits of our readers need (expressions nested a thousand deep): the usual default of systems.
constexpr size_t enough_stack = size_t(8) << 20;
// Calls body here, or, where `ulimit -s` leaves less stack, in a thread with a stack of its own.  It must not throw.
void with_enough_stack(const std::function<void()>& body);

// The words of the command line, the first being the program.
std::vector<std::string> typed_words(int argc, char** argv);
std::string program_file();  // the path of the program that runs

}  // namespace base
