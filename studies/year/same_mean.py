#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""same_mean.py OUT [SCENE ...]: is the mean of an hour that shares its paths that of the hour by itself (-hours-apart)?

Of each scene's year (weather.py, of either hemisphere) HOURS random lit hours are rendered in both ways by SEEDS seeds:
pictures of 32 x 32 with FRAMES frames (apart APART, which is as narrow), sensors, and frame 0 alone by four times as
many seeds, because its law is skew.  A picture counts by the means of 4 x 4 blocks.
Prints for each scene the root mean square of (shared - apart) / standard error over hours and blocks, over that of
Student's law, so that 1 is expected; and the difference of the sum of all hours with its standard error.
What is there is not made again.
"""
import array
import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys

from truth import EXAMPLES, OFFICE, STUDY

HOURS, SEEDS, FRAMES, APART, SIZE = (int(os.environ.get(*word)) for word in (
    ("HOURS", 23), ("SEEDS", 8), ("FRAMES", 65), ("APART", 17), ("SIZE", 32)))
GOLDEN = STUDY.parents[1] / "tests" / "golden" / "vectors"
CLASSROOM = EXAMPLES / "scenes" / "classroom"
# Inside the office's window; on its floor, where the sun comes; a court below the sky.
LAYER = "\n0\n0\n12 .3 -.02 .85  3.7 -.02 .85  3.7 -.02 2.6  .3 -.02 2.6\n"
BSDF = "void BSDF window\n6 0 {} 0 0 1 .\n0\n0\nwindow polygon layer" + LAYER
POLISHED = ("void metal polished 0 0 5 .8 .8 .7 .9 .05\n"
            "polished polygon tray 0 0 12 .8 .2 .05  3.2 .2 .05  3.2 2 .05  .8 2 .05\n")
COURT = ("void plastic wall 0 0 5 .6 .55 .5 0 0\nvoid plastic ground 0 0 5 .3 .3 .25 .03 .1\n"
         "ground ring paving 0 0 8 0 0 0  0 0 1  0 60\n"
         "!genbox wall south 12 .3 5 | xform -t -6 -6 0 -a 2 -rz 180\n"
         "!genbox wall west .3 12 5 | xform -t -6 -6 0 -a 2 -rz 180\n"
         "wall cylinder column 0 0 7 1.5 -2 0  1.5 -2 4  .3\n")
# Latitude, view, scene, sensors; in the south the office looks north.
DESK = [(1 + .5 * x, .5 + y, .8, 0, 0, 1) for y in range(5) for x in range(5)]
SCENES = {
    "glass": (39.74, "office", "", DESK),
    "blinds": (39.74, "office", f"!xform {OFFICE}/blinds.rad", DESK),
    "fabric": (-33.9, "turned", f"!xform {STUDY}/fabric.rad", DESK),
    "translucent": (51.5, "office", f"!xform {STUDY}/translucent.rad", DESK),
    "klems": (-33.9, "turned", BSDF.format(GOLDEN / "klemsq.xml"), DESK),
    "tree": (39.74, "office", BSDF.format(GOLDEN / "tt4.xml"), DESK),
    "polished": (51.5, "office", POLISHED, DESK),
    "lamps": (-20, "classroom", "", [(x + 1, y + 1, .8, 0, 0, 1) for y in range(5) for x in range(5)]),
    "court": (-33.9, "court", COURT, [(2 * x - 4, 2 * y - 4, .8, 0, 0, 1) for y in range(5) for x in range(5)]),
}


def run(words):
    return subprocess.run(list(map(str, words)), stdout=subprocess.PIPE, check=True).stdout


def prepared(name, out):
    """Folder with weather, view and scene; gives the words of ptrace."""
    latitude, kind, more, points = SCENES[name]
    folder = out / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "site.epw").write_bytes(run([sys.executable, STUDY / "weather.py", latitude, -105.18, -7]))
    (folder / "more.rad").write_text(more)
    turn = "-rz 180" if kind == "turned" else "-t 0 0 0"
    (folder / "turned.rad").write_text(f"!xform {turn} {OFFICE}/layout.rad more.rad\n")
    sign = -1 if kind == "turned" else 1
    (folder / "grid.pts").write_text("".join(f"{sign * p[0]} {sign * p[1]} {' '.join(map(str, p[2:]))}\n"
                                             for p in points))
    view = {"office": ["-vf", OFFICE / "view.vf"], "classroom": ["-vf", CLASSROOM / "back_row.vf"],
            "turned": ["-vf", OFFICE / "view.vf", *"-vp -2 -2.7 1.2 -vd 0 1 -.08".split()],
            "court": "-vta -vp 0 3 1.6 -vd .1 -1 .2 -vu 0 0 1 -vh 180 -vv 180".split()}[kind]
    scene = {"classroom": [CLASSROOM / (f + ".rad") for f in
                           ("materials", "room", "furniture", "ceiling_lights", "outside")],
             "court": ["more.rad"]}.get(kind, [OFFICE / "materials.rad", "turned.rad"])
    return folder, view, scene


def hours_of(name, folder):
    """HOURS lit ones, at random."""
    lit = []
    for line in (folder / "site.epw").read_text().splitlines()[8:]:
        words = line.split(",")
        if int(words[15]) > 15:
            lit.append(f"{int(words[1]):02}{int(words[2]):02}_{int(words[3]) - 1:02}30")
    return sorted(random.Random(name).sample(lit, HOURS))


def blocks(pixels, width, height, n=4):
    """Means of grey of n x n blocks, row by row."""
    out, side = [0.] * (n * n), width // n
    for y in range(height):
        for x in range(n):
            row = pixels[3 * (y * width + x * side):3 * (y * width + (x + 1) * side)]
            out[y // side * n + x] += sum(row) / 3 / side ** 2
    return out


def pictures(stream):
    """Name of sky -> blocks, of a stream of sums."""
    out, at = {}, 0
    while at < len(stream):
        head = re.compile(rb"(?s).*?\n\n-Y (\d+) \+X (\d+)\n").match(stream, at)
        height, width = int(head[1]), int(head[2])
        numbers = (4 if b"\nNCOMP=4\n" in head[0] else 3) * width * height
        sky = re.search(rb"\nSKYNAME=(\S+)", head[0])
        grid = re.search(rb"\nGRID=\S+ 0 (\d+)", head[0])
        pixels = array.array("f", stream[head.end():head.end() + 4 * numbers])
        values = [sum(pixels[3 * i:3 * i + 3]) / 3 for i in range(int(grid[1]))] if grid else blocks(
            pixels, width, height)
        out[sky[1].decode()] = values
        at = head.end() + 4 * numbers
    return out


def rendered(name, out, what, way, seed):
    """Hour -> blocks, of one seed."""
    path = out / name / f"{what}_{way}_{seed}.json"
    if not path.exists():
        folder, view, scene = prepared(name, out)
        frames = {"zero": (1, 1), "picture": (FRAMES, APART), "sensors": (33, 2)}[what][way == "apart"]
        size = ["-points", "grid.pts"] if what == "sensors" else [*view, "-x", SIZE, "-y", SIZE, "-moments-"]
        ptrace = ["ptrace", "-w-", "-n", 1, *size, "-wea", "site.epw", "-hours", " ".join(hours_of(name, folder)),
                  "-frames", frames, "-seed", seed, *(["-hours-apart"] if way == "apart" else []), *scene]
        pipe = subprocess.Popen(list(map(str, ptrace)), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=folder)
        sums = subprocess.run(["ptaccum", "-every", "1000000"], stdin=pipe.stdout, stdout=subprocess.PIPE, check=True)
        assert pipe.wait() == 0, ptrace
        path.with_suffix(".part").write_text(json.dumps(pictures(sums.stdout)))
        path.with_suffix(".part").rename(path)
    return json.loads(path.read_text())


def mean_var(values):
    mean = sum(values) / len(values)
    return mean, sum((v - mean) ** 2 for v in values) / (len(values) - 1) / len(values)


def student(a, b):
    """(a - b) / its standard error, over the root mean square of Student's law; None where both are exact."""
    (ma, va), (mb, vb) = mean_var(a), mean_var(b)
    if va + vb <= (1e-6 * mb) ** 2:
        return None, abs(ma - mb) / abs(mb) if mb else abs(ma)
    n = len(a)
    degrees = (va + vb) ** 2 * (n - 1) / (va ** 2 + vb ** 2)
    return (ma - mb) / math.sqrt((va + vb) * degrees / (degrees - 2)), None


