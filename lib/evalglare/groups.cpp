// SPDX-License-Identifier: BSD-3-Clause
// Groups of bright pixels by evalglare's two walks: joining, merging, and peaks that leave their group.
#include "evalglare/groups.h"
#include <algorithm>

namespace evalglare {

// The order of factors is evalglare's, which is not the same in both.
void GroupSums::add(double L, double w, int px, int py) {
    const double power = lum * omega + L * w;
    x = (x * lum * omega + px * w * L) / power;
    y = (y * lum * omega + py * w * L) / power;
    lum = power / (omega + w);
    omega += w;
    pixels += 1;
    brightest = std::max(brightest, L);
}

void GroupSums::remove(double L, double w, int px, int py) {
    const double power = lum * omega - L * w;
    x = (x * omega * lum - px * w * L) / power;
    y = (y * omega * lum - py * w * L) / power;
    lum = power / (omega - w);
    omega -= w;
    pixels -= 1;
}

Groups::Groups(const Geometry& g, double search_opening)
    : geometry_(g),
      search_(g),
      opening_(float(search_opening)),
      radius_(search_.radius(opening_)),
      group_(g.omega.size(), 0),
      sums_(1),
      members_(1) {}

// Columns from the left, in a column from the bottom.
uint32_t Groups::column_key(uint32_t p) const {
    return uint32_t(geometry_.x_of(p)) * uint32_t(geometry_.height) + uint32_t(geometry_.y_of(p));
}

void Groups::sort_by_column(std::vector<uint32_t>& pixels) const {
    std::sort(pixels.begin(), pixels.end(), [&](uint32_t a, uint32_t b) { return column_key(a) < column_key(b); });
}

void Groups::start(const std::vector<Run>& pixels) {
    for (const uint32_t p : pixels_) group_[p] = 0;
    pixels_.clear();
    sums_.assign(1, {});
    members_.assign(1, {});
    for (const Run& r : pixels)
        for (uint32_t p = r.start; p < r.start + r.length; ++p) pixels_.push_back(p);
    sort_by_column(pixels_);
}

uint32_t Groups::open() {
    sums_.emplace_back();
    members_.emplace_back();
    return count();
}

void Groups::count_too(uint32_t p, uint32_t group, const CheckPicture& lum) {
    sums_[group].add(lum.at(p), geometry_.omega[p], geometry_.x_of(p), geometry_.y_of(p));
}

void Groups::add(uint32_t p, uint32_t group, const CheckPicture& lum) {
    pixels_.push_back(p);
    join(p, group, lum);
}

void Groups::join(uint32_t p, uint32_t group, const CheckPicture& lum) {
    sums_[group].add(lum.at(p), geometry_.omega[p], geometry_.x_of(p), geometry_.y_of(p));
    group_[p] = group;
    members_[group].push_back(p);
}

void Groups::leave(uint32_t p, const CheckPicture& lum) {
    sums_[group_[p]].remove(lum.at(p), geometry_.omega[p], geometry_.x_of(p), geometry_.y_of(p));
}

void Groups::find(const std::vector<Run>& bright, const CheckPicture& lum, bool shortcut, bool merge_too) {
    start(bright);
    for (const uint32_t p : pixels_) {
        uint32_t group =
            shortcut && follows_bright(p) ? group_[geometry_.index(geometry_.x_of(p), geometry_.y_of(p) - 1)] : 0;
        if (!group) group = group_in_reach(p);
        join(p, group ? group : open(), lum);
    }
    if (merge_too) merge(pixels_, 1, true, lum);
}

void Groups::take(const std::vector<Run>& grouped, uint32_t groups, const CheckPicture& lum) {
    start(grouped);
    std::vector<uint32_t> wanted(group_.size(), 0);
    for (const Run& r : grouped) std::fill_n(wanted.begin() + r.start, r.length, r.group);
    std::vector<uint32_t> by_row = pixels_;
    std::sort(by_row.begin(), by_row.end(), [&](uint32_t a, uint32_t b) {
        const int ya = geometry_.y_of(a), yb = geometry_.y_of(b);
        return ya != yb ? ya < yb : a < b;
    });
    while (count() < groups) open();
    for (const uint32_t p : by_row) {
        while (count() < wanted[p]) open();  // a pixel in the last row can have the number after the last patch's
        join(p, wanted[p], lum);
    }
}

bool Groups::follows_bright(uint32_t p) const {
    const int y = geometry_.y_of(p);
    return y > 0 && group_[geometry_.index(geometry_.x_of(p), y - 1)] != 0;
}

// A group found above the pixel takes precedence over one found below.
uint32_t Groups::group_in_reach(uint32_t p) const {
    uint32_t found = 0;
    const int x = geometry_.x_of(p);
    search_.around(x, geometry_.y_of(p), radius_, x, [&](size_t q) {
        if (group_[q]) found = group_[q];
        return group_[q] != 0;
    });
    return found;
}

uint32_t Groups::larger_in_reach(uint32_t p, uint32_t from_group) const {
    uint32_t found = 0;
    double largest = sums_[group_[p]].omega;
    search_.around(geometry_.x_of(p), geometry_.y_of(p), radius_, geometry_.width - 1, [&](size_t q) {
        const uint32_t group = group_[q];
        if (group < from_group || !(sums_[group].omega > largest)) return false;
        found = group;
        largest = sums_[group].omega;
        return true;
    });
    return found;
}

bool Groups::surrounded(uint32_t p) const {
    const int x = geometry_.x_of(p), y = geometry_.y_of(p);
    if (!(x > 1 && x < geometry_.width - 2 && y > 1 && y < geometry_.height - 2)) return false;
    for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
            if (group_[geometry_.index(x + dx, y + dy)] != group_[p]) return false;
    return true;
}

// Whole passes until one changes nothing.  A group is dissolved into a strictly larger one, never into its equal.
void Groups::merge(const std::vector<uint32_t>& pixels, uint32_t from_group, bool skip_surrounded,
                   const CheckPicture& lum) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const uint32_t p : pixels) {
            if (skip_surrounded && surrounded(p)) continue;
            const uint32_t larger = larger_in_reach(p, from_group);
            if (!larger) continue;
            const uint32_t own = group_[p];
            std::vector<uint32_t> moving;
            moving.swap(members_[own]);
            sort_by_column(moving);
            sums_[own] = {};
            for (const uint32_t q : moving) join(q, larger, lum);
            changed = true;
        }
    }
}

