// SPDX-License-Identifier: BSD-3-Clause
// vcyear of tables of sensors: what it prints of their grids; plots and folders are written on the way.
#pragma once
#include <string>

#include "shaded.h"

std::string answer_of_sensors(const Options& options, const Counted& counted);
