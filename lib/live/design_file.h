// SPDX-License-Identifier: BSD-3-Clause
// The design as a text that a person reads and that is opened again (-design; man/vcview.1, "Design file").  It is
// written anew soon after each change, whole or not at all.
#pragma once
#include <string>
#include <vector>
#include "live/files.h"
#include "live/live.h"

namespace live {

std::string design_text(const State& s);  // empty: nothing is known yet
// The state with the design of the text; regions: those of the text.  Throws Error (place: the file and line) for what
// is no design of its files.
State with_design(State s, const std::string& text, const std::string& place, std::string& regions);

// View files as named views, where the design has none of the name.
State with_views(State s, const std::vector<std::string>& files);

class DesignFile {
public:
    // path: empty for none.  Reads the file if there is one; its regions count where the region file has none.
    DesignFile(std::string path, Live& live);
    // Writes the file if the design has changed since.  The page shows a failure until it is mended.
    // last: of the programs; numbers that have changed since the last change are written, too.
    void look(bool last = false);

private:
    const std::string path_;
    Live& live_;
    std::string written_, trouble_;
    Live::Numbers seen_;
};

}  // namespace live
