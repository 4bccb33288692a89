// SPDX-License-Identifier: BSD-3-Clause
// See point_files.h.
#include "live/point_files.h"

#include "base/error.h"
#include "image/points.h"
#include "image/stream.h"

namespace live {

namespace {

std::vector<base::FileStamp> stamps_of(const std::vector<std::string>& points) {
    std::vector<base::FileStamp> out;
    for (const std::string& path : points) {
        out.push_back(base::stamp_of(path));
        try {
            for (const image::PointFile& file : image::point_files({path})) out.push_back(base::stamp_of(file.path));
        } catch (const base::Error&) {  // a folder without points: ptrace says so
        }
    }
    return out;
}

}  // namespace

void PointFiles::look(Live& live) {
    if (options_.sum.empty()) return;
    if (const base::FileStamp now = base::stamp_of(options_.sum); !(now == sum_)) {
        sum_ = now;
        try {
            live.put_picture(Which::plan, image::read_file(options_.sum));
        } catch (const base::Error&) {  // it is gone
        }
    }
    if (std::vector<base::FileStamp> now = stamps_of(options_.points); now != points_) {
        if (!points_.empty()) live.put(PointsChanged{});
        points_ = std::move(now);
    }
}

}  // namespace live
