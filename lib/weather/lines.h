// SPDX-License-Identifier: BSD-3-Clause
// Lines of a weather file in fields.
#pragma once
#include <string>
#include <vector>

#include "base/text_reader.h"
#include "weather/weather.h"

namespace weather {

class Lines {
public:
    explicit Lines(const std::string& path);
    // The next line that is not blank, without a byte order mark or a carriage return; false at the end.
    bool next();
    const std::string& text() const { return text_; }
    // The line into fields, without the blanks around them; ' ': at white space.  A field in quotes may hold commas.
    void split(char separator);
    size_t fields() const { return fields_.size(); }
    const std::string& field(size_t i, const char* what) const;
    double number(size_t i, const char* what, double low, double high) const;
    double number(size_t i, const char* what) const;
    double number_or_nan(size_t i, const char* what) const;  // of an empty field
    int whole(size_t i, const char* what, int low, int high) const;
    [[noreturn]] void fail(const std::string& fact) const;
    uint32_t line() const { return line_; }

private:
    base::TextReader in_;
    std::string text_;
    std::vector<std::string> fields_;
    uint32_t line_ = 0;
};

// Adds the hour that stands on this line; throws Error where there are more than a year has minutes.
void add_hour(const Lines& in, Hour hour, Weather& weather);

bool is_epw(Lines& first);
// The rows of the two formats, into weather: header and hours, in the file's order; the first line has been read.
void read_epw(Lines& in, Weather& weather);
void read_wea(Lines& in, Weather& weather);

}  // namespace weather
