// SPDX-License-Identifier: BSD-3-Clause
// The declarations of ptrace's options (CONTRIBUTING.md, "Add an option").
#pragma once
#include <optional>

#include "base/options.h"
#include "options.h"
#include "scene/rad_input.h"

// rad_input: where -rif leaves what it has read; its views are chosen by name, after all options.
// assignments: variables of rad that the command line gives after the file.
void declare_options(base::OptionTable& table, Options& opt, std::optional<scene::RadInput>& rad_input,
                     const std::vector<std::string>& assignments);
