#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""beside.py OUT: a year at the 96 sensors of a room by Honeybee's annual recipes and by luxpipe, against HOURS (40) of
its hours rendered well by themselves (FRAMES, 257), of which rtrace renders RTRACE (3) as well.

Needs RADIANCE and the recipes (lbt-recipes and pyradiance beside this Python) and luxpipe's programs in PATH.  The
room is that of bench/recipes.py, the weather weather.py's, for all of them as a WEA file.  Prints a line for each:
seconds of a core, and how far the illuminance of a sensor in an hour is off (mean, bias, 95 % within), and in how many
it is on the wrong side of 300 lx.  luxpipe's seconds are those of ptrace, ptaccum and vcmetrics -each.  What is there
is not made again.
"""
import csv
import os
import pathlib
import subprocess
import sys

STUDY = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(STUDY.parents[1] / "bench"))
import numpy  # noqa: E402
import pyradiance  # noqa: E402
import recipes  # noqa: E402

OUT = recipes.OUT
RADIANCE = pathlib.Path(pyradiance.BINPATH).parent
HOURS, FRAMES, RTRACE = (int(os.environ.get(*w)) for w in (("HOURS", 40), ("FRAMES", 257), ("RTRACE", 3)))
WEA = OUT / "site.wea"
MODEL = OUT / "annual-daylight" / "annual_daylight" / "model"
POINTS = MODEL / "grid" / "floor.pts"
# The recipes, with their own parameters and with such that hold all bounces.
FULL = "-ab 6 -ad 25000 -lw 1e-6"
RECIPES = [("annual-daylight", None), ("annual-daylight-enhanced", None), ("annual-daylight-enhanced", FULL)]
DAYS = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31]


def run(words, **options):
    return subprocess.run(list(map(str, words)), stdout=subprocess.PIPE, check=True, **options).stdout


def cached(path, make):
    """What `make` prints, and its seconds of a core."""
    took = path.with_suffix(".s")
    if not took.exists():
        text, cpu, _ = recipes.timed(make)
        path.write_bytes(text)
        took.write_text(f"{cpu:.1f}")
    return path, float(took.read_text())


def name_of(hour):
    """The name in luxpipe of an hour of sun-up-hours.txt, .5 on 1 January."""
    day, month = int(hour // 24), 0
    while day >= DAYS[month]:
        day, month = day - DAYS[month], month + 1
    return f"{month + 1:02}{day + 1:02}_{int(hour % 24):02}{round(hour % 1 * 60):02}"


def by_recipe(name, parameters):
    """Hour -> the sensors' lx."""
    folder = OUT / (name + ("-full" if parameters else ""))
    words = {"radiance_parameters": parameters} if parameters else {}

    def make():
        out, kept = sys.stdout.fileno(), os.dup(sys.stdout.fileno())
        os.dup2(sys.stderr.fileno(), out)  # what the recipe says of its steps
        recipes.recipe(name, RADIANCE, folder, sky=None, wea=str(WEA), **words)
        os.dup2(kept, out)
        return b""
    _, cpu = cached(OUT / f"{folder.name}.txt", make)
    results = folder / name.replace("-", "_") / "results"
    lux = numpy.load(results / "__static_apertures__" / "default" / "total" / "floor.npy")
    hours = map(float, (results / "sun-up-hours.txt").read_text().split())
    return {name_of(hour): lux[:, k] for k, hour in enumerate(hours)}, cpu


def by_luxpipe(name, how, frames, seed=1):
    """Hour -> the sensors' lx and half of their intervals."""
    def make():
        words = ["ptrace", "-w-", "-n", 1, "-wea", WEA, "-points", POINTS, *how, "-frames", frames, "-seed", seed,
                 MODEL]
        frame = subprocess.Popen(list(map(str, words)), stdout=subprocess.PIPE)
        sums = subprocess.Popen(["ptaccum", "-every", "x2"], stdin=frame.stdout, stdout=subprocess.PIPE)
        table = run(["vcmetrics", "-W-", "-each"], stdin=sums.stdout)
        assert frame.wait() == 0 and sums.wait() == 0
        return table
    path, cpu = cached(OUT / f"{name}.tsv", make)
    found = {}
    for row in csv.DictReader(open(path), delimiter="\t"):
        found.setdefault(row["sky"], []).append([float(row["E"]), (float(row["hi"]) - float(row["lo"])) / 2])
    return {hour: numpy.array(lux).T for hour, lux in found.items()}, cpu


