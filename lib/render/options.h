// SPDX-License-Identifier: BSD-3-Clause
// Rendering options; the defaults are those of a converged daylight picture (docs/differences.md).
#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include "flatten/flatten.h"
#include "image/picture.h"
#include "view/view.h"

namespace base {
class OptionTable;
}

namespace render {

// Sampling of diffuse directions (-sampling): by the cosine; also toward portals; the same with path reuse.
enum class Sampling { plain, portals, reuse };

constexpr int no_limit = std::numeric_limits<int>::max();  // of -ab

struct RenderOptions : flatten::Options {  // which has -dr and -bv
    // RADIANCE's options
    int ab = no_limit;      // -ab diffuse bounces
    double st = 0;          // -st specular threshold
    double ss = 16;         // -ss > 1.5: weighted (W-G-M-D) lobes; <= 1.5: unweighted
    double dj = 1, ds = 0;  // -dj source jitter; -ds: 0 samples the whole source
    int dp = 0;             // -dp: no effect
    int lr = 0;             // -lr reflections; 0: no limit; negative: without the limit of -lw
    double lw = 1e-6;
    double pj = 1;                                                // -pj pixel jitter
    bool u = true;                                                // -u: no effect
    bool dv = true;                                               // -dv light sources visible
    bool i = false;                                               // -i irradiance
    double av[3] = {0, 0, 0};                                     // -av
    double me[3] = {0, 0, 0}, ma[3] = {0, 0, 0}, mg = 0, ms = 0;  // mist
    double pd = 0;                                                // -pd depth of field
    // luxpipe's options
    Sampling sampling = Sampling::reuse;
    uint64_t seed = 1;
    double least_lobe_prob = 0;  // for tests of rare lobes (kernels/integrator/sample_bsdf.h)
    int direct_samples =
        image::direct_samples;  // m of spec paper 7: samples of the direct and specular class in frame 0
    bool more_if_small = true;  // small pictures have several times as many
    double noisy_share = .15;   // samples for noisy pixels, over those of the picture (noisy.h)
    std::string room_text;      // hash of the room's objects (loaded_scene.h); empty: there is one sky
    size_t sky_from = 0;        // object of the scene at which its sky begins
    bool keep_room = false;     // for other skies
    bool tell_limit = false;    // warn of what -ab leaves out (beyond_limit.h)
};

// Declares the options of users; from_scene() marks options that a scene's file may set.
void declare_options(base::OptionTable& table, RenderOptions& options);

}  // namespace render
