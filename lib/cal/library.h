// SPDX-License-Identifier: BSD-3-Clause
// A Library holds contexts of definitions.  A file "sky.cal" fills the context "sky"; the global context ""
// has rayinit.cal's functions and what -e and -f define.  A name is looked up in its own context, then globally;
// "x`" is global only, "`x" local only, "x`ctx" (or "x`ctx.") names its context.
#pragma once
#include <string>
#include <unordered_map>
#include "cal/compile.h"
#include "cal/expr.h"

namespace cal {

struct Library::State {
    base::ReadOptions files;
    Pool pool;
    std::unordered_map<std::string, std::unordered_map<std::string, Definition>> contexts;
    std::unordered_map<std::string, std::string> loaded;  // by path: the context that it fills

    // Adds text to a context; `warn` on redefinition (not for built-in texts).
    void add(std::string_view text, const std::string& file, const std::string& context, bool warn);
    // Binds names of definitions that are global where they are used, and the context's only further down.
    void bind(std::vector<Definition>& list, const std::string& context);
    // The same as add() from a file, or from our own text of that name; path: what look_for_file() found.
    void add_file(const std::string& file, const std::string& path, const std::string& context,
                  const std::string& place, bool warn);
    void add_global_file(const std::string& file, const std::string& place, bool warn) {
        add_file(file, base::look_for_file(file, files, place), "", place, warn);
    }
    // Loads a function file once and returns its context; "." is the global one.  Throws Error(place).
    std::string load(const std::string& file, const std::string& place);
    const Definition* lookup(const std::string& name, const std::string& context) const;
};

// Our own texts of RADIANCE's library files, by name; null if there is none (builtin_files.cpp).
const char* builtin_file(const std::string& name);
extern const char* const rayinit_text;  // builtin_rayinit.cpp

std::string read_text(const std::string& path, size_t limit, const base::Opener& by);

}  // namespace cal
