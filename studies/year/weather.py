#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""weather.py [LATITUDE LONGITUDE ZONE] > made_up.epw: a year of made-up weather, the same in each run: clear hours and
cloudy ones, which stay for some hours.  Studies run by it; nothing is to be concluded from it about a place."""
import math
import random
import sys

DAYS = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31]


def main():
    latitude, longitude, zone = map(float, sys.argv[1:4] or (39.74, -105.18, -7))
    print(f"LOCATION,Made up,-,-,weather.py,0,{latitude:g},{longitude:g},{zone:g},0")
    for line in ("DESIGN CONDITIONS,0", "TYPICAL/EXTREME PERIODS,0", "GROUND TEMPERATURES,0",
                 "HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0", "COMMENTS 1,made up", "COMMENTS 2,",
                 "DATA PERIODS,1,1,Data,Sunday, 1/ 1,12/31"):
        print(line)
    rng = random.Random(1)
    cloudy, of_year = False, 0
    phi = math.radians(latitude)
    for month, days in enumerate(DAYS, 1):
        for day in range(1, days + 1):
            of_year += 1
            declination = .4093 * math.sin(2 * math.pi / 365 * (of_year - 81))
            for hour in range(1, 25):
                cloudy ^= rng.random() < 1 / 6
                solar = hour - .5 + longitude / 15 - zone
                sine = (math.sin(phi) * math.sin(declination) -
                        math.cos(phi) * math.cos(declination) * math.cos(math.pi / 12 * solar))
                clear = 1367 * .7 ** ((1 / (sine + .05)) ** .678) if sine > 0 else 0
                direct = round(clear * (rng.random() * .2 if cloudy else 1))
                diffuse = round(max(sine, 0) * (200 + 300 * rng.random() if cloudy else 120))
                print(f"2001,{month},{day},{hour},60,made up,12,2,50,101325,0,0,300,"
                      f"{round(direct * max(sine, 0)) + diffuse},{direct},{diffuse}")


if __name__ == "__main__":
    main()
