// SPDX-License-Identifier: BSD-3-Clause
// .cal function files: parsed by the host, compiled to flat code for the register VM of kernels/cal/cal_vm.h.
// One program per primitive: its real arguments (A1..), its transform and everything constant are folded in.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>
#include "base/find_file.h"
#include "base/xform.h"

namespace cal {

// Loaded files, parsed once each: name -> definitions.  rayinit.cal's functions are built in, as are skybright.cal,
// perezlum.cal (written from the formulas); a user's file of the same name on RAYPATH wins.
class Library {
public:
    explicit Library(const base::ReadOptions& files);
    ~Library();
    void define(const std::string& text, const std::string& place);       // -e: definitions for the global context
    void define_file(const std::string& file, const std::string& place);  // -f: the same from a file on RAYPATH
    struct State;
    State& state() { return *state_; }

private:
    std::unique_ptr<State> state_;
};

// Ways in which a program's value depends on the viewer.
constexpr unsigned READS_RAY = 1;    // the ray's direction or length, or its angle with the surface
constexpr unsigned READS_TOTAL = 2;  // the whole way from the eye
constexpr unsigned READS_PLACE = 4;  // the point; of what is far away, where the ray began

// Flat output shared by all programs of a scene.  The two vectors are the device's arenas u and f themselves (programs
// hold absolute indices into both): append to them, or start the arenas with them.
struct Code {
    std::vector<uint32_t> words;             // instructions, table headers, glyphs
    std::vector<float> floats;               // data arrays, pictures
    std::map<std::string, uint32_t> tables;  // files already in the arenas
    unsigned reads = 0;                      // READS_*: what programs have read since this was set to 0
};

// Compiles `outputs` (expressions such as "skybr" or "red(r,g,b)") in the context of file `cal_file` ("." = global)
// with real arguments `args` and the object transform `xform` (object -> world: programs get world coordinates and see
// object coordinates).  $1 .. $27 = the ray variables; $101 $102 $103 = light direction (object coordinates), $104 =
// its solid angle, $105.. = CAL_ARG0.. (cal_vm.h), so that a BRDF function f is the output "f($101,$102,$103,$104)".
// Returns the program's entry: index into code.words.  Throws Error at `place`.
uint32_t compile(Library& library, const std::vector<std::string>& outputs, const std::string& cal_file,
                 const std::vector<double>& args, const base::Xform& xform, const std::string& place, Code& code);

}  // namespace cal
