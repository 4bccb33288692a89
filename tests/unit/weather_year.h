// SPDX-License-Identifier: BSD-3-Clause
// A made-up year of weather at 39.74 N, 105.18 W: clear hours, and cloudy ones that stay cloudy for a while; the same
// year for the same seed.
#pragma once
#include <cmath>
#include <random>
#include <string>

inline std::string year_epw(unsigned seed = 1) {
    constexpr double pi = 3.14159265358979, latitude = 39.74 * pi / 180;
    const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    std::string text =
        "LOCATION,Madeup,-,-,made up,0,39.74,-105.18,-7,1829\nDESIGN CONDITIONS,0\nTYPICAL/EXTREME PERIODS,0\n"
        "GROUND TEMPERATURES,0\nHOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0\nCOMMENTS 1,made up\nCOMMENTS 2,\n"
        "DATA PERIODS,1,1,Data,Sunday, 1/ 1,12/31\n";
    std::mt19937 random(seed);
    bool cloudy = false;
    for (int month = 1, of_year = 0; month <= 12; ++month)
        for (int day = 1; day <= days[month - 1]; ++day, ++of_year)
            for (int hour = 1; hour <= 24; ++hour) {
                if (random() % 6 == 0) cloudy = !cloudy;
                const double declination = .4093 * std::sin(2 * pi / 365 * (of_year - 80));
                const double sine = std::sin(latitude) * std::sin(declination) +
                                    std::cos(latitude) * std::cos(declination) * std::cos(pi / 12 * (hour - 12.5));
                const double clear = sine > 0 ? 1367 * std::pow(.7, std::pow(1 / (sine + .05), .678)) : 0;
                const int direct = int(cloudy ? .1 * clear : clear),
                          diffuse = sine > 0 ? int((cloudy ? 400 : 120) * sine) : 0;
                text += std::to_string(1995 + month) + "," + std::to_string(month) + "," + std::to_string(day) + "," +
                        std::to_string(hour) + ",60,?9?9,12.0,2.0,50,82000,0,0,300," +
                        std::to_string(int(direct * std::fmax(sine, 0)) + diffuse) + "," + std::to_string(direct) +
                        "," + std::to_string(diffuse) + ",0,0,0,0,180,3\n";
            }
    return text;
}

inline std::string with_crlf(std::string text) {
    for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, 1, '\r');
    return text;
}
