// SPDX-License-Identifier: BSD-3-Clause
// Nanoseconds per evaluation of compiled .cal programs on the host: best of 20 batches of one core's time.
// Usage: bench_cal_vm     (the same text on OpenCL is part of a frame's time: see bench of ptrace)
#include <algorithm>
#include <cstdio>
#include <ctime>
#include "cal/compile.h"
#include "cal/ops.h"

static double nanoseconds() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * double(t.tv_sec) + double(t.tv_nsec);
}

int main() {
    const struct {
        const char *name, *text, *file;
        std::vector<double> args;
    } programs[] = {
        {"clear sky", "skybr", "skybright.cal", {1, 24, 29, 1.365, -.057, -.323, .945}},
        {"intermediate sky", "skybr", "skybright.cal", {4, 24, 29, 1.365, -.057, -.323, .945}},
        {"Perez sky", "skybright", "perezlum.cal", {37, 35, -.95, -.22, 17.4, -3.93, .685, -.057, -.323, .945}},
        {"noise3", "noise3(Px,Py,Pz)", ".", {}},
        {"turbulence", "turbulence(Px,Py,Pz,.1)", ".", {}},
        {"constant", "1", ".", {}},
    };
    using namespace cal::device;
    for (const auto& p : programs) {
        cal::Library library({});
        cal::Code code;
        const uint32_t entry = cal::compile(library, {p.text}, p.file, p.args, base::Xform(), p.name, code);
        SceneTables tables{};
        tables.u = code.words.data();
        tables.f = code.floats.data();
        float vars[CAL_VARS] = {}, out[CAL_OUTPUTS], sum = 0;
        const int count = 20000;
        double best = 1e30;
        for (int batch = 0; batch < 20; batch++) {
            const double start = nanoseconds();
            for (int i = 0; i < count; i++) {
                const float t = float(i) / float(count);
                vars[CAL_DX] = 0.6f * t;
                vars[CAL_DY] = 0.8f * t;
                vars[CAL_DZ] = sqrt_(1 - t * t);
                vars[CAL_PX] = 7 * t;
                vars[CAL_PY] = 3 * t;
                cal_run(&tables, entry, vars, out);
                sum += out[0];
            }
            best = std::min(best, (nanoseconds() - start) / count);
        }
        std::printf("%-18s %7.1f ns  %4zu words  (mean %g)\n", p.name, best, code.words.size(),
                    double(sum) / (20.0 * count));
    }
}
