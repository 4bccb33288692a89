// SPDX-License-Identifier: BSD-3-Clause
// Columns of pictures whose light is weighted by an action (ACTION= of luxpipe-stream(5)) beside the ordinary ones.
// All that is asked of an action's picture is an ordinary column by another name: mEDI is its Ev, and DGPV the DGP of
// the picture of V, the only one whose numbers are luminances.  mDER is mEDI over EvV (CIE S 026).
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "image/picture.h"

namespace glare {

constexpr const char* illuminance_by_V = "EvV";

// The action spectra of CIE S 026, and what their columns begin with.
struct AlphaOpic {
    const char *action, *symbol;
};
constexpr AlphaOpic alpha_opic[] = {{"mel", "m"}, {"rh", "rh"}, {"sc", "sc"}, {"mc", "mc"}, {"lc", "lc"}};

struct ActionColumn {
    std::string name;
    std::string action;  // of the picture that it is measured in: that one's illuminance, "mEDI", "EvV", "E_NAME"
    std::string metric;  // the ordinary column there
    bool ratio = false;  // over EvV
};

// mEDI rhEDI scEDI mcEDI lcEDI, likewise mDER; EvV, and an ordinary column's name with V behind it; E_NAME of a user's
// action.  None: it is no such name, or an ordinary one (PGSV).
std::optional<ActionColumn> action_column(const std::string& name);

// The name of the illuminance, by which pictures of an action are known.
std::string illuminance_of(const image::Action& action);

// What renders pictures with this illuminance: "ptrace -action mel".
std::string command_for(const std::string& illuminance);

// "mEDI mDER ...": for the help text.
std::string action_column_names();

}  // namespace glare
