// SPDX-License-Identifier: BSD-3-Clause
// Made-up EPW files of any place: clear and cloudy hours under a sun of J. Spencer's series (Fourier series
// representation of the position of the sun, Search 2, 1971), which is none of the product's, its instruments' errors,
// and its clock's.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

struct MadeWeather {
    double latitude = 48.1, longitude = 11.6, zone = 1;  // north, east
    double shift_h = 0;                                  // its sun stands where it is so many hours later
    double noise = 0;                                    // of each irradiance, as a share
    double global_gain = 1, direct_gain = 1;             // of instruments
    double overcast = .4;                                // share of the hours
    double overcast_afternoon = 0;                       // so many more after noon
    unsigned seed = 1;
    int days = 365;
    // The spelling of a line of data, whose fields these are; of the first line.
    std::function<std::string(std::vector<std::string>)> line_of;
    std::string location;

    static double sine_of(double latitude, double longitude, double utc_h, int of_year) {
        constexpr double pi = 3.14159265358979;
        const double g = 2 * pi * (of_year - 1 + (utc_h - 12) / 24) / 365;
        const double declination = .006918 - .399912 * std::cos(g) + .070257 * std::sin(g) - .006758 * std::cos(2 * g) +
                                   .000907 * std::sin(2 * g) - .002697 * std::cos(3 * g) + .00148 * std::sin(3 * g);
        const double minutes = 229.18 * (.000075 + .001868 * std::cos(g) - .032077 * std::sin(g) -
                                         .014615 * std::cos(2 * g) - .040849 * std::sin(2 * g));
        const double angle = (utc_h + longitude / 15 + minutes / 60 - 12) * pi / 12, north = latitude * pi / 180;
        return std::sin(north) * std::sin(declination) + std::cos(north) * std::cos(declination) * std::cos(angle);
    }

    static std::string joined(const std::vector<std::string>& fields) {
        std::string line;
        for (const std::string& f : fields) line += (line.empty() ? "" : ",") + f;
        return line + "\n";
    }

    std::string epw() const {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> share;
        const int lengths[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
        std::string text =
            (location.empty() ? fmt::format("LOCATION,Madeup,-,-,made,0,{},{},{},10", latitude, longitude, zone)
                              : location) +
            "\nHOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0\nDATA PERIODS,1,1,Data,Sunday, 1/ 1,12/31\n";
        int of_year = 0;
        for (int month = 1; month <= 12; ++month)
            for (int day = 1; day <= lengths[month - 1] && of_year < days; ++day) {
                ++of_year;
                for (int hour = 1; hour <= 24; ++hour) {
                    double mean = 0;
                    for (int k = 0; k < 6; ++k)
                        mean += std::max(0., sine_of(latitude, longitude, hour - 1 + (k + .5) / 6 - zone + shift_h,
                                                     of_year)) /
                                6;
                    const double clouds = overcast + (hour > 12 ? overcast_afternoon : 0);
                    const bool cloudy = share(random) < clouds;
                    double direct = mean > 0 ? 1367 * std::pow(.7, std::pow(1 / (mean + .05), .678)) : 0;
                    if (cloudy) direct *= clouds >= 1 ? 0 : .1;
                    const double diffuse = (cloudy ? 400 : 120) * mean, global = direct * mean + diffuse;
                    const auto measured = [&](double w) {
                        return std::to_string(std::lround(std::max(0., w * (1 + noise * normal(random)))));
                    };
                    const std::string g = measured(global_gain * global), b = measured(direct_gain * direct),
                                      d = measured(diffuse);
                    const std::vector<std::string> fields{"2001",
                                                          std::to_string(month),
                                                          std::to_string(day),
                                                          std::to_string(hour),
                                                          "60",
                                                          "?9",
                                                          "12.0",
                                                          "2.0",
                                                          "50",
                                                          "82000",
                                                          "0",
                                                          "0",
                                                          "300",
                                                          g,
                                                          b,
                                                          d,
                                                          "0",
                                                          "0",
                                                          "0",
                                                          "0",
                                                          "180",
                                                          "3"};
                    text += line_of ? line_of(fields) : joined(fields);
                }
            }
        return text;
    }
};
