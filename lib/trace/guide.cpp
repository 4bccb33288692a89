// SPDX-License-Identifier: BSD-3-Clause
// Walks from the eye find the cells that the picture shows.  From places met in a cell walks go out through every bin
// of its hemisphere; each tells what light it met, and in which cell the next bounce would begin.  The cells found
// there are learned in the same way, with fewer bins.  The light of all bounces follows from these links: the mean
// light of a cell is the mean of what its walks met and of the light of the cells in which they ended (Jacobi's
// iteration), so that no walk is longer than one bounce.
#include "trace/guide.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace kernels {
#include "kernels/instance.h"
#include "kernels/surface.h"
#include "kernels/highlights.h"
#include "kernels/guide.h"
}  // namespace kernels

namespace trace {
namespace {

using namespace kernels;

constexpr uint32_t EYE_SIDE = 128;                  // walks from the eye, a square of so many
constexpr size_t MOST_SEEN = 1024;                  // cells that the eye sees
constexpr size_t MOST_BEYOND = 2048;                // and those that it does not
constexpr uint32_t SEEN_SIDE = 16, SEEN_WALKS = 1;  // their bins a side, and the walks of each
constexpr uint32_t BEYOND_SIDE = 8, BEYOND_WALKS = 2;
constexpr int MOST_BOUNCES = 8;        // more add little light
constexpr size_t MOST_PLACES = 16;     // kept of a cell
constexpr size_t TOGETHER = 1u << 18;  // walks handed to the device

struct Place {
    float3 p, n;
};

// What a walk has told: the light that it met, and which share of which cell's light it would have found beyond.
struct Link {
    float met = 0, share = 0;
    uint32_t key = NONE;  // of that cell; NONE: the walk ended without a bounce
};

// What is known of a cell besides what goes into the table.
struct Ground {
    size_t hits = 0;
    std::vector<Place> places;
    uint32_t walks = 0;  // of each bin
    size_t first = 0;    // of its links
};

float luminance(const float (&c)[3]) {
    const float v = luminance3(F3(c[0], c[1], c[2]));
    return std::isfinite(v) && v > 0 ? v : 0;
}

class Lesson {
public:
    Lesson(Device& device, const Params& par) : device_(device), par_(par) { par_.mode = MODE_WALK; }

    Guide guide() {
        find_seen();
        send_out(0, SEEN_SIDE, SEEN_WALKS);
        const size_t seen = cells_.size();
        find_beyond();
        send_out(seen, BEYOND_SIDE, BEYOND_WALKS);
        spread_light();
        measure_bins();
        return guide_table(cells_, par_.guide_grid);
    }

private:
    Device& device_;
    Params par_;
    std::vector<GuideCell> cells_;
    std::vector<Ground> ground_;                   // of each cell
    std::unordered_map<uint32_t, size_t> number_;  // of cells, by key
    std::vector<Link> links_;
    std::vector<Place> ends_;  // of the walks of links_
    double unknown_ = 0;       // light that stands for that of cells not learned

    std::vector<WalkEnd> walk(const std::vector<WalkRay>& rays) {
        std::vector<WalkEnd> ends, some;
        for (size_t first = 0; first < rays.size(); first += TOGETHER) {
            const size_t end = std::min(first + TOGETHER, rays.size());
            par_.first = 0;
            par_.slots = uint32_t(end - first);
            device_.walk(par_, {rays.begin() + long(first), rays.begin() + long(end)}, some);
            par_.frame++;  // other random numbers for the next
            ends.insert(ends.end(), some.begin(), some.end());
        }
        return ends;
    }

    static Place place_of(const WalkEnd& end) {
        return {F3(end.p[0], end.p[1], end.p[2]), F3(end.n[0], end.n[1], end.n[2])};
    }

    // The cells that the eye sees.  They are as small as their number allows; to begin with, a 64th of the distance
    // that half of the places are nearer than.
    void find_seen() {
        std::vector<WalkRay> rays;
        for (uint32_t i = 0; i < EYE_SIDE * EYE_SIDE; i++) {
            const float x = float(i % EYE_SIDE) + 0.5f, y = float(i / EYE_SIDE) + 0.5f;
            rays.push_back({{x / EYE_SIDE, y / EYE_SIDE, 0}, {0, 0, 0}, WALK_FROM_EYE});
        }
        std::vector<Place> places;
        std::vector<float> distances;
        for (const WalkEnd& end : walk(rays)) {
            const float distance = length3(sub3(place_of(end).p, xyz4(par_.view_org)));
            if (!end.bounce || !(distance > 0 && distance < FAR_AWAY)) continue;
            places.push_back(place_of(end));
            distances.push_back(distance);
        }
        if (places.empty()) return;

        const auto middle = distances.begin() + long(distances.size() / 2);
        std::nth_element(distances.begin(), middle, distances.end());
        for (float size = *middle / 64;; size *= 1.25f) {
            set_grid(size);
            cells_.clear();
            ground_.clear();
            number_.clear();
            for (const Place& place : places) add(place);
            if (cells_.size() <= MOST_SEEN) break;
        }
    }

