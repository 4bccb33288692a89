// SPDX-License-Identifier: BSD-3-Clause
// Pictures as OpenEXR: see exr.h.  A sum of frames also keeps what merging needs (accumulate.h): L(0) as layer
// "frame0", and the exact sum of the other frames as layers "sum0" to "sum9", one for each digit (exact_sum.h).  What
// tells its error are means of its first n frames, "mean<n>.Y" (means.h).
#include "image/exr.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "image/exr_file.h"
#include "image/grey.h"
#include "image/header.h"

namespace image {
namespace {

constexpr float largest_half = 65504;

// True: they were not what we write.
bool scale_colors(std::vector<float>& rgb, double unit, const std::optional<std::array<double, 8>>& primaries) {
    bool mixes = false;
    if (primaries)
        for (int i = 0; i < 8; ++i) mixes = mixes || std::fabs((*primaries)[i] - radiance_primaries[i]) > .001;
    if (!mixes && unit == 1) return false;
    Matrix3 m{1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (mixes) m = rgb_from_primaries(*primaries);
    for (size_t i = 0; i + 2 < rgb.size(); i += 3) {
        const double r = rgb[i] * unit, g = rgb[i + 1] * unit, b = rgb[i + 2] * unit;
        for (int c = 0; c < 3; ++c) rgb[i + c] = float(m[3 * c] * r + m[3 * c + 1] * g + m[3 * c + 2] * b);
    }
    return true;
}

// Sums and means of pixels whose colours are converted would be those of other numbers, and are left out.
std::vector<SumLayer> read_sum(const ExrInput& in) {
    std::vector<SumLayer> all;
    for (int k = 0; k < ExactSum::digits; ++k) {
        const std::string layer = "sum" + std::to_string(k);
        if (in.has(layer + ".R") && in.has(layer + ".G") && in.has(layer + ".B"))
            all.push_back({k, in.read_whole({layer + ".R", layer + ".G", layer + ".B"})});
    }
    return all;
}

// n of "mean<n>.Y"; 0 for any other channel.
int64_t frames_of_mean(const std::string& channel) {
    const size_t digits = channel.size() - std::min<size_t>(channel.size(), 6);
    if (digits < 1 || digits > 15 || channel.compare(0, 4, "mean") != 0 || channel.substr(4 + digits) != ".Y") return 0;
    int64_t n = 0;
    for (const char c : channel.substr(4, digits)) {
        if (c < '0' || c > '9') return 0;
        n = 10 * n + (c - '0');
    }
    return n;
}

// One pass over the file, which decodes all channels.
std::vector<GreyMean> read_means(const ExrInput& in, int64_t frames, const std::string& path) {
    std::vector<GreyMean> means;
    for (const std::string& channel : in.channels())
        if (const int64_t n = frames_of_mean(channel)) means.push_back({n, {}});
    if (means.empty()) return means;
    std::sort(means.begin(), means.end(), [](const GreyMean& a, const GreyMean& b) { return a.frames < b.frames; });
    if (means.size() > most_means) base::fail(path, fmt::format("holds more than {} means of batches", most_means));
    if (means.back().frames >= frames)
        base::fail(path, fmt::format("holds the mean of {} frames, where there are {}", means.back().frames, frames));
    std::vector<std::string> channels;
    for (const GreyMean& m : means) channels.push_back(fmt::format("mean{}.Y", m.frames));
    const std::vector<float> together = in.read(channels);
    for (size_t k = 0; k < means.size(); ++k) {
        std::vector<float>& grey = means[k].grey;
        grey.resize(together.size() / means.size());
        for (size_t i = 0; i < grey.size(); ++i) {
            const float v = together[i * means.size() + k];
            grey[i] = std::fabs(v) <= brightest_grey ? v : 0;
        }
    }
    return means;
}

}  // namespace

Picture read_exr(const std::string& path) {
    const ExrInput in(path);
    Picture p;
    p.width = in.width();
    p.height = in.height();
    p.header = in.header();
    const bool color = in.has("R") && in.has("G") && in.has("B");
    if (!color && !in.has("Y")) base::fail(path, "has neither the channels R G B nor Y: it is not a picture");
    if (!color && in.has("RY")) base::fail(path, "is stored as luminance and chroma (Y RY BY): not read");
    if (color) {
        p.rgb = in.read({"R", "G", "B"});
        scale_colors(p.rgb, in.white_luminance() / lumens_per_watt, in.primaries());
        if (in.has("frame0.R") && in.has("frame0.G") && in.has("frame0.B"))
            p.frame0 = in.read({"frame0.R", "frame0.G", "frame0.B"});
        if (scale_colors(p.frame0, in.white_luminance() / lumens_per_watt, in.primaries())) return p;
        p.sum = read_sum(in);
        if (p.header.frames) p.means = read_means(in, *p.header.frames, path);
        return p;
    }
    const std::vector<float> grey = in.read({"Y"});
    p.rgb.resize(3 * grey.size());
    for (size_t i = 0; i < grey.size(); ++i) p.rgb[3 * i] = p.rgb[3 * i + 1] = p.rgb[3 * i + 2] = grey[i];
    scale_colors(p.rgb, in.white_luminance() / lumens_per_watt, std::nullopt);
    return p;
}

void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options) {
    std::vector<float> rgb, frame0;
    const auto limited = [&](const std::vector<float>& in) {
        std::vector<float> out = in;
        bool any = false;
        for (float& v : out) {
            any = any || std::fabs(v) > largest_half;
            v = std::clamp(v, -largest_half, largest_half);
        }
        if (any) base::warn(path, "radiance above 65504 does not fit half floats and was cut");
        return out;
    };
    const float* base_rgb = picture.rgb.data();
    const float* base_frame0 = picture.frame0.data();
    if (options.half) {
        rgb = limited(picture.rgb);
        frame0 = limited(picture.frame0);
        base_rgb = rgb.data();
        base_frame0 = frame0.data();
    }
    std::vector<ExrChannel> channels{{"R", base_rgb, 3}, {"G", base_rgb + 1, 3}, {"B", base_rgb + 2, 3}};
    if (!picture.frame0.empty())
        for (int c = 0; c < 3; ++c) channels.push_back({std::string("frame0.") + "RGB"[c], base_frame0 + c, 3});
    for (const SumLayer& layer : picture.sum)
        for (size_t c = 0; c < 3 && !options.half; ++c)  // halves are not the pixels that these are the sums of
            channels.push_back({fmt::format("sum{}.{}", layer.digit, "RGB"[c]), layer.words.data() + c, 3, true});
    for (const GreyMean& mean : picture.means)
        if (!options.half && mean.frames != picture.header.frames)
            channels.push_back({fmt::format("mean{}.Y", mean.frames), mean.grey.data(), 1});
    write_exr_channels(path, picture.width, picture.height, channels, picture.header, {}, options);
}

}  // namespace image
