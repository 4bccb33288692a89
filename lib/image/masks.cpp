// SPDX-License-Identifier: BSD-3-Clause
// Mask files: see masks.h.  OpenEXR sorts its channels, so the order of the regions travels in an attribute.
#include "image/masks.h"

#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "base/processors.h"
#include "base/threads.h"
#include "image/exr_file.h"

namespace image {
namespace {

constexpr const char* order_attribute = "luxpipe.regions";
constexpr size_t group = 32;  // channels read together

bool name_is_valid(const std::string& name) {
    return !name.empty() && name.size() < 64 &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
               std::string::npos;
}

// OpenEXR compresses on threads of its own, and only there; it does not survive one that cannot be started.
void start_threads() {
    const unsigned threads = base::available_threads(base::processors());
    if (threads > 1) Imf::setGlobalThreadCount(int(threads));
}

}  // namespace

MaskSet read_masks(const std::string& path, const base::Opener& by) {
    const ExrInput in(path, by);
    MaskSet set;
    set.width = in.width();
    set.height = in.height();
    set.header = in.header();
    std::vector<std::string> names = in.channels();
    if (names.empty()) base::fail(path, "has no channel: it holds no regions");
    if (const auto order = in.text(order_attribute)) {
        std::vector<std::string> listed;
        std::istringstream words(*order);
        for (std::string name; words >> name;)
            if (std::count(names.begin(), names.end(), name) && !std::count(listed.begin(), listed.end(), name))
                listed.push_back(name);
        for (const std::string& name : names)
            if (!std::count(listed.begin(), listed.end(), name)) listed.push_back(name);
        names = listed;
    }
    for (const std::string& name : names)
        if (!name_is_valid(name))
            base::fail(path, "channel \"" + name + "\" is not a region name (letters, digits, _ and -)");
    for (size_t k = 0; k < names.size(); k += group) {  // a pass over the file decodes all channels: few passes
        const std::vector<std::string> some(names.begin() + k, names.begin() + std::min(k + group, names.size()));
        const std::vector<float> interleaved = in.read(some);
        for (size_t c = 0; c < some.size(); ++c) {
            Mask mask{some[c], std::vector<float>(interleaved.size() / some.size())};
            for (size_t i = 0; i < mask.coverage.size(); ++i) mask.coverage[i] = interleaved[i * some.size() + c];
            for (const float v : mask.coverage)
                if (!(v >= 0 && v <= 1)) base::fail(path, "region \"" + some[c] + "\" has a coverage outside 0..1");
            set.masks.push_back(std::move(mask));
        }
    }
    return set;
}

void write_masks(const std::string& path, const MaskSet& set) {
    std::string order;
    std::vector<ExrChannel> channels;
    for (const Mask& mask : set.masks) {
        if (!name_is_valid(mask.name))
            base::fail(path, "\"" + mask.name + "\" is not a region name (letters, digits, _ and -)");
        if (mask.coverage.size() != size_t(set.width) * set.height)
            base::fail(path, "region \"" + mask.name + "\" has the wrong size");
        order += (order.empty() ? "" : " ") + mask.name;
        channels.push_back({mask.name, mask.coverage.data(), 1});
    }
    if (channels.empty()) base::fail(path, "no regions to write");
    ExrOptions options;
    options.compression = "rle";  // masks are runs of 0 and 1: ten times faster than zip and hardly larger
    if (channels.size() > 8 && Imf::globalThreadCount() == 0) start_threads();
    write_exr_channels(path, set.width, set.height, channels, set.header, {{order_attribute, order}}, options);
}

}  // namespace image
