// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target of data files and fonts: any bytes as one or the other (by the first byte), then looked up.
#include "base/error.h"
#include "cal/ops.h"
#include "cal/pattern.h"
#include "fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (size < 1 || size > 100000) return 0;
    const FuzzFile file(data + 1, size - 1);
    cal::Library library({});
    cal::Code code;
    cal::PatternSpec spec;
    spec.place = "fuzz";
    if (data[0] & 1) {
        spec.type = "brighttext";
        spec.strings = {file.path(), ".", "AB", "z", "I   A"};
        spec.reals = {0, 1, 0, 1, 0, 0, 0, -1, 0, .25, 1, data[0] / 64.0 - 2};
    } else {
        spec.type = "brightdata";
        spec.strings = {"noop", file.path(), "."};
        for (int i = 0; i <= data[0] / 64; i++) spec.strings.push_back("Px");
    }
    try {
        const cal::Program program = cal::compile_pattern(library, spec, code);
        cal::device::SceneTables tables{};
        tables.u = code.words.data();
        tables.f = code.floats.data();
        float vars[cal::device::CAL_VARS] = {}, out[CAL_OUTPUTS];
        for (float x : {-1e30f, -2.0f, 0.0f, 0.5f, 3.0f, 1e30f}) {
            vars[cal::device::CAL_PX] = x;
            vars[cal::device::CAL_PY] = 0.5f;
            cal::device::cal_run(&tables, program.entry, vars, out);
        }
    } catch (const base::Error&) {}
    return 0;
}