// The last group seen wins.  Each half ends at the first row without a pixel in reach.  By a slip of evalglare's the
// columns end at the picture's height: a pixel beyond finds nothing.
uint32_t Groups::peak_in_reach(uint32_t p, const AngularRadius& radius, uint32_t from_group) const {
    const int x = geometry_.x_of(p), y = geometry_.y_of(p), last = std::min(geometry_.width, geometry_.height) - 1;
    const Vec3 from = search_.direction(p);
    if (x > last) return 0;
    uint32_t found = 0;
    const auto row_has_any = [&](int row) {
        const size_t start = geometry_.index(0, row);
        const auto near = [&](int c) { return radius.holds(dot(from, search_.direction(start + c))); };
        const auto look = [&](int c) {
            if (group_[start + c] >= from_group) found = group_[start + c];
        };
        int left = x, right = x + 1;
        for (; left >= 0 && near(left); --left) look(left);
        for (; right <= last && near(right); ++right) look(right);
        return left < x || right > x + 1;
    };
    for (int row = y; row >= 0 && row_has_any(row); --row) {}
    for (int row = y + 1; row < geometry_.height && row_has_any(row); ++row) {}
    return found;
}

void Groups::extract_peaks(const CheckPicture& lum, double limit) {
    if (std::none_of(sums_.begin(), sums_.end(), [&](const GroupSums& s) { return s.brightest > limit; })) return;
    const AngularRadius half = search_.radius(opening_ / 2);
    const uint32_t before = count();
    for (uint32_t group = 1; group <= before; ++group) {
        if (!(sums_[group].pixels > 0 && sums_[group].brightest >= limit)) continue;
        std::vector<uint32_t>& members = members_[group];
        const auto peak = std::partition(members.begin(), members.end(), [&](uint32_t p) { return lum.at(p) < limit; });
        std::vector<uint32_t> peaks(peak, members.end());
        members.erase(peak, members.end());
        sort_by_column(peaks);
        const uint32_t first = count() + 1;
        for (const uint32_t p : peaks) {
            const uint32_t found = peak_in_reach(p, half, first);
            leave(p, lum);
            join(p, found ? found : open(), lum);
        }
        merge(peaks, first, false, lum);
    }
}

std::vector<Run> Groups::runs() const {
    std::vector<uint32_t> order = pixels_;
    std::sort(order.begin(), order.end());
    std::vector<Run> out;
    for (const uint32_t p : order) {
        if (!out.empty() && out.back().group == group_[p] && out.back().start + out.back().length == p &&
            p % uint32_t(geometry_.width) != 0)
            ++out.back().length;
        else out.push_back({p, 1, group_[p]});
    }
    return out;
}

}  // namespace evalglare
