// SPDX-License-Identifier: BSD-3-Clause
// Parts (parts.h) of sums that are merged.  Each input's parts are ranges of the whole, each with the frame 0 of its
// seed; an input without any is one range, if its pixels are exact.  Up to the most, parts do not depend on the inputs'
// order.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "image/picture.h"

namespace film {

class PartsMerger {
public:
    // So many parts; without it 16 where every input has some, else none.
    explicit PartsMerger(std::optional<int> most) : most_(most) {}
    // `seed`: inputs of one seed have the same number, from 0 on.
    void add(const image::Picture& picture, size_t seed, const std::string& name);
    // Into the merged picture.  frame0: of each seed, empty where it is not known apart.
    void result(const std::vector<const std::vector<float>*>& frame0, image::Picture& merged) const;

private:
    void insert(image::Part&& part, size_t lacking_seed, bool lacks);
    size_t most() const { return most_ ? size_t(*most_) : image::most_parts; }
    std::optional<int> most_;
    std::vector<image::Part> parts_;
    std::vector<std::vector<int64_t>> lacking_;  // beside parts_, by seed: frames to which its frame 0 is to be added
    std::string without_;                        // name of an input that has no parts
    std::string coarse_;                         // and is none itself
};

}  // namespace film
