// SPDX-License-Identifier: BSD-3-Clause
// One picture in memory, in standard orientation, with its header kept.
// Pixels are RGB spectral radiance, W/(sr m2), exposure and colour correction already divided out, row 0 = TOP,
// 3 floats a pixel.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include "image/moments.h"
#include "image/parts.h"
#include "image/points.h"
#include "view/view.h"

namespace image {

// Luminance in cd/m2 of RADIANCE's primaries is 179 lm/W times their weighted sum.  (evalglare's own weights differ in
// the 4th digit: glare/luminance.h.)
constexpr double lumens_per_watt = 179;
constexpr double luminance_weights[3] = {0.265074126, 0.670114631, 0.064811243};
inline double luminance(const float* rgb) {
    const double* w = luminance_weights;
    return lumens_per_watt * (w[0] * rgb[0] + w[1] * rgb[1] + w[2] * rgb[2]);
}

constexpr const char* no_shared_paths = "-";  // of an hour by itself among others that share their paths

// ACTION=mel 9 lx: the pixels are not radiances of red, green and blue but, in each channel alike, light weighted by an
// action spectrum in place of luminance, in so many bands of wavelength, scaled so that 179 times the integral over
// solid angle with the cosine is the number of that unit (in lx: the alpha-opic equivalent daylight illuminance).
struct Action {
    std::string name;  // mel rh sc mc lc V, or of a file
    int bands = 0;
    std::string unit;  // lx, W/m2
    bool operator==(const Action& o) const { return name == o.name && bands == o.bands && unit == o.unit; }
    bool operator!=(const Action& o) const { return !(*this == o); }
};

struct Header {
    std::vector<std::string> lines;  // history: every line not in the fields below, in order
    std::optional<view::View> view;  // from VIEW= and program lines (spec formats 1, glare 1.4)
    double exposure = 1;             // product of EXPOSURE= lines: divided out of the pixels here, in them in files
    double pixel_aspect = 1;
    std::optional<uint64_t> seed;          // SEED=
    std::optional<int64_t> frame;          // FRAME=k: a single frame
    std::optional<int64_t> frames;         // FRAMES=n: diffuse frames averaged
    std::optional<int64_t> last_frame;     // LASTFRAME=k: the stream goes on to frame k
    std::optional<int64_t> direct_frames;  // FRAME0=m: frame 0 holds the direct and specular light of frames 1 to m
    std::string view_name, sky_name;  // VIEWNAME=, SKYNAME=: in streams of several pictures of one scene; else empty
    std::string state;                // STATE=: of what moves in the scene (ptrace -state), "south/half"; else empty
    std::optional<Action> action;     // ACTION=; none: an ordinary picture
    std::string shared_paths;         // SHARED_PATHS=: pictures that have it in common have paths in common; else empty
    std::optional<std::pair<int64_t, int64_t>> hour;  // HOUR=k/n: the k-th of n hours of a run; 0/0: a named one
    std::string unknown;          // UNKNOWN=why: the picture has no values, its pixels mean nothing; else empty
    std::vector<Grid> grids;      // GRID=: a picture of points, without view; else empty
    std::optional<int64_t> edit;  // EDIT=k what: pictures of a stream whose scene or view changes meanwhile
    std::string edited;           // what: "view"
    std::string fingerprint;      // FINGERPRINT=: of all that decides the pixels (fingerprint.h); empty: not known
    Ranges ranges;                // RANGE=a:b, both included; several after a merge
    std::vector<std::pair<uint64_t, Ranges>>
        other_seeds;               // further SEED= lines with their RANGE= lines (merges of runs)
    bool tabbed_exposure = false;  // a line held EXPOSURE= and a TAB (evalglare refuses such)
};

// m where a header has no FRAME0= line; frames above m correct frame 0, in the noisiest pixels all frames
// (decisions/0002, decisions/0030).
constexpr int direct_samples = 8;

// Which of two halves of the frames k > 0 is in: + - - + - + + - and so on (Thue and Morse), so that any number of them
// from the first on is halved, too.  Frames up to direct_samples show the same half of frame 0's samples.
inline bool in_first_half(int64_t k) {
    bool first = true;
    for (int64_t bits = k - 1; bits; bits &= bits - 1) first = !first;
    return first;
}

// The k-th of the digits of exact sums (film/exact_sum.h), two's complement: the highest layer has the sign.
struct SumLayer {
    int digit = 0;
    std::vector<uint32_t> words;
};
constexpr int sum_digits = 10;

struct Picture {
    int width = 0, height = 0;
    bool floats = false;        // the pixels came as 32-bit floats: differences of such pictures mean something
    std::vector<float> rgb;     // 3 * width * height, row 0 = top
    std::vector<float> frame0;  // accumulated pictures in EXR: L(0), as rgb; else empty
    std::vector<SumLayer> sum;  // likewise: the sum of the frames above 0, exactly
    std::vector<Part> parts;    // likewise: ranges of its frames, if kept
    Moments moments;            // null: not known
    Header header;
    float* at(int x, int y_from_top) { return &rgb[3 * (size_t(y_from_top) * width + x)]; }
    const float* at(int x, int y_from_top) const { return &rgb[3 * (size_t(y_from_top) * width + x)]; }
};

// A partial sum: the mean of frames without frame 0, which may be negative.
bool lacks_frame0(const Header& header);
// Must its pixels be written as floats, because RGBE would spoil them?  Not those of a view that is whole.
bool needs_floats(const Header& header);

// Throws Error (place = where) for what is not a picture of a scene: a single frame k > 0 and a partial sum
// that lacks frame 0 (paper Eq. 7: only L'(n) is one).
void require_complete(const Picture& picture, const std::string& where);

enum class Format { rgbe, xyze, flt };

// Conversion of the numbers in a file: to radiance, as above; not at all (exposure, colour correction and
// primaries stay in), as RADIANCE treats pictures that are patterns; or with only the exposure divided out, as
// evalglare does.  XYZE and OpenEXR always become radiance.
enum class Pixels { radiance, stored, exposed };

}  // namespace image
