// SPDX-License-Identifier: BSD-3-Clause
// Rows of tests/golden/cal_patterns.tsv and cal_skies.tsv: a pattern primitive, where it is asked, RADIANCE's answer.
#pragma once
#include "cal/pattern.h"
#include "unit/cal_golden.h"

struct PatternRow {
    std::string id;
    cal::PatternSpec spec;
    std::vector<float> vars;
    std::vector<double> want;
};

inline std::vector<PatternRow> pattern_rows(const std::string& name, bool directions) {
    std::ifstream file(LUXPIPE_TESTS "/golden/" + name);
    std::vector<PatternRow> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::stringstream columns(line);
        std::string field[6], word;
        for (std::string& f : field) std::getline(columns, f, '\t');
        PatternRow r;
        r.id = field[0];
        r.spec.type = field[1];
        r.spec.place = field[0];
        float at[3];
        std::stringstream(field[2]) >> at[0] >> at[1] >> at[2];
        for (std::stringstream s(field[3]); s >> word;)
            if (word != "|") r.spec.strings.push_back(word);
        for (std::stringstream s(field[4]); s >> word;) r.spec.reals.push_back(std::stod(word));
        for (std::stringstream s(field[5]); s >> word;) r.want.push_back(std::stod(word));
        const float origin[3] = {0, 0, 0};
        r.vars = golden_vars(directions ? origin : at);
        for (int i = 0; i < 3; i++) r.vars[size_t(cal::device::CAL_DX + i)] = directions ? at[i] : i < 2 ? 0.0f : -1.0f;
        r.vars[cal::device::CAL_RDOT] = 1;
        rows.push_back(r);
    }
    return rows;
}

inline base::ReadOptions golden_files() {
    base::ReadOptions files;
    files.raypath = {LUXPIPE_TESTS "/golden/cal"};
    return files;
}
