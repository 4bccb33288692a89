// SPDX-License-Identifier: BSD-3-Clause
// What a report is about and what it is judged by (page.h), as HTML.
#pragma once
#include <string>
#include "report/page.h"

namespace report {

std::string about_list(const Page& page);
std::string criteria_table(const Page& page);
std::string variants_and_day(const Page& page);
// "south-west", of an angle from north (the y axis) over east in degrees.
const char* compass_word(double degrees);

}  // namespace report
