// SPDX-License-Identifier: BSD-3-Clause
// The files of the plan as they change: those of its points, and the sum of what is rendered there.
#pragma once
#include <vector>
#include "base/file_status.h"
#include "live/live.h"
#include "live/sources.h"

namespace live {

class PointFiles {
public:
    explicit PointFiles(const PlanOptions& options) : options_(options) {}
    void look(Live& live);  // at the clock's pace

private:
    const PlanOptions& options_;
    base::FileStamp sum_;
    std::vector<base::FileStamp> points_;
};

}  // namespace live
