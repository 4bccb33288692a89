// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target of the .cal reader and compiler: any bytes as a function file; every name it defines is then compiled as
// a pattern and run once.  Anything but a clean result or base::Error is a bug.
#include <cstring>
#include "base/error.h"
#include "cal/library.h"
#include "cal/ops.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (size > 20000) return 0;
    const std::string text(reinterpret_cast<const char*>(data), size);
    cal::Library library({});
    cal::Code code;
    try {
        library.define(text, "fuzz");
        cal::Pool pool;
        int names = 0;
        for (const cal::Definition& d : cal::parse_definitions(text, "fuzz", pool)) {
            if (names++ > 4) break;
            std::string call = d.name;
            if (d.is_function) {
                call += "(Px";
                for (size_t i = 1; i < d.parameters.size(); i++) call += ",Py";
                call += ")";
            }
            try {
                const uint32_t entry = cal::compile(library, {call}, ".", {1, 2, 3}, base::Xform(), "fuzz", code);
                cal::device::SceneTables tables{};
                tables.u = code.words.data();
                tables.f = code.floats.data();
                float vars[cal::device::CAL_VARS] = {}, out[CAL_OUTPUTS];
                vars[cal::device::CAL_PX] = 0.5f;
                cal::device::cal_run(&tables, entry, vars, out);
            } catch (const base::Error&) {}
        }
    } catch (const base::Error&) {}
    return 0;
}
