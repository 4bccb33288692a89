// SPDX-License-Identifier: BSD-3-Clause
// When a picture was made: header.h.
#include <cstdlib>
#include <ctime>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "image/header.h"

namespace image {

void add_date(Header& header) {
    for (const std::string& line : header.lines)
        if (base::begins_with(line, "CAPDATE=")) return;
    const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
    long long seconds = 0;
    if (epoch && !base::parse_integer(epoch, seconds))
        base::fail("SOURCE_DATE_EPOCH", "\"" + base::excerpt(epoch) + "\" is not a whole number of seconds");
    const std::time_t now = epoch ? std::time_t(seconds) : std::time(nullptr);
    const std::tm* const parts = epoch ? std::gmtime(&now) : std::localtime(&now);
    if (!parts) base::fail("SOURCE_DATE_EPOCH", std::to_string(seconds) + " is beyond the years of the calendar");
    char text[40];
    std::strftime(text, sizeof text, "CAPDATE= %Y:%m:%d %H:%M:%S", parts);
    header.lines.push_back(text);
}

}  // namespace image