def by_rtrace(hour):
    """The sensors' lx, without ambient cache."""
    month, day, at = int(hour[:2]), int(hour[2:4]), int(hour[5:7]) + int(hour[7:]) / 60
    lines = [line.split() for line in WEA.read_text().splitlines()]
    where = {words[0]: words[1] for words in lines[:6]}
    direct, diffuse = next(w[3:] for w in lines[6:] if (int(w[0]), int(w[1]), float(w[2])) == (month, day, at))
    sky = run([RADIANCE / "bin" / "gendaylit", month, day, at, "-y", 2022, "-a", where["latitude"], "-o",
               where["longitude"], "-m", where["time_zone"], "-W", direct, diffuse])
    for side, up in (("sky", 1), ("ground", -1)):
        sky += (f"\nskyfunc glow {side}_glow 0 0 4 1 1 1 0\n{side}_glow source {side} 0 0 4 0 0 {up} 180\n").encode()
    parts = sorted(p for p in MODEL.rglob("*") if p.suffix in (".mat", ".rad"))

    def make():
        words = [RADIANCE / "bin" / "oconv", *parts, "-"]
        (OUT / f"{hour}.oct").write_bytes(run(words, input=sky))
        return run([RADIANCE / "bin" / "rtrace", "-h", "-I", "-ab", 7, "-ad", 30000, "-aa", 0, "-as", 0, "-lw", 2e-6,
                    "-dt", 0, "-dc", 1, OUT / f"{hour}.oct"], stdin=open(POINTS))
    path, cpu = cached(OUT / f"{hour}.rtrace", make)
    return numpy.array([179 * (.265 * r + .670 * g + .065 * b) for r, g, b in
                        (map(float, line.split()) for line in path.read_text().splitlines())]), cpu


def say(name, cpu, found, exact):
    off = numpy.concatenate([found[hour] / exact[hour] - 1 for hour in exact if hour in found])
    wrong = numpy.concatenate([(found[hour] >= 300) != (exact[hour] >= 300) for hour in exact if hour in found])
    print(name, f"{cpu:.1f}", len(off), *(f"{100 * x:.1f}" for x in (
        abs(off).mean(), off.mean(), numpy.quantile(abs(off), .95), wrong.mean())), sep="\t", flush=True)


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    (OUT / "site.epw").write_bytes(run([sys.executable, STUDY / "weather.py"]))
    run([RADIANCE / "bin" / "epw2wea", OUT / "site.epw", WEA])
    years = [(" ".join(filter(None, how)), *by_recipe(*how)) for how in RECIPES]
    print("by", "s of a core", "values", "mean %", "bias %", "95 % within", "wrong at 300 lx, %", sep="\t")
    hours = sorted(years[0][1])
    hours = [hours[int((k + .5) * len(hours) / HOURS)] for k in range(HOURS)]
    exact, cpu = by_luxpipe("exact", ["-hours", " ".join(hours), "-hours-apart"], FRAMES, 99)
    exact = {hour: found for hour, found in exact.items() if found[0].all()}  # without dark ones
    half = numpy.concatenate([half / lux for lux, half in exact.values()])
    exact = {hour: lux for hour, (lux, _) in exact.items()}
    print(f"truth: +- {100 * half.mean():.2f} % at a sensor, {cpu:.0f} s")
    for frames in (9, 17, 33):
        found, cpu = by_luxpipe(f"year.{frames}", [], frames)
        years.append((f"luxpipe, {frames} frames", {hour: lux for hour, (lux, _) in found.items()}, cpu))
    for name, found, cpu in years:
        say(name, cpu, found, exact)
    by = {hour: by_rtrace(hour) for hour in list(exact)[1::max(1, len(exact) // RTRACE)][:RTRACE]}
    say("rtrace, some hours", sum(cpu for _, cpu in by.values()), {h: lux for h, (lux, _) in by.items()}, exact)


if __name__ == "__main__":
    main()