    // The eye is in the middle.  Walls stand at round places, which shall not lie between two cells.
    void set_grid(float size) {
        const float half = (0.5f * GUIDE_CELLS_A_SIDE + 0.37f) * size;
        const float3 eye = xyz4(par_.view_org);
        par_.guide_grid = {eye.x - half, eye.y - half, eye.z - half, 1 / size};
    }

    // Counts a place in its cell and may keep it, each with the same chance; a hash stands for the random number.
    void add(const Place& place) {
        const uint32_t key = guide_key(&par_, place.p, place.n);
        if (key == NONE) return;
        const auto [at, fresh] = number_.try_emplace(key, cells_.size());
        if (fresh) {
            cells_.emplace_back();
            cells_.back().key = key;
            ground_.emplace_back();
        }
        Ground& ground = ground_[at->second];
        ground.hits++;
        const size_t k = hash32(uint32_t(ground.hits) ^ key) % ground.hits;
        if (ground.places.size() < MOST_PLACES) ground.places.push_back(place);
        else if (k < MOST_PLACES) ground.places[k] = place;
    }

    // Walks out of the cells from number `first` on.
    void send_out(size_t first, uint32_t side, uint32_t walks) {
        std::vector<WalkRay> rays;
        for (size_t c = first; c < cells_.size(); c++) {
            cells_[c].side = side;
            ground_[c].walks = walks;
            ground_[c].first = links_.size() + rays.size();
            for (uint32_t i = 0; i < side * side * walks; i++) rays.push_back(ray_out(c, i));
        }
        for (const WalkEnd& end : walk(rays)) {
            const Place place = place_of(end);
            Link link;
            link.met = luminance(end.gathered);
            if (end.bounce) {
                link.share = luminance(end.share);
                link.key = guide_key(&par_, place.p, place.n);
            }
            links_.push_back(link);
            ends_.push_back(place);
        }
    }

    // Ray i from cell c, a random one of its bin.
    WalkRay ray_out(size_t c, uint32_t i) const {
        const GuideCell& cell = cells_[c];
        const std::vector<Place>& places = ground_[c].places;
        const Place& from = places[hash32(i ^ hash32(cell.key)) % places.size()];
        const uint32_t bin = i / ground_[c].walks;
        Sampler rnd = sampler_start(par_.seed_lo, par_.seed_hi, cell.key, i, 4);
        const float2 r = sample2(&rnd);
        const float x = (float(bin / cell.side) + r.x) / float(cell.side);
        const float y = (float(bin % cell.side) + r.y) / float(cell.side);
        const float3 dir = guide_direction(from.n, x, y), org = madd3(from.n, 1e-3f / par_.guide_grid.w, from.p);
        return {{org.x, org.y, org.z}, {dir.x, dir.y, dir.z}, FAR_AWAY};
    }

    // Those cells without walks in which walks have ended most often.
    void find_beyond() {
        std::unordered_map<uint32_t, size_t> count;
        for (const Link& link : links_)
            if (link.share > 0 && link.key != NONE && number_.count(link.key) == 0) count[link.key]++;
        std::vector<std::pair<size_t, uint32_t>> order;
        for (const auto& [key, hits] : count) order.emplace_back(hits, key);
        std::sort(order.begin(), order.end(), std::greater<>());
        if (order.size() > MOST_BEYOND) order.resize(MOST_BEYOND);

        std::unordered_map<uint32_t, bool> taken;
        for (const auto& [hits, key] : order) taken[key] = true;
        for (size_t i = 0; i < links_.size(); i++)
            if (taken.count(links_[i].key) != 0) add(ends_[i]);
    }

    // The light of all bounces, from cell to cell.
    void spread_light() {
        for (int bounce = 1; bounce < std::min(par_.ab, MOST_BOUNCES); bounce++) {
            std::vector<double> light;
            double sum = 0;
            for (size_t c = 0; c < cells_.size(); c++) {
                const size_t count = size_t(cells_[c].side) * cells_[c].side * ground_[c].walks;
                double met = 0;
                for (size_t i = 0; i < count; i++) met += light_along(links_[ground_[c].first + i]);
                light.push_back(met / double(count));
                sum += light.back();
            }
            for (size_t c = 0; c < cells_.size(); c++) cells_[c].light = light[c];
            unknown_ = sum / double(std::max<size_t>(cells_.size(), 1));
        }
    }

    double light_along(const Link& link) const {
        if (link.share <= 0) return link.met;
        const auto at = number_.find(link.key);
        return link.met + link.share * (at == number_.end() ? unknown_ : cells_[at->second].light);
    }

    void measure_bins() {
        for (size_t c = 0; c < cells_.size(); c++) {
            const uint32_t bins = cells_[c].side * cells_[c].side, walks = ground_[c].walks;
            for (uint32_t bin = 0; bin < bins; bin++) {
                double square = 0;
                for (uint32_t i = 0; i < walks; i++) {
                    const double light = light_along(links_[ground_[c].first + size_t(bin) * walks + i]);
                    square += light * light;
                }
                cells_[c].square.push_back(square / walks);
            }
        }
    }
};

}  // namespace

Guide learn_guide(Device& device, const Params& par) {
    if (par.ab < 1) return {};
    return Lesson(device, par).guide();
}

}  // namespace trace
