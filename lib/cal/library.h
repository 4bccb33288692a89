// SPDX-License-Identifier: BSD-3-Clause
// A Library holds contexts of definitions.  A file "sky.cal" fills the context "sky"; the global context ""
// has rayinit.cal's functions and what -e and -f define.  A name is looked up in its own context, then globally;
// "x`" is global only, "`x" local only, "x`ctx" (or "x`ctx.") names its context.
#pragma once
#include <string>
#include <unordered_map>
#include <unordered_set>
#include "cal/compile.h"
#include "cal/expr.h"

namespace cal {

struct Library::State {
    base::ReadOptions files;
    Pool pool;
    std::unordered_map<std::string, std::unordered_map<std::string, Definition>> contexts;
    std::unordered_set<std::string> loaded;

    // Adds text to a context; `warn` on redefinition (not for built-in texts).
    void add(std::string_view text, const std::string& file, const std::string& context, bool warn);
    // The same from a file on RAYPATH, or from our own text of that name.
    void add_file(const std::string& file, const std::string& context, const std::string& place, bool warn);
    // Loads a function file once and returns its context; "." is the global one.  Throws Error(place).
    std::string load(const std::string& file, const std::string& place);
    const Definition* lookup(const std::string& name, const std::string& context) const;
};

// Our own texts of RADIANCE's library files, by name; null if there is none (builtin_files.cpp).
const char* builtin_file(const std::string& name);
extern const char* const rayinit_text;  // builtin_rayinit.cpp

std::string read_text(const std::string& path, size_t limit, const std::string& place);

}  // namespace cal
