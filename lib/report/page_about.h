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
const char* month_word(int month);  // 1: January
// "21 December, 14:00", of the first line of gensky or gendaylit; empty: there is none.
std::string hour_words(const std::vector<std::string>& sky);
// Which way the eye looks, north as an arrow, and the hour.
std::string where_and_when(const Page& page);
const char* compass_word(double degrees);

}  // namespace report
