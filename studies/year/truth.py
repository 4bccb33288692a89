#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""truth.py OUT [SCENE ...]: how far hours of a small year are off, and how often a year's intervals hold.

Of each scene's Mondays (weather.py) HOURS are chosen, half of them next to a limit of DGP, half by even steps of DGP,
and rendered at 512 x 512 for the truth.  YEARS small years of these hours have different seeds.  What is there is not
made again.
"""
import csv
import math
import os
import pathlib
import subprocess
import sys

STUDY = pathlib.Path(__file__).resolve().parent
OFFICE = STUDY.parents[1] / "examples" / "scenes" / "office"
SCENES = {"office": ["materials.rad", "layout.rad"], "blinds": ["materials.rad", "layout.rad", "blinds.rad"]}
HOURS, YEARS = int(os.environ.get("HOURS", 40)), int(os.environ.get("YEARS", 20))
SIZE, FRAMES = os.environ.get("SIZE", "512"), os.environ.get("FRAMES", "33")
LIMITS = (.35, .40, .45)
COUNTS = [f"above_{limit:.2f}" for limit in LIMITS] + ["DGPe5", "GA"]


def render(path, scene, hours, size, frames, seed=1):
    """The table of these hours, unless it is there."""
    if not path.exists():
        ptrace = ["ptrace", "-w-", "-vf", str(OFFICE / "view.vf"), "-x", size, "-y", size, "-wea",
                  os.environ["WEATHER"], "-hours", hours, "-frames", frames, "-seed", str(seed),
                  *(str(OFFICE / name) for name in SCENES[scene])]
        pipe = subprocess.Popen(ptrace, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        sums = subprocess.Popen(["ptaccum", "-every", "x2/8"], stdin=pipe.stdout, stdout=subprocess.PIPE)
        part = path.with_suffix(".part")
        with open(part, "w") as out:
            subprocess.run(["vcmetrics", "-metrics", "Ev,DGPf,DGP.px,pixels", "-ci", "95"], stdin=sums.stdout,
                           stdout=out, check=True)
        assert pipe.wait() == 0 and sums.wait() == 0
        part.rename(path)
    return path


def hours_of(path):
    """Hour -> (DGP, half of its interval, Ev), from the last line of each."""
    last = {row["sky"]: row for row in csv.DictReader(open(path), delimiter="\t") if row["frame"] != "frame"}
    hours = {}
    for hour, row in last.items():
        value, low, high, ev = (float(row[name]) for name in ("DGPf", "DGPf.lo", "DGPf.hi", "Ev"))
        hours[hour] = (value, 0, ev) if math.isnan(low) else ((low + high) / 2, (high - low) / 2, ev)
    return hours


def chosen(year):
    lit = sorted((dgp, hour) for hour, (dgp, half, ev) in year.items() if ev > 0)
    near = sorted(lit, key=lambda item: min(abs(item[0] - limit) for limit in LIMITS))[:HOURS // 2]
    rest = [item for item in lit if item not in near]
    return sorted(hour for dgp, hour in near + [rest[int((k + .5) * len(rest) / (HOURS - HOURS // 2))]
                                                 for k in range(HOURS - HOURS // 2)])


def verdict(*tables):
    words = ["vcyear", "-w-", "-format", "tsv", *map(str, tables)]
    text = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    return next(csv.DictReader(text.splitlines(), delimiter="\t"))


def class_of(dgp):
    return sum(dgp > limit for limit in LIMITS)


def judge(scene, folder):
    (folder / "truth").mkdir(parents=True, exist_ok=True)
    hours = chosen(hours_of(render(folder / "mondays.tsv", scene, "Mo 8-18", "64", "9")))
    words = " ".join(hours)
    files = {hour: folder / "truth" / f"{hour}.tsv" for hour in hours}
    exact = {hour: hours_of(render(file, scene, hour, SIZE, FRAMES))[hour] for hour, file in files.items()}
    years = [render(folder / f"year.{k}.tsv", scene, words, "64", "9", k) for k in range(2, YEARS + 2)]
    off = [hours_of(year)[hour][0] - exact[hour][0] for year in years for hour in hours]
    same = [class_of(hours_of(year)[hour][0]) == class_of(exact[hour][0]) for year in years for hour in hours]
    n, within = len(off), sum(abs(x) <= .01 for x in off)
    print(f"{scene}: {len(hours)} hours of {len(years)} years; DGP off by {sum(map(abs, off)) / n:.4f} in the mean "
          f"(bias {sum(off) / n:+.4f}), .01 or less in {within / n:.1%}, class equal in {sum(same) / n:.1%}; "
          f"the truth's own interval +- {sum(e[1] for e in exact.values()) / len(hours):.4f}")
    truth, said = verdict(*files.values()), [verdict(year) for year in years]
    for name in COUNTS:
        inside = sum(float(v[name + ".lo"]) <= float(truth[name]) + 1e-9 and
                     float(truth[name]) - 1e-9 <= float(v[name + ".hi"]) for v in said)
        width = sorted(float(v[name + ".hi"]) - float(v[name + ".lo"]) for v in said)[len(said) // 2]
        print(f"{scene}: {name} {float(truth[name]):.4g}: inside in {inside} of {len(said)}, median width {width:.3g}")
    kinds = ["high", "medium", "minimum", "none"]
    exact_class = kinds[class_of(float(truth["DGPe5"]) - 1e-9)]
    wrong = sum(v["class"] not in (exact_class, "undecided") for v in said)
    print(f"{scene}: class {exact_class}: {sum(v['class'] == 'undecided' for v in said)} undecided, {wrong} wrong")


def main():
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    os.environ["WEATHER"] = str(out / "made_up.epw")
    (out / "made_up.epw").write_bytes(subprocess.run([sys.executable, str(STUDY / "weather.py")], capture_output=True,
                                                     check=True).stdout)
    for scene in sys.argv[2:] or SCENES:
        judge(scene, out / scene)


if __name__ == "__main__":
    main()
