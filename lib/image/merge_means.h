// SPDX-License-Identifier: BSD-3-Clause
// Batches of frames of sums that are merged (means.h).  Each input's batches stay what they are; an input without any
// is one itself, if its pixels are exact.  They are put in the order of their frames, joined down to what is kept, and
// become means of one growing sum again.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "image/picture.h"

namespace image {

class MeansMerger {
public:
    // So many batches; without it 16 where every input has some, else none.
    explicit MeansMerger(std::optional<int> most) : most_(most) {}
    // `seed`: inputs of one seed have the same number, from 0 on.
    void add(const Picture& picture, size_t seed, const std::string& name);
    // Into the merged picture.  frame0: of each seed, empty where it is not known apart.
    void result(const std::vector<const std::vector<float>*>& frame0, Picture& merged) const;

private:
    struct Batch {
        size_t seed;
        int64_t first, frames;    // its first frame, and how many there are
        std::vector<float> grey;  // their mean, without frame 0
    };
    size_t most() const { return most_ ? size_t(*most_) : most_means; }
    void insert(Batch batch);
    void join();
    std::optional<int> most_;
    int inputs_ = 0;
    std::vector<GreyMean> only_;  // the first input's, while it is the only one
    std::vector<Batch> batches_;  // seed by seed, by first frame
    std::string without_;         // name of an input that has no batches
    std::string coarse_;          // and is none itself
};

}  // namespace image
