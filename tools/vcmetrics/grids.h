// SPDX-License-Identifier: BSD-3-Clause
// Pictures of points (ptrace -points): numbers of their grids, a row a picture; or a row a point (-each), or rtrace's
// lines (-like rtrace), of the last picture.
#pragma once
#include <optional>
#include <string>
#include "image/picture.h"
#include "options.h"
#include "report/grids.h"

class GridRun {
public:
    explicit GridRun(const Options& options) : o_(options) {}
    bool begun() const { return !columns_.empty(); }
    // The rows as text; true: the run ends.
    bool add(const image::Picture& picture, int64_t frame, double seconds, std::string& text);
    std::string end(int& status) const;  // what is left to print

private:
    const Options& o_;
    std::vector<report::GridColumn> columns_, asked_;
    std::vector<std::string> names_;
    image::GrowingParts parts_;
    image::Picture last_;
    std::vector<uncertainty::NoisyValues> grids_;
    int held_ = 0;
    bool done_ = false;

    void begin(const image::Header& header);
    bool rule_holds(double alpha);
};
