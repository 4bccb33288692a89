// SPDX-License-Identifier: BSD-3-Clause
// Cells that touch or are near are compared only where a pixel wavers, in all pictures at once (swayed_groups.h).
#include "comfort/swayed_groups.h"

namespace comfort {
namespace {

constexpr uint32_t none = UINT32_MAX;

}  // namespace

SwayedGroups::SwayedGroups(const Geometry& geometry, Connector& connector, std::vector<Stretch>& stretches,
                           int pictures)
    : geometry_(geometry), connector_(connector), pictures_(pictures), all_((Shown(1) << pictures) - 1) {
    if (connector.everything()) {
        nodes_ = 1;
        return;
    }
    std::vector<Stretch> wavering;
    for (const Stretch& s : stretches) {
        if (s.shown == all_) common_.push_back({s.start, s.length, 0});
        else
            for (uint32_t p = 0; p < s.length; ++p) wavering.push_back({s.start + p, 1, s.shown});
    }
    nodes_ = connector.connect(common_);
    stretches.clear();
    for (const Run& r : common_) stretches.push_back({r.start, r.length, all_, r.group});
    if (wavering.empty()) return;
    join_cells(find_cells(wavering));
    stretches.insert(stretches.end(), wavering.begin(), wavering.end());
}

// A cell is one piece: its pixels have one node.  A common pixel that is surrounded by others is never the nearest to
// one that wavers: the rim suffices.
std::vector<SwayedGroups::Pixel> SwayedGroups::find_cells(std::vector<Stretch>& wavering) {
    std::vector<Pixel> pixels;
    const auto note = [&](uint32_t pixel, uint32_t node, Shown shown) {
        const uint32_t c = connector_.cell_of(pixel);
        if (c >= cells_.size()) cells_.resize(c + 1, {none, 0, false});
        Cell& cell = cells_[c];
        if (cell.node == none) cell.node = node == none ? nodes_++ : node;
        cell.shown |= shown;
        cell.wavers |= shown != all_;
        pixels.push_back({pixel, c, shown, {0, 0, 0}});
        return cell.node;
    };
    for (const Connector::RimPixel& p : connector_.rim(common_)) note(p.pixel, common_[p.run].group, all_);
    for (Stretch& s : wavering) s.node = note(s.start, none, s.shown);
    return pixels;
}

void SwayedGroups::join_cells(const std::vector<Pixel>& pixels) {
    std::vector<uint32_t> first(cells_.size() + 1, 0);  // counting sort by cell
    for (const Pixel& p : pixels) ++first[p.cell + 1];
    for (size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    std::vector<Pixel> sorted(pixels.size());
    std::vector<uint32_t> next(first.begin(), first.end() - 1);
    for (const Pixel& p : pixels) sorted[next[p.cell]++] = p;

    parent_.resize(size_t(pictures_) * nodes_);
    for (size_t i = 0; i < parent_.size(); ++i) parent_[i] = uint32_t(i % nodes_);
    for (const bool touching : {true, false})  // near ones last: most are joined by then
        for (size_t c = 0; c < cells_.size(); ++c) {
            if (first[c] == first[c + 1]) continue;
            const Connector::Cell& place = connector_.cells()[c];
            for (const uint32_t o : touching ? place.touching : place.near) {
                if (o >= cells_.size() || first[o] == first[o + 1] || cells_[c].node == cells_[o].node) continue;
                if (!cells_[c].wavers && !cells_[o].wavers) continue;
                const Shown open = cells_[c].shown & cells_[o].shown & apart(cells_[c].node, cells_[o].node);
                if (open)
                    join(&sorted[first[c]], first[c + 1] - first[c], &sorted[first[o]], first[o + 1] - first[o], open);
            }
        }
}

// Two cells, in the pictures of `open`, wherever a pixel of one is within reach of one of the other.
void SwayedGroups::join(Pixel* a, size_t as, Pixel* b, size_t bs, Shown open) {
    const auto direction = [&](Pixel& p) {
        if (p.direction.x == 0 && p.direction.y == 0 && p.direction.z == 0) p.direction = geometry_.direction(p.pixel);
        return p.direction;
    };
    const uint32_t node_a = cells_[a->cell].node, node_b = cells_[b->cell].node;
    for (size_t i = 0; i < as && open; ++i)
        for (size_t j = 0; j < bs; ++j) {
            const Shown both = a[i].shown & b[j].shown & open;
            if (!both || (a[i].shown == all_ && b[j].shown == all_)) continue;  // joined if they can be
            if (!connector_.within_reach(direction(a[i]), direction(b[j]))) continue;
            for (int k = 0; k < pictures_; ++k)
                if (both >> k & 1) parent_[at(k, root(k, node_a))] = root(k, node_b);
            open &= ~both;
        }
}

uint32_t SwayedGroups::root(int picture, uint32_t node) const {
    if (parent_.empty()) return node;
    while (parent_[at(picture, node)] != node) node = parent_[at(picture, node)];
    return node;
}

// The pictures in which these are not one group.
Shown SwayedGroups::apart(uint32_t a, uint32_t b) const {
    Shown out = 0;
    for (int k = 0; k < pictures_; ++k) out |= Shown(root(k, a) != root(k, b)) << k;
    return out;
}

}  // namespace comfort
