#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""radiance.py OUT SCENE:HOUR ...: DGP of hours of truth.py by rpict and evalglare, beside luxpipe's.

Needs RADIANCE's programs in PATH, and its lib in RAYPATH.  Sides of the pictures: SIDES (1000 4000).  They share one
file of ambient values; of 4000 rpict renders each fourth pixel and interpolates where these agree within 4 %.
Run truth.py first: OUT and the tables in it are its own.  What is there is not made again.
"""
import os
import pathlib
import subprocess
import sys

import truth

SIDES = os.environ.get("SIDES", "1000 4000").split()
AMBIENT = os.environ.get("AMBIENT", "-ab 6 -ad 1024 -as 256 -aa .15 -ar 64 -lw 1e-4 -lr 8 -dj 0 -dt 0 -ds .02 -ss 4")


def output(words, **options):
    return subprocess.run(list(map(str, words)), stdout=subprocess.PIPE, check=True, **options).stdout


def octree(out, scene, hour, path):
    """Frozen octree of the scene under gendaylit's sky for the hour's line: ptrace -wea's, up to its level."""
    lines = [line.split(",") for line in truth.weather_of(scene, out).read_text().splitlines()]
    latitude, longitude, zone = map(float, lines[0][6:9])
    month, day, at = int(hour[:2]), int(hour[2:4]), int(hour[5:7]) + int(hour[7:]) / 60
    line = next(w for w in lines[8:] if (int(w[1]), int(w[2]), int(w[3])) == (month, day, int(at) + 1))
    sky = output(["gendaylit", month, day, at, "-y", line[0], "-a", latitude, "-o", -longitude, "-m", -15 * zone,
                  "-W", line[14], line[15], "-d", line[7]])
    for side, up in (("sky", 1), ("ground", -1)):
        sky += f"\nskyfunc glow {side}_glow 0 0 4 1 1 1 0\n{side}_glow source {side} 0 0 4 0 0 {up} 180\n".encode()
    files = [word for word in truth.words_of(scene) if str(word).endswith(".rad")]
    path.write_bytes(output(["oconv", "-f", *files, "-"], input=sky, cwd=truth.OFFICE))


def dgp_of(out, scene, hour, side):
    folder = out / scene / "rpict"
    folder.mkdir(exist_ok=True)
    picture, tree = folder / f"{hour}.{side}.hdr", folder / f"{hour}.oct"
    if not picture.exists():
        octree(out, scene, hour, tree)
        ambient = folder / f"{hour}.{AMBIENT.replace(' ', '')}.amb"
        words = ["rpict", "-w", "-vf", truth.OFFICE / "view.vf", "-x", side, "-y", side, "-pj", 0, "-pt", .04,
                 "-ps", max(1, int(side) // 1000), "-af", ambient, *AMBIENT.split()]
        if not list(folder.glob(f"{hour}.*.hdr")):  # an overture, so that values do not follow scanlines
            output([*words, "-x", 250, "-y", 250, tree])
        part = picture.with_suffix(".part")
        part.write_bytes(output([*words, tree]))
        part.rename(picture)
    numbers = output(["evalglare", "-d", picture]).split(b":")[-1].split()
    return float(numbers[0]), float(numbers[2])


def main():
    out = pathlib.Path(sys.argv[1]).resolve()
    for word in sys.argv[2:]:
        scene, hour = word.split(":")
        tables = [out / scene / "year.tsv"]
        larger = [p for p in sorted((out / scene).glob(f"truth.*/{hour}.tsv"))]
        print(word, *(f"rpict {side}: {dgp:.4f} (Ev {ev:.0f})" for side in SIDES
                      for dgp, ev in [dgp_of(out, scene, hour, side)]), end="", sep="\t")
        for name, h in [("the year", truth.hours_of(*tables)[hour]),
                        *((p.parent.name, truth.hours_of(p)[hour]) for p in larger)]:
            print(f"\t{name}: {h.dgp:.4f} +- {h.half:.4f} (Ev {h.ev:.0f})", end="")
        print(flush=True)


if __name__ == "__main__":
    main()
