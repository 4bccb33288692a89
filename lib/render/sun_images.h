// SPDX-License-Identifier: BSD-3-Clause
// Images of the sun by flat smooth surfaces, drawn into frame 0 by area (kernels/integrator/image.h), because few rays
// would hit them.
//   The image of a distant source in a plane is a disc of camera directions, about v = s - 2 (s.n) n, wherever the
// surface lies; after two planes likewise.  (Straight on, too: a solid slab bends light twice.)  The discs in which
// light arrives are listed.  Images in curved surfaces are searched for.  In all other directions samples find the sun.
#pragma once
#include <vector>
#include "device/device.h"
#include "flatten/host_tracer.h"
#include "sampling/smooth_planes.h"
#include "view/view.h"

namespace render {

struct SunImages {
    struct Disc {
        base::Vec3 dir;
        double cap;  // 1 - cos of the half angle
    };
    std::vector<Disc> discs;
    std::vector<uint32_t> sources;  // that have images
    uint32_t ways = 1;              // sequences of lobes that a path may take to them (a power of two)
};

// Images in planes, and all suns that may have images.
SunImages possible_images(const flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                          const sampling::SmoothSurfaces& smooth, const view::View& view, int nx, int ny);
// Whether one of the largest smooth planes shows the eye a sun of this radius that lights it.
bool shows_image(const flatten::HostTracer& tracer, const sampling::SmoothSurfaces& smooth, const view::View& view,
                 int nx, int ny, base::Vec3 sun, double radius);
// Adds images in curved surfaces: a search by halving steps, from a net of camera directions (curved_images.cpp).
void find_curved_images(device::Device& device, const device::Params& base, const flatten::FlatScene& scene,
                        const sampling::SmoothSurfaces& smooth, const view::View& view, SunImages& images);
// Keeps those in which light arrives: the brightest MOST_IMAGES.  base: with the view, in whose table the sources are
// marked.
void keep_lit_images(device::Device& device, const device::Params& base, const view::View& view, SunImages& images);

// A point of an image: its pixel, place there (pixels from the centre) and radiance by two sets of random numbers,
// times the share of a pixel that the point represents.
struct ImagePoint {
    uint32_t pixel;
    float right, up, weight;
    float first[3], second[3];
};
std::vector<ImagePoint> draw_images(device::Device& device, const device::Params& base, const view::View& view,
                                    const SunImages& images);

}  // namespace render
