// SPDX-License-Identifier: BSD-3-Clause
// Which pictures of a run are steps of one growing sum, so that errors can be estimated (report/estimates.h), and what
// the others lack, said once.
#pragma once
#include <string>
#include "report/estimates.h"
#include "image/picture.h"

class Steps {
public:
    // Looks before `first_look` frames are left out.  tells: of pictures that are no steps.
    Steps(const glare::PictureAnalyzer& analyzer, const std::vector<glare::Column>& columns, int64_t first_look,
          bool tells)
        : estimates_(analyzer, columns), first_look_(first_look), tells_(tells) {}

    // A picture's luminance, before it is measured.
    void add(const image::Picture& picture, const glare::Luminance& lum, const std::string& place);
    // After it is measured.  True: this was a look, the estimates are new.
    bool look(const glare::Luminance& lum, const glare::Measurement& m);
    void end_input(const std::string& place);  // of a file
    // The picture added last is the last one of its sum, and a look.
    void end_sum() { ends_ = true; }
    void columns_changed() { estimates_.columns_changed(); }
    const report::ColumnEstimates& estimates() const { return estimates_; }

private:
    void tell(const std::string& place, const std::string& fact);
    report::ColumnEstimates estimates_;
    int64_t first_look_;
    bool tells_;
    int64_t last_ = -1;  // frames of the picture before; -1: none
    bool step_ = false;  // the picture at hand is one
    bool ends_ = false;  // and no more follow it
    bool told_ = false, warned_ = false;
};
