#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The sun in panes and polished surfaces (docs/decisions/0036): mirrored_sun.py OUT [FIRST:LAST] [SIZES] [SEEDS]

Writes scenes FIRST to LAST - 1 (default 0:8) of one to six smooth rectangles at any azimuth and tilt, of which at least
one mirrors the sun into the view; every second scene lies behind one more pane.  Renders each at SIZES (64,128,1024)
with SEEDS (6) seeds, with one at the largest size.  OUT/mirrored_sun.tsv: scene, size, seed, DGPf and its interval, DGP
not being cut at 1; the distance from the largest size; the part of it that is Ev's.  The programs are those on PATH.
"""
import math
import os
import random
import subprocess
import sys

MATERIALS = (
    "void glass smooth 0 0 3 .9 .9 .9",
    "void plastic smooth 0 0 5 .2 .2 .2 .05 0",
    "void metal smooth 0 0 5 .6 .6 .6 .9 0",
    "void dielectric smooth 0 0 5 1 1 1 1.33 0",
    "void mirror smooth 0 0 3 .08 .08 .08",
)


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def direction(azimuth, altitude):
    a, h = math.radians(azimuth), math.radians(altitude)
    return [math.cos(h) * math.sin(a), math.cos(h) * math.cos(a), math.sin(h)]


def rectangle(name, centre, normal, half):
    """A square about a centre, facing along normal."""
    side = unit(cross(normal, [0, 0, 1] if abs(normal[2]) < 0.9 else [1, 0, 0]))
    up = cross(side, normal)
    corners = [
        [c + half * (a * s + b * u) for c, s, u in zip(centre, side, up)]
        for a, b in ((-1, -1), (-1, 1), (1, 1), (1, -1))
    ]
    text = " ".join(f"{x:.9g}" for p in corners for x in p)
    return f"smooth_{name} polygon face_{name} 0 0 12 {text}"


def scene(number):
    dice = random.Random(number)
    sun = direction(dice.uniform(100, 260), dice.uniform(15, 65))
    lines = [
        "void light sun 0 0 3 6e6 6e6 5.5e6",
        "sun source disc 0 0 4 " + " ".join(f"{x:.9g}" for x in sun) + " .533",
        "void glow bright 0 0 4 8 8 9 0",
        "bright source sky 0 0 4 0 0 1 180",
        "void plastic ground 0 0 5 .05 .05 .04 0 0",
        "ground ring floor 0 0 8 0 0 0 0 0 1 0 200",
    ]
    eye = [0, 0, 1.2]
    for k in range(dice.randint(1, 6)):
        while True:
            seen = direction(dice.uniform(-65, 65), dice.uniform(-15, 40))
            normal = [s - v for s, v in zip(sun, seen)]
            if sum(x * x for x in normal) < 0.1:
                continue
            normal = unit(normal)
            if k > 0 and dice.random() < 0.5:
                normal = unit([dice.gauss(0, 1) for _ in range(3)])
            break
        distance = dice.uniform(3, 20)
        centre = [e + distance * v for e, v in zip(eye, seen)]
        lines.append(dice.choice(MATERIALS).replace("smooth", f"smooth_{k}"))
        lines.append(rectangle(k, centre, normal, distance * dice.uniform(0.08, 0.3)))
    if number % 2:
        lines.append("void glass smooth_window 0 0 3 .96 .96 .96")
        lines.append(rectangle("window", [0, 1, 1.2], [0, -1, 0], 20))
    return "\n".join(lines) + "\n"


def measure(path, size, seed, frames):
    words = "-w 2 1 1.87 2 1 1.4675e-5 .023 .03975"  # a quarter of DGP, which is then not cut at 1
    view = "-vta -vp 0 0 1.2 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180"
    command = (
        f"ptrace -w- -ab 0 {view} -x {size} -y {size} -seed {seed} -frames {frames} {path} | ptaccum -every x2/16 |"
        f" vcmetrics -W- {words} -metrics DGPf,Ev -ci 95"
    )
    out = subprocess.run(["bash", "-c", "set -o pipefail; " + command], check=True, capture_output=True, text=True)
    values = out.stdout.strip().split("\n")[-1].split("\t")
    return [4 * float(v) for v in values[2:5]] + [float(values[5])]


def main():
    out = sys.argv[1]
    first, last = (int(x) for x in (sys.argv[2] if len(sys.argv) > 2 else "0:8").split(":"))
    sizes = [int(x) for x in (sys.argv[3] if len(sys.argv) > 3 else "64,128,1024").split(",")]
    seeds = int(sys.argv[4]) if len(sys.argv) > 4 else 6
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(out, "mirrored_sun.tsv"), "a", encoding="utf-8") as table:
        for number in range(first, last):
            path = os.path.join(out, f"{number}.rad")
            with open(path, "w", encoding="utf-8") as f:
                f.write(scene(number))
            true = true_ev = None
            for size in sorted(sizes, reverse=True):
                for seed in range(1, 2 if true is None else seeds + 1):
                    value, low, high, ev = measure(path, size, seed, 5 if true is None else 17)
                    true, true_ev = (value, ev) if true is None else (true, true_ev)
                    numbers = (value, low, high, value - true, 5.87e-5 * (ev - true_ev))
                    row = (number, size, seed, *(f"{x:.4f}" for x in numbers))
                    print(*row, sep="\t", file=table, flush=True)
                    print(*row, sep="\t", flush=True)


if __name__ == "__main__":
    main()
