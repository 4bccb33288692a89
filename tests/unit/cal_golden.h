// SPDX-License-Identifier: BSD-3-Clause
// Rows of tests/golden/cal.tsv and the ray they are evaluated on; the same for the host and the OpenCL test.
#pragma once
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>
#include "base/error.h"
#include "cal/compile.h"
#include "cal/ops.h"

struct Row {
    std::string id, text;
    float p[3];
    double value;
};

inline std::vector<Row> golden_rows() {
    std::ifstream file(LUXPIPE_TESTS "/golden/cal.tsv");
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::stringstream words(line);
        std::string field[6];
        for (std::string& f : field) std::getline(words, f, '\t');
        Row r;
        r.id = field[0];
        for (int i = 0; i < 3; i++) r.p[i] = std::strtof(field[1 + i].c_str(), nullptr);
        r.text = field[4];
        r.value = std::strtod(field[5].c_str(), nullptr);
        rows.push_back(r);
    }
    return rows;
}

// D = (0 .6 -.8), N = (0 0 1), T = Ts = 1, Rdot = .8
inline std::vector<float> golden_vars(const float* p) {
    using namespace cal::device;
    std::vector<float> vars(CAL_VARS, 0.0f);
    vars[CAL_DY] = 0.6f;
    vars[CAL_DZ] = -0.8f;
    vars[CAL_NZ] = 1;
    for (int i = 0; i < 3; i++) vars[CAL_PX + i] = p[i];
    vars[CAL_T] = vars[CAL_TS] = 1;
    vars[CAL_RDOT] = 0.8f;
    return vars;
}

inline bool four_digits(double got, double want) { return std::fabs(got - want) <= 1e-4 * std::fabs(want) + 1e-6; }

inline uint32_t compile_one(cal::Library& library, const std::string& text, cal::Code& code,
                            const std::string& file = ".", const std::vector<double>& args = {5, 7},
                            const base::Xform& xform = base::Xform()) {
    return cal::compile(library, {text}, file, args, xform, "test", code);
}

// Runs a program on the host; NAN if it ends with an error.
inline float run_one(const cal::Code& code, uint32_t entry, const std::vector<float>& vars) {
    cal::device::SceneTables tables{};
    tables.u = code.words.data();
    tables.f = code.floats.data();
    float out[CAL_OUTPUTS] = {};
    return cal::device::cal_run(&tables, entry, vars.data(), out) ? NAN : out[0];
}
