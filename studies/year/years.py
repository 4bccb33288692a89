#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""years.py OUT [DRAW ...]: how often the intervals of a year hold by noise alone, of hours that share their paths.

Rooms are draws of studies/coverage/make_room.py.  The hours of YEAR (weather.py) are rendered by SEEDS sets of paths:
a view of SIZE x SIZE pixels, and 16 sensors.  YEARS draws of LENGTH hours are then made of each set; about 5 % of a
view's hours are above one of the limits, so that its class is hard to say.  The truth is the mean of the other sets, so
that pixels, which are the same in all, do no harm; their bounds are left out.  Draws of one set share its noise: the
error that is printed is that of the mean over sets.  What is there is not made again.
"""
import csv
import os
import pathlib
import random
import statistics
import subprocess
import sys

from truth import LIMITS, STUDY

sys.path.insert(0, str(STUDY.parent / "coverage"))
from make_room import Room  # noqa: E402

WORDS = {"SEEDS": 12, "YEARS": 20, "LENGTH": 200, "SIZE": 32, "FRAMES": 17}
SEEDS, YEARS, LENGTH, SIZE, FRAMES = (int(os.environ.get(*word)) for word in WORDS.items())
YEAR = os.environ.get("YEAR", "Mo 8-18")
NUMBERS = {"view": [f"above_{limit:.2f}" for limit in LIMITS] + ["DGPe5"],
           "grid": ["DA", "sDA"] + ["UDI_" + part for part in ("below", "supplementary", "autonomous", "exceeded")]}
METRICS = {"view": ["-metrics", "Ev,DGPf,DGP.px,DGPf.px,pixels", "-ci", "95"], "grid": ["-each"]}


def rendered(out, draw, what, seed):
    """(hour, sensor) -> its row."""
    folder = out / draw
    path = folder / f"{what}_{seed}.tsv"
    if not path.exists():
        room = Room(int(draw))
        room.write(folder, int(draw))
        grid = "".join(f"{room.width * (x + .5) / 4} {room.depth * (y + .5) / 4} .8 0 0 1\n"
                       for y in range(4) for x in range(4))
        (folder / "grid.pts").write_text(grid)
        weather = subprocess.run([sys.executable, STUDY / "weather.py"], stdout=subprocess.PIPE, check=True).stdout
        (folder / "site.epw").write_bytes(weather)
        where = ["-points", "grid.pts"] if what == "grid" else ["-vf", "view.vf", "-x", SIZE, "-y", SIZE]
        ptrace = ["ptrace", "-n", 1, "-seed", seed, "-frames", FRAMES, "-wea", "site.epw", "-hours", YEAR, *where]
        pipe = subprocess.Popen([*map(str, ptrace), "room.rad"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                cwd=folder)
        sums = subprocess.Popen(["ptaccum", "-every", "x2/8"], stdin=pipe.stdout, stdout=subprocess.PIPE)
        text = subprocess.run(["vcmetrics", "-last", *METRICS[what]], stdin=sums.stdout, stdout=subprocess.PIPE,
                              check=True).stdout
        assert pipe.wait() == 0 and sums.wait() == 0
        path.with_suffix(".part").write_bytes(text)
        path.with_suffix(".part").rename(path)
    rows = {(row["sky"], row.get("point", "")): row for row in csv.DictReader(open(path), delimiter="\t")}
    for row in rows.values():
        if what == "view":
            row.update({"DGP.px": "0", "DGPf.px": "0", "pixels": "1e12"})
    return rows


def value(row):
    low, high = (("lo", "hi") if "lo" in row else ("DGPf.lo", "DGPf.hi"))
    middle = (float(row[low]) + float(row[high])) / 2
    return middle if middle == middle else float(row["E" if "E" in row else "DGPf"])


def numbers_of(what, truth):
    """What vcyear prints of these values: hour -> those of its sensors."""
    n = len(truth)
    if what == "view":
        dgp = sorted((values[0] for values in truth.values()), reverse=True)
        return [sum(x > limit for x in dgp) for limit in LIMITS] + [dgp[n // 20]]
    sensors = list(zip(*truth.values()))
    share = [sum(x >= 300 for x in sensor) / n for sensor in sensors]
    bins = [(0, 100), (100, 300), (300, 3000), (3000, float("inf"))]
    udi = [sum(low <= x < high for sensor in sensors for x in sensor) / n / len(sensors) for low, high in bins]
    return [statistics.mean(share), statistics.mean(x >= .5 for x in share)] + udi


def drawn(rng, what, truth):
    """Hours of a year: hour -> values of its sensors."""
    names = sorted(truth)
    if what == "grid":
        return {name: truth[name] for name in sorted(rng.sample(names, LENGTH))}
    most = [limit for limit in LIMITS if sum(v[0] > limit for v in truth.values()) > 2] or [LIMITS[0]]
    limit = rng.choice(most)
    above, below = ([name for name in names if (truth[name][0] > limit) == side] for side in (True, False))
    above = rng.sample(above, min(len(above), max(1, LENGTH // 20 + rng.randint(-3, 4))))
    return {name: truth[name] for name in above + rng.sample(below, min(len(below), LENGTH - len(above)))}


def said(what, rows, path):
    columns = list(next(iter(rows.values())))
    path.write_text("\n".join("\t".join(row) for row in (columns, *(row.values() for row in rows.values()))) + "\n")
    text = subprocess.run(["vcyear", "-w-", "-format", "tsv", path], stdout=subprocess.PIPE, check=True,
                          universal_newlines=True).stdout
    row = next(csv.DictReader(text.splitlines(), delimiter="\t"))
    return [(float(row[name + ".lo"]), float(row[name + ".hi"])) for name in NUMBERS[what]]


def main():
    out = pathlib.Path(sys.argv[1]).resolve()
    for what in ("view", "grid"):
        held = {name: [] for name in NUMBERS[what]}  # of each set of paths: share of its years
        width = {name: [] for name in NUMBERS[what]}
        for draw in sys.argv[2:]:
            sets = [rendered(out, draw, what, seed) for seed in range(1, SEEDS + 1)]
            values = [{key: value(row) for key, row in rows.items()} for rows in sets]
            rng = random.Random(draw)
            for k, rows in enumerate(sets):
                truth = {}
                for key in rows:
                    mean = statistics.mean(v[key] for i, v in enumerate(values) if i != k)
                    truth.setdefault(key[0], []).append(mean)
                tries = {name: [] for name in NUMBERS[what]}
                for _ in range(YEARS):
                    year = drawn(rng, what, truth)
                    true = numbers_of(what, year)
                    seen = said(what, {key: row for key, row in rows.items() if key[0] in year}, out / "drawn.tsv")
                    for name, t, (low, high) in zip(NUMBERS[what], true, seen):
                        if not low == high == t:  # where it varies
                            tries[name].append(low - 1e-9 <= t <= high + 1e-9)
                            width[name].append(high - low)
                for name, inside in tries.items():
                    held[name] += [statistics.mean(inside)] if inside else []
        for name in NUMBERS[what]:
            if len(held[name]) > 1:
                error = statistics.stdev(held[name]) / len(held[name]) ** .5
                print(f"{what} {name}: {len(width[name])} years of {len(held[name])} sets of paths, "
                      f"{statistics.mean(held[name]):.1%} +- {error:.1%} inside, mean width "
                      f"{statistics.mean(width[name]):.3g}")


if __name__ == "__main__":
    main()
