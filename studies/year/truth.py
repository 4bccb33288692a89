#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""truth.py OUT [SCENE ...]: how far hours of a year are off that share their paths, at 64 x 64 and at 128 x 128.

Each scene's Mondays (weather.py) are a year of 17 frames.  HOURS of it, half of them next to a limit of DGP, a quarter
with the sun in view, the rest by even steps of DGP, are rendered by themselves (-hours-apart) with SIZE x SIZE pixels
and FRAMES frames for the truth.  What is there is not made again.
"""
import csv
import math
import os
import pathlib
import subprocess
import sys

STUDY = pathlib.Path(__file__).resolve().parent
EXAMPLES = STUDY.parents[1] / "examples"
OFFICE = EXAMPLES / "scenes" / "office"
# What stands in or behind the office's window, and where it is.
SCENES = {"office": [], "blinds": [OFFICE / "blinds.rad"], "fabric": [STUDY / "fabric.rad"],
          "translucent": [STUDY / "translucent.rad"], "mirror": [STUDY / "mirror.rad"]}
PLACES = {"mirror": ["-39.74", "-105.18", "-7"]}
YEAR = os.environ.get("YEAR", "Mo 8-18")
HOURS, SIZE, FRAMES = (int(os.environ.get(*word)) for word in (("HOURS", 40), ("SIZE", 512), ("FRAMES", 33)))
LIMITS = (.35, .40, .45)
THREADS = os.environ.get("THREADS", "2")


def words_of(scene):
    words = ["-w-", "-n", THREADS, "-vf", OFFICE / "view.vf"]
    return [*words, OFFICE / "materials.rad", OFFICE / "layout.rad", *SCENES[scene]]


def weather_of(scene, out):
    path = out / f"{'north' if scene not in PLACES else scene}.epw"
    if not path.exists():
        made_up = [sys.executable, str(STUDY / "weather.py"), *PLACES.get(scene, [])]
        path.write_bytes(subprocess.run(made_up, stdout=subprocess.PIPE, check=True).stdout)
    return path


def render(out, scene, name, hours, size, frames, *more):
    """The table of these hours, unless it is there; with more options of ptrace."""
    path = out / scene / name
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        ptrace = ["ptrace", "-x", size, "-y", size, "-wea", weather_of(scene, out), "-hours", hours,
                  "-frames", frames, *more, *words_of(scene)]
        pipe = subprocess.Popen(list(map(str, ptrace)), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        sums = subprocess.Popen(["ptaccum", "-every", "x2/8"], stdin=pipe.stdout, stdout=subprocess.PIPE)
        part = path.with_suffix(".part")
        with open(part, "w") as out:
            subprocess.run(["vcmetrics", "-metrics", "Ev,DGPf,DGP.px,DGPf.px,pixels", "-ci", "95", "-last"],
                           stdin=sums.stdout, stdout=out, check=True)
        assert pipe.wait() == 0 and sums.wait() == 0
        part.rename(path)
    return path


class Hour:
    """A line of a table; `side` is how many pixels the picture has to a side, to a few percent."""

    def __init__(self, row):
        self.row = row
        value, low, high, self.ev, pixels, px, joins = (
            float(row[name]) for name in ("DGPf", "DGPf.lo", "DGPf.hi", "Ev", "pixels", "DGP.px", "DGPf.px"))
        known = not math.isnan(low)
        self.dgp, self.half = ((low + high) / 2, (high - low) / 2) if known else (value, 0 if self.ev == 0 else 1)
        bound = max(.0015 * math.sqrt(3217 / pixels), abs(px) / 3) if self.ev else 0
        self.low, self.high = self.dgp - self.half - bound + min(0, joins), self.dgp + self.half + bound + max(0, joins)
        self.pixels, self.px = pixels, px
        self.order = (known or self.ev == 0, pixels, float(row["frame"]))

    def holds(self, dgp, more=0):
        """Does its interval, with its pixels' error, hold this value?"""
        return self.low - more <= dgp <= self.high + more



def hours_of(*paths):
    """Hour -> its line, chosen as vcyear does."""
    hours = {}
    for path in paths:
        for row in csv.DictReader(open(path), delimiter="\t"):
            if row["frame"] != "frame":
                hour = Hour(row)
                if row["sky"] not in hours or hour.order >= hours[row["sky"]].order:
                    hours[row["sky"]] = hour
    return hours


def class_of(dgp):
    return sum(dgp > limit for limit in LIMITS)


def near(dgp):
    return min(abs(dgp - limit) for limit in LIMITS)


def chosen(year):
    """HOURS of the lit ones: next to a limit, the sun in view (a picture that small shows it by its largest .px), the
    rest by even steps of DGP."""
    rest = sorted((name for name, h in year.items() if h.ev > 0), key=lambda name: near(year[name].dgp))
    picked, rest = rest[:HOURS // 2], rest[HOURS // 2:]
    rest.sort(key=lambda name: -abs(year[name].px))
    picked, rest = picked + rest[:HOURS // 4], rest[HOURS // 4:]
    rest.sort(key=lambda name: year[name].dgp)
    n = HOURS - len(picked)
    return sorted(picked + [rest[int((k + .5) * len(rest) / n)] for k in range(n)])


def judge(scene, out):
    first = hours_of(render(out, scene, "year.tsv", YEAR, 64, 17))
    names = chosen(first)
    again = hours_of(render(out, scene, "128.tsv", " ".join(names), 128, 17))
    exact = hours_of(*(render(out, scene, f"truth.{SIZE}.{FRAMES}/{name}.tsv", name, SIZE, FRAMES, "-seed", 99,
                              "-hours-apart") for name in names))
    print(f"{scene}: {len(names)} of {len(first)} hours; the truth's own interval "
          f"+- {sum(h.half for h in exact.values()) / len(names):.4f}")
    for size, seen in ((64, first), (128, again)):
        off = [seen[name].dgp - exact[name].dgp for name in names]
        median = sorted(map(abs, off))[len(off) // 2]
        within = sum(abs(x) <= .01 for x in off)
        same = sum(class_of(seen[name].dgp) == class_of(exact[name].dgp) for name in names)
        inside = sum(seen[name].holds(exact[name].dgp, exact[name].half) for name in names)
        print(f"{scene}: {size} x {size}: off by {sum(map(abs, off)) / len(off):.4f} in the mean (bias "
              f"{sum(off) / len(off):+.4f}, median {median:.4f}), .01 or less in {within}, class equal in {same}, "
              f"within interval and pixels in {inside}", flush=True)


def main():
    out = pathlib.Path(sys.argv[1]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    for scene in sys.argv[2:] or SCENES:
        judge(scene, out)


if __name__ == "__main__":
    main()
