// SPDX-License-Identifier: BSD-3-Clause
// Pictures as OpenEXR: see exr.h.  A sum of frames also keeps what merging needs (accumulate.h): L(0) as layer
// "frame0", and the exact sum of the other frames as layers "sum0" to "sum9", one for each digit (exact_sum.h).  Its
// error is estimated from up to sixteen parts of its frames (parts.h): "part<k>.Y", or coarsely
// "off<k>.Y" (part_offsets.h).
#include "image/exr.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/hash.h"
#include "base/number.h"
#include "image/exr_file.h"
#include "image/grey.h"
#include "image/header.h"
#include "image/part_offsets.h"
#include "image/stream.h"

namespace image {
namespace {

constexpr float largest_half = 65504;
constexpr const char* offsets_text = "off";  // attribute: the scale of offsets (part_offsets.h)

std::vector<SumLayer> read_sum(const ExrInput& in) {
    std::vector<SumLayer> all;
    for (int k = 0; k < sum_digits; ++k) {
        const std::string layer = "sum" + std::to_string(k);
        if (in.has(layer + ".R") && in.has(layer + ".G") && in.has(layer + ".B"))
            all.push_back({k, in.read_whole({layer + ".R", layer + ".G", layer + ".B"})});
    }
    return all;
}

const std::vector<std::string> moment_channels = {"moments.variance", "moments.difference", "moments.right",
                                                  "moments.up"};
constexpr const char* moments_text = "moments";  // attribute: the hash of the pixels that they belong to

Moments read_moment_channels(const ExrInput& in, const std::vector<float>& rgb, const std::string& path) {
    for (const std::string& channel : moment_channels)
        if (!in.has(channel)) return {};
    if (in.text(moments_text) != base::hash_of(rgb)) {
        base::warn(path, "another program has changed its pixels: their moments are left out");
        return {};
    }
    std::vector<float> moments = in.read(moment_channels);
    clean_moments(moments);
    return std::make_shared<const std::vector<float>>(std::move(moments));
}

// The whole number between `before` and `after` of a channel's name; -1 for any other channel.
int64_t number_in(const std::string& channel, const std::string& before, const std::string& after) {
    const size_t around = before.size() + after.size();
    if (channel.size() <= around || channel.size() > around + 15 || channel.compare(0, before.size(), before) != 0 ||
        channel.substr(channel.size() - after.size()) != after)
        return -1;
    int64_t n = 0;
    for (const char c : channel.substr(before.size(), channel.size() - around)) {
        if (c < '0' || c > '9') return -1;
        n = 10 * n + (c - '0');
    }
    return n;
}

// Layers "NAME<number>.Y" by rising number.  One pass over the file, which decodes all channels.
std::vector<std::pair<int64_t, std::vector<float>>> read_layers(const ExrInput& in, const std::string& name,
                                                                const std::string& path) {
    std::vector<std::pair<int64_t, std::vector<float>>> layers;
    for (const std::string& channel : in.channels())
        if (const int64_t n = number_in(channel, name, ".Y"); n >= 0) layers.push_back({n, {}});
    if (layers.size() > most_parts)
        base::fail(path, fmt::format("holds more than {} layers {}<n>.Y", most_parts, name));
    std::sort(layers.begin(), layers.end());
    std::vector<std::string> channels;
    for (const auto& layer : layers) channels.push_back(fmt::format("{}{}.Y", name, layer.first));
    const std::vector<float> together = layers.empty() ? std::vector<float>() : in.read(channels);
    for (size_t k = 0; k < layers.size(); ++k)
        for (size_t i = k; i < together.size(); i += layers.size())
            layers[k].second.push_back(std::fabs(together[i]) <= brightest_grey ? together[i] : 0);
    return layers;
}

// Layers "NAME<k>.Y"; the attribute "NAME<k>" names their frames.
std::vector<Part> read_parts_called(const std::string& name, const ExrInput& in, int64_t frames,
                                    const std::string& path) {
    std::vector<Part> parts;
    for (auto& [k, grey] : read_layers(in, name, path)) {
        Part part{0, std::move(grey), seed_ranges(in.text(fmt::format("{}{}", name, k)).value_or(""), path)};
        for (const auto& from : part.from)
            for (const auto& r : from.second) part.frames += r.second - r.first + 1;
        if (part.frames < 1) base::fail(path, fmt::format("does not say which frames {}{}.Y holds", name, k));
        parts.push_back(std::move(part));
    }
    if (!parts.empty() && frames_of(parts) != frames)
        base::fail(path, fmt::format("its parts hold {} frames, its header says {}", frames_of(parts), frames));
    return parts;
}

// The parts themselves, "part<k>.Y", or what they are off their mean, "off<k>.Y".
std::vector<Part> read_parts(const ExrInput& in, const Picture& p, const std::string& path) {
    std::vector<Part> parts = read_parts_called("off", in, *p.header.frames, path);
    if (parts.empty()) return read_parts_called("part", in, *p.header.frames, path);
    long long scale = 0;
    if (!base::parse_integer(in.text(offsets_text).value_or(""), scale) || std::llabs(scale) > 200)
        base::fail(path, "does not say by which power of two its layers off<k>.Y are divided");
    add_offsets(parts, int(scale), grey_of(p.rgb));
    return parts;
}

// Files of versions up to 0.9: means of the first n frames, "mean<n>.Y"; frames between two means are a range.
std::vector<Part> read_means(const ExrInput& in, const Picture& p, const std::string& path) {
    GrowingParts parts;
    const auto means = read_layers(in, "mean", path);
    if (means.empty()) return {};
    if (means.back().first >= *p.header.frames || means.front().first < 1)
        base::fail(path,
                   fmt::format("its mean holds {} frames, its header says {}", means.back().first, *p.header.frames));
    for (const auto& [n, grey] : means) parts.add(grey.data(), grey.size(), n);
    std::vector<float> whole(p.rgb.size() / 3);
    to_grey(p.rgb.data(), whole.size(), whole.data());
    parts.add(whole.data(), whole.size(), *p.header.frames);
    std::vector<Part> out = parts.parts();
    for (Part& part : out) part.from.clear();  // of merged files the seeds are not known
    return out;
}

}  // namespace

Picture read_exr(const std::string& path, const base::Opener& by) {
    const ExrInput in(path, by);
    Picture p;
    p.width = in.width();
    p.height = in.height();
    p.header = in.header();
    const bool color = in.has("R") && in.has("G") && in.has("B");
    if (!color && !in.has("Y")) base::fail(path, "has neither the channels R G B nor Y: it is not a picture");
    if (!color && in.has("RY")) base::fail(path, "is stored as luminance and chroma (Y RY BY): not read");
    const double unit = in.white_luminance() / lumens_per_watt;
    const std::array<double, 3> scale{unit, unit, unit};
    if (color) {
        const auto mix = rgb_from_primaries(in.primaries());
        p.rgb = in.read({"R", "G", "B"});
        convert(p.rgb, scale, mix);
        if (in.has("frame0.R") && in.has("frame0.G") && in.has("frame0.B"))
            p.frame0 = in.read({"frame0.R", "frame0.G", "frame0.B"});
        convert(p.frame0, scale, mix);
        if (mix || unit != 1) return p;  // other pixels than those that the rest belongs to
        p.sum = read_sum(in);
        p.moments = read_moment_channels(in, p.rgb, path);
        if (p.header.frames) p.parts = read_parts(in, p, path);
        if (p.header.frames && p.parts.empty()) p.parts = read_means(in, p, path);
        return p;
    }
    const std::vector<float> grey = in.read({"Y"});
    p.rgb.resize(3 * grey.size());
    for (size_t i = 0; i < grey.size(); ++i) p.rgb[3 * i] = p.rgb[3 * i + 1] = p.rgb[3 * i + 2] = grey[i];
    convert(p.rgb, scale, std::nullopt);
    return p;
}

std::string exr_bytes(const std::string& path, const Picture& picture, const ExrOptions& options) {
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
    std::map<std::string, std::string> texts;
    if (picture.moments && !options.half) {
        for (size_t k = 0; k < moment_numbers; ++k)
            channels.push_back({moment_channels[k], picture.moments->data() + k, int(moment_numbers)});
        texts[moments_text] = base::hash_of(picture.rgb);
    }
    PartOffsets offsets;
    const bool coarse = options.coarse_parts && !picture.parts.empty() && !options.half;
    for (size_t k = 0; k < picture.parts.size() && !options.half && !coarse; ++k) {
        const std::string name = fmt::format("part{}", k);
        channels.push_back({name + ".Y", picture.parts[k].grey.data(), 1});
        texts[name] = to_text(picture.parts[k].from);
    }
    if (coarse) {
        offsets = part_offsets(picture.parts, grey_of(picture.rgb));
        texts[offsets_text] = std::to_string(offsets.scale);
    }
    for (size_t k = 0; k < offsets.of.size(); ++k) {
        const std::string name = fmt::format("off{}", k);
        channels.push_back({name + ".Y", offsets.of[k].data(), 1, false, true});
        texts[name] = to_text(picture.parts[k].from);
    }
    return exr_bytes_of(path, picture.width, picture.height, channels, picture.header, texts, options);
}

void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options) {
    write_bytes(path, exr_bytes(path, picture, options));
}

}  // namespace image
