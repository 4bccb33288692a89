// SPDX-License-Identifier: BSD-3-Clause
// The fuzzer's bytes as the only file of an empty folder in memory: for readers of files that name other files.
#pragma once
#include <stdlib.h>
#include <unistd.h>
#include <cstdio>
#include <string>

// The working directory becomes a fresh folder (left behind for the system to clean: libFuzzer never returns).
inline void write_alone(const char* name, const std::string& text) {
    static const bool moved = [] {
        char path[] = "/dev/shm/fuzz.XXXXXX";
        return mkdtemp(path) && chdir(path) == 0;
    }();
    FILE* f = moved ? fopen(name, "wb") : nullptr;
    if (!f || fwrite(text.data(), 1, text.size(), f) != text.size() || fclose(f) != 0) abort();
}
