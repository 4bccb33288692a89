#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""make_skies.py > skies.tsv, with RADIANCE's gendaylit and gendaymtx on PATH: 200 hours of made-up weather in three
climates, the Perez sky of each by gendaylit and where gendaymtx puts the sun."""
import math
import os
import random
import subprocess
import tempfile

SITES = [(39.74, 105.18, 105), (28.58, -77.2, -82.5), (-33.95, -151.18, -150)]  # degrees north, west; meridian
DAYS = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31]


def run(*words, text=""):
    return subprocess.run([str(w) for w in words], input=text, capture_output=True, text=True, check=True).stdout


def sun_of_gendaymtx(site, row):
    head = (f"place p\nlatitude {site[0]}\nlongitude {site[1]}\ntime_zone {site[2]}\nsite_elevation 0\n"
            "weather_data_file_units 1\n")
    with tempfile.NamedTemporaryFile() as suns:
        run("gendaymtx", "-i", 60, "-m", 1, "-D", suns.name, text=head + row + "\n")
        numbers = [line.split() for line in open(suns.name).read().splitlines() if line.endswith("0.5330")]
    return numbers[0][1:4]


def main():
    rng = random.Random(1)
    print("# make_skies.py; RADIANCE's gendaylit -i 60 and gendaymtx -i 60 (pyradiance 1.3.1)")
    print("# latitude longitude meridian month day hour direct diffuse dew point; solar radiance; skyfunc; sun")
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
        date = f"{month} {day} {hour}"
        sky = run("gendaylit", *date.split(), "-a", site[0], "-o", site[1], "-m", site[2], "-W", direct, diffuse,
                  "-d", dew, "-i", 60).split("\n\n")
        if "light" not in sky[1]:
            continue  # no sun
        solar = sky[1].split()[-1]
        numbers = sky[3].split()[-10:]
        print("\t".join([f"{site[0]} {site[1]} {site[2]} {date} {direct} {diffuse} {dew}", solar, " ".join(numbers),
                         " ".join(sun_of_gendaymtx(site, f"{date} {direct} {diffuse}"))]))
        rows += 1


if __name__ == "__main__":
    main()
