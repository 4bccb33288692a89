#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""make_skies.py > skies.tsv, with RADIANCE's gendaylit on PATH: 200 hours of made-up weather in three climates and many
years, the sun and the Perez sky of each."""
import math
import random
import subprocess

SITES = [(39.74, 105.18, 105), (28.58, -77.2, -82.5), (-33.95, -151.18, -150)]  # degrees north, west; meridian
DAYS = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31]


def run(*words):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, check=True).stdout


def main():
    rng = random.Random(1)
    print("# make_skies.py; RADIANCE's gendaylit -i 60 (pyradiance 1.3.1)")
    print("# latitude longitude meridian year month day hour direct diffuse dew point; solar radiance; skyfunc")
    rows = 0
    while rows < 200:
        site = SITES[rows % 3]
        month = rng.randrange(1, 13)
        day, hour = rng.randrange(1, DAYS[month - 1] + 1), rng.randrange(24) + .5
        clear = rng.random() < .5
        declination = math.radians(23.45) * math.sin(2 * math.pi / 365 * (30.4 * month + day - 111))
        angle = math.radians(15 * (hour - 12 + (site[2] - site[1]) / 15))
        latitude = math.radians(site[0])
        sine = (math.sin(latitude) * math.sin(declination) +
                math.cos(latitude) * math.cos(declination) * math.cos(angle))
        if sine < -.1:
            continue
        air = 1 / (max(sine, 0) + .05)
        direct = round(1367 * .7 ** air ** .678) if clear else round(rng.random() ** 3 * 200)
        diffuse = max(1, round(1367 * max(sine, .005) * (.1 if clear else .1 + .3 * rng.random())))
        dew = round(-5 + 20 * rng.random(), 1)
        date, year = f"{month} {day} {hour}", rng.randrange(1950, 2051)
        sky = run("gendaylit", *date.split(), "-a", site[0], "-o", site[1], "-m", site[2], "-W", direct, diffuse,
                  "-d", dew, "-i", 60, "-y", year).split("\n\n")
        if "light" not in sky[1]:
            continue  # no sun
        solar = sky[1].split()[-1]
        numbers = sky[3].split()[-10:]
        print("\t".join([f"{site[0]} {site[1]} {site[2]} {year} {date} {direct} {diffuse} {dew}", solar,
                         " ".join(numbers)]))
        rows += 1


if __name__ == "__main__":
    main()
