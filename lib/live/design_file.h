// SPDX-License-Identifier: BSD-3-Clause
// The design as a text that a person reads and that is opened again (-design; man/vcview.1, "Design file").  It is
// written anew soon after each change, whole or not at all.
#pragma once
#include <string>
#include <vector>
#include "live/files.h"
#include "live/live.h"

namespace live {

// regions: the text of the region file; empty: none.
std::string design_text(const Design& design, const Files& files, const std::string& regions);
// regions: those of the text.  Throws Error (place: the file and line) for what is no design of these files.
Design read_design(const std::string& text, const std::string& place, const Files& files, std::string& regions);

// View files as named views, where the design has none of the name.
void offer_views(const std::vector<std::string>& files, Live& live);

class DesignFile {
public:
    // path: empty for none.  Reads the file if there is one; its regions count where the region file has none.
    DesignFile(std::string path, const Files& files, Live& live);
    // Writes the file if the design has changed since.  The page shows a failure once.
    // last: of the programs; numbers that have changed since the last change are written, too.
    void look(bool last = false);

private:
    const std::string path_;
    const Files& files_;
    Live& live_;
    std::string written_, trouble_;
    Live::Numbers seen_;
};

}  // namespace live