def judge(name, what, out):
    seeds = range(1, (4 if what == "zero" else 1) * SEEDS + 1)
    shared, apart = ([rendered(name, out, what, way, seed) for seed in seeds] for way in ("shared", "apart"))
    z, exact, worst = [], [], (0, "")
    for hour in shared[0]:
        for i in range(len(shared[0][hour])):
            t, off = student([s[hour][i] for s in shared], [s[hour][i] for s in apart])
            if t is None:
                exact.append(off)
                continue
            z.append(t)
            worst = max(worst, (abs(t), f"{hour} {i}"))
    sums = [[sum(map(sum, s.values())) for s in way] for way in (shared, apart)]
    (ma, va), (mb, vb) = map(mean_var, sums)
    se = math.sqrt(va + vb)
    rms = math.sqrt(sum(t * t for t in z) / len(z))
    print(f"{name} {what}: {len(shared[0])} hours, {len(z)} values: rms z {rms:.3f}, largest {worst[0]:.1f} "
          f"({worst[1]}); sum {100 * (ma / mb - 1):+.3f} +- {100 * se / mb:.3f} % ({(ma - mb) / se:+.1f} se)"
          + (f"; {len(exact)} exact, off by {max(exact):.1e} at most" if exact else ""), flush=True)
    return z


def main():
    out = pathlib.Path(sys.argv[1]).resolve()
    pooled = {}
    for what in ("picture", "sensors", "zero"):
        for name in sys.argv[2:] or SCENES:
            pooled.setdefault(what, []).extend(judge(name, what, out))
    for what, z in pooled.items():
        print(f"{what}: {len(z)} values, rms z {math.sqrt(sum(t * t for t in z) / len(z)):.3f}")


if __name__ == "__main__":
    main()
