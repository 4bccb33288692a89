// SPDX-License-Identifier: BSD-3-Clause
// See process.h.
#include "base/process.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <cstdlib>

namespace base {

// Bytes pass as they are, and a console takes UTF-8 and follows what we write to rewrite a line.
void ready_standard_files() {
    _fmode = _O_BINARY;
    for (const int fd : {0, 1, 2}) {
        _setmode(fd, _O_BINARY);
        const HANDLE console = reinterpret_cast<HANDLE>(_get_osfhandle(fd));
        DWORD mode;
        if (fd == 0 || !GetConsoleMode(console, &mode)) continue;
        SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
        SetConsoleOutputCP(CP_UTF8);
    }
}

// The linker gives every thread enough (cmake/windows.cmake).
void with_enough_stack(const std::function<void()>& body) { body(); }

// Names of files have / from here on, and the program its name alone, as headers of pictures have them elsewhere.
std::vector<std::string> typed_words(int argc, char** argv) {
    std::vector<std::string> words(argv, argv + argc);
    for (std::string& word : words) std::replace(word.begin(), word.end(), '\\', '/');
    if (!words.empty())
        words[0] = words[0].substr(words[0].rfind('/') + 1), words[0] = words[0].substr(0, words[0].rfind('.'));
    return words;
}

std::string program_file() {
    char path[1 << 15] = "";
    GetModuleFileNameA(nullptr, path, sizeof path);
    return path;
}

}  // namespace base
