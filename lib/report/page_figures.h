// SPDX-License-Identifier: BSD-3-Clause
// Figures of a report (page.h), as SVG in HTML.
#pragma once
#include <string>
#include "report/page.h"

namespace report {

std::string dgp_bar(const Page::Number& dgp);
std::string drawing(const Page& page, const Page::Drawing& drawing);
std::string legend(const Page::Legend& legend);
std::string plan_maps(const std::string& svg);

}  // namespace report
