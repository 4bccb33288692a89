// SPDX-License-Identifier: BSD-3-Clause
// Which pictures of a run are steps of one growing sum, so that intervals can be told (comfort/certainty.h), and what
// the others lack, said once.
#pragma once
#include <string>
#include "comfort/certainty.h"
#include "image/picture.h"

class Steps {
public:
    // Looks before `first_look` frames are left out.
    Steps(comfort::Meter& meter, const std::vector<comfort::Column>& columns, bool errors, int64_t first_look)
        : meter_(meter), certainty_(meter, columns, errors), first_look_(first_look) {}

    // Where the picture's luminance need not be copied from; null if measuring changes it, or others come before it.
    std::vector<float>* room(const image::Picture& picture) {
        return meter_.changes_pixels() || !picture.means.empty() ? nullptr : &certainty_.room();
    }
    // A picture's luminance, before it is measured.  Takes the picture's frame 0 and means, if it has some.
    void add(image::Picture& picture, const comfort::Luminance& lum, const std::string& place);
    // After it is measured.  True: this was a look, the estimates are new.
    bool look(const comfort::Luminance& lum, const comfort::Measurement& m);
    void end_input(const std::string& place);  // of a file
    const comfort::Certainty& certainty() const { return certainty_; }

private:
    void tell(const std::string& place, const std::string& fact);
    void replay(image::Picture& picture, int64_t frames);
    comfort::Meter& meter_;
    comfort::Certainty certainty_;
    int64_t first_look_;
    int64_t last_ = -1;  // frames of the picture before; -1: none
    bool step_ = false;  // the picture at hand is one
    bool ends_ = false;  // and no more follow it
    bool told_ = false, warned_ = false;
};
