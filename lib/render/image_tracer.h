// SPDX-License-Identifier: BSD-3-Clause
// Traces paths of MODE_IMAGE (kernels/integrator/image.h) from places of the picture.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>
#include "device/device.h"
#include "kernels/dialect/host.h"
#include "render/picture_place.h"

namespace render {

// Roberts' sequences: uniform for any count.
inline double unit_step(uint32_t k, double step) { return std::fmod(0.5 + (k + 1.0) * step, 1.0); }
constexpr double first_step = 0.7548776662466927, second_step = 0.5698402909980532, way_step = 0.8191725133961645;

// Radiance along rays to points of discs: a place in the picture and `ways` paths each, whose mean it is.
class ImageTracer {
public:
    ImageTracer(device::Device& device, const device::Params& base, const view::View& view, uint32_t ways)
        : device_(device), par_(base), projector_(view), ways_(ways) {
        par_.mode = MODE_IMAGE;
        par_.first = 0;
        par_.samples_per_pass = par_.spp = 1;
        par_.reuse_path_count = par_.redraw = 0;
        seed_ = double(par_.seed_lo) / 4294967296.0;
    }
    const view::Projector& projector() const { return projector_; }
    void add(const PicturePlace& place) {
        add(place.X, place.Y, std::fmod(unit_step(uint32_t(rays_.size()), way_step) + seed_, 1.0));
    }
    // left: what a way has for surfaces after the first ones.
    void add(double X, double Y, double left) {
        for (uint32_t k = 0; k < ways_; k++) {
            const float way = std::min(float((k + left) / ways_), 1 - 6e-8f);
            rays_.push_back({{float(X), float(Y), way}, {0, 0, 0}, PILOT_FROM_EYE});
        }
    }
    void reserve(size_t points) { rays_.reserve(points * ways_); }
    void clear() { rays_.clear(); }
    // Rays give the direction in which they leave the scene, 0 if they do not, in place of radiance.
    void seek_directions() { par_.flags |= PF_DIRECTIONS; }
    // set: of random numbers.
    void run(uint32_t set) {
        par_.frame = set;
        par_.path_count = uint32_t(rays_.size());
        if (!rays_.empty()) device_.pilot(par_, rays_, ends_);
    }
    const float* of(size_t point, uint32_t way) const { return ends_[point * ways_ + way].gathered; }
    void mean(size_t point, float* rgb) const {
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (uint32_t k = 0; k < ways_; k++) sum += double(of(point, k)[c]);
            rgb[c] = std::isfinite(sum) ? float(sum / ways_) : 0;
        }
    }
    // The fewest ways, a power of two, that tell all paths of a point apart.
    uint32_t ways_needed(size_t point) const {
        uint32_t needed = ways_;
        const auto same = [&](uint32_t a, uint32_t b) {
            return std::equal(of(point, a), of(point, a) + 3, of(point, b));
        };
        for (uint32_t n = ways_ / 2; n >= 1; n /= 2) {
            const uint32_t group = ways_ / n;
            for (uint32_t k = 0; k < ways_; k++)
                if (!same(k, k / group * group)) return needed;
            needed = n;
        }
        return needed;
    }

private:
    device::Device& device_;
    device::Params par_;
    view::Projector projector_;
    uint32_t ways_;
    double seed_;
    std::vector<device::PilotRay> rays_;
    std::vector<device::PilotEnd> ends_;
};

}  // namespace render
