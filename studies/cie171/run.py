#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""run.py: luxpipe's value with its 95 % interval beside each derived value, and a verdict, as a table.

-only 5.9 '5.8, sphere', -not 5.4: cases whose name begins so; -points AGN, -skies 1 5: only these; -size, -frames,
-seed: the pictures; -stop ends with the first value that is wrong.
"""

import argparse
import math
import os
import struct
import subprocess
import sys
import tempfile
import time

from facts import facts
from variants import CASES, pi

T95 = {7: 2.365, 15: 2.131}  # Student's t, two-sided, by degrees of freedom
REFERENCE_ERROR = 1e-4


def write(folder, name, text):
    with open(os.path.join(folder, name), "w") as f:
        f.write(text)


def shell(bin_folder, folder, command):
    env = dict(os.environ, PATH=os.path.abspath(bin_folder) + ":" + os.environ["PATH"])
    done = subprocess.run(
        ["bash", "-c", "set -o pipefail; " + command],
        cwd=folder,
        env=env,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    if done.returncode:
        sys.exit("run.py: %s: %s" % (command, done.stderr.decode(errors="replace").strip()))
    return done.stdout


def numbers(v):
    return " ".join("%.9g" % c for c in v)


def up_for(normal):
    return (0, 0, 1) if normal[2] == 0 else (0, 1, 0)


def write_skies(folder, skies):
    for sky in skies:
        write(
            folder,
            "s%s.rad" % sky,
            "!genciesky %s -ang 60 0 -B 1\nskyfunc glow sky_glow 0 0 4 1 1 1 0\n"
            "sky_glow source sky 0 0 4 0 0 1 180\n" % sky,
        )


def fisheye_view(p, n):
    # ten micrometres off the wall: closer than a micrometre a ray at the rim of the picture would not meet it
    eye = [a + 1e-5 * b for a, b in zip(p, n)]
    return "-vta -vh 180 -vv 180 -vp %s -vd %s -vu %s" % (numbers(eye), numbers(n), numbers(up_for(n)))


def fisheyes(o, case, sensors, skies, folder):
    """Ev with -ci of each view and sky: (point, sky) -> value, low, high."""
    views = ["rvu " + fisheye_view(p, n) for p, n in sensors.values()]
    write(folder, "all.vf", "\n".join(views) + "\n")
    which = " ".join("-sky s%s.rad" % sky for sky in skies) if case.skies else ""
    out = shell(
        o.bin,
        folder,
        "ptrace -x %d -y %d -moments- %s -frames %d -seed %d -views all.vf %s scene.rad | ptaccum | "
        "vcmetrics -metrics Ev -ci 95" % (o.size, o.size, case.options, o.frames, o.seed, which),
    ).decode()
    lines = out.splitlines()
    head, found = lines[0].split("\t"), {}
    names = list(sensors)
    for text in lines[1:]:
        row = dict(zip(head, text.split("\t")))
        sky = row.get("sky", "s" + (str(skies[0]) if case.skies else "-"))[1:]
        found[names[int(row.get("view", 1)) - 1], sky] = [float(row[k]) * case.unit for k in ("Ev", "Ev.lo", "Ev.hi")]
    return found


def pixels(o, folder, view, seed, options):
    """Means of the three channels, pixel by pixel."""
    data = shell(
        o.bin,
        folder,
        "ptrace %s -moments- %s -frames %d -seed %d scene.rad | ptaccum -last -ff" % (view, options, o.frames, seed),
    )
    start = data.index(b"\n", data.index(b"\n\n") + 2) + 1
    values = struct.unpack("<%df" % ((len(data) - start) // 4), data[start:])
    return [sum(values[k : k + 3]) / 3 for k in range(0, len(values), 3)]


def interval(values):
    n = len(values)
    mean = math.fsum(values) / n
    error = math.sqrt(math.fsum((v - mean) ** 2 for v in values) / (n - 1) / n)
    return [mean, mean - T95[n - 1] * error, mean + T95[n - 1] * error]


def plates(o, case, sensors, _skies, folder):
    found = {}
    for name, (p, n) in sensors.items():
        eye = [a + 0.5 * b for a, b in zip(p, n)]
        view = "-vtv -vh .01 -vv .01 -x 4 -y 4 -vp %s -vd %s -vu %s" % (
            numbers(eye),
            numbers([-c for c in n]),
            numbers(up_for(n)),
        )
        factor = 179 * pi / 0.5 * case.unit
        found[name, "-"] = interval([v * factor for v in pixels(o, folder, view, o.seed, case.options)])
    return found


def faces(o, case, sensors, _skies, folder):
    size = max(16, o.size // 4)
    sums = []
    for k in range(8):
        total = 0.0
        for view, area in case.views:
            one = pixels(o, folder, "%s -x %d -y %d -pa 0" % (view, size, size), o.seed + k, case.options)
            total += math.fsum(one) / len(one) * area
        sums.append(179 * pi * case.unit * total)
    return {(name, "-"): interval(sums) for name in sensors}


def sensors_of_grid(o, case, sensors, skies, folder):
    """E and its interval of each point, frames in proportion to what a picture's cost."""
    write(folder, "p.pts", "".join("%s %s\n" % (numbers(p), numbers(n)) for p, n in sensors.values()))
    found = {}
    for sky in skies:
        out = shell(
            o.bin,
            folder,
            "ptrace -points p.pts %s -frames %d -seed %d scene.rad %s 2> /dev/null | ptaccum | "
            "vcmetrics -each -ci 95 -points p.pts"
            % (case.options, 4 * o.frames - 3, o.seed, "s%s.rad" % sky if case.skies else ""),
        ).decode()
        lines = [text.split("\t") for text in out.splitlines()]
        for name, row in zip(sensors, lines[1:]):
            found[name, str(sky)] = [float(dict(zip(lines[0], row))[k]) * case.unit for k in ("E", "lo", "hi")]
    return found


WAYS = {"fisheye": fisheyes, "plate": plates, "faces": faces, "sensors": sensors_of_grid}


def run(o, case):
    """Rows of one case: point, sky, derived, value, low, high, standard errors away, verdict."""
    sensors = {n: s for n, s in case.sensors.items() if not o.points or n[0] in o.points or len(n) > 2}
    skies = [k for k in range(1, 17) if not o.skies or k in o.skies] if case.skies else ["-"]
    if not sensors:
        return
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {"scene.rad": case.scene, **case.files}.items():
            write(folder, name, text)
        if case.skies:
            write_skies(folder, skies)
        found = WAYS[case.by](o, case, sensors, skies, folder)
    for name, (point, normal) in sensors.items():
        derived = case.reference(point, normal, o.cells)
        for sky in skies:
            true = derived[sky - 1] if case.skies else derived[0]
            value, low, high = found[name, str(sky)]
            slack = REFERENCE_ERROR * abs(true)
            beyond = max(0.0, low - slack - true, true - high - slack)
            off = max(0.0, abs(value - true) - slack)
            z = off / ((high - low) / 3.92) if high > low else (0 if off == 0 else math.inf)
            yield name, sky, true, value, low, high, z, "inside" if beyond == 0 else "wrong" if z > 5 else "outside"


def options():
    p = argparse.ArgumentParser(description=__doc__)
    for name, default, kind in (
        ("bin", "build/bin", str),
        ("points", "", str),
        ("size", 128, int),
        ("frames", 17, int),
        ("seed", 1, int),
        ("cells", 4.0, float),
    ):
        p.add_argument("-" + name, default=default, type=kind)
    p.add_argument("-only", nargs="+", default=[""])
    p.add_argument("-not", nargs="+", default=[], dest="without")
    p.add_argument("-skies", nargs="+", default=[], type=int)
    p.add_argument("-stop", action="store_true")
    return p.parse_args()


def main():
    o = options()
    facts(
        "python3 studies/cie171/run.py "
        + " ".join(
            "'%s'" % a if " " in a else a
            for k, a in enumerate(sys.argv[1:], 1)
            if a != "-bin" and sys.argv[k - 1] != "-bin"
        )
    )
    print("case\tpoint\tsky\tderived\tvalue\tlow\thigh\terrors\tverdict\tseconds", flush=True)
    wrong = 0
    for case in CASES:
        if not case.number.startswith(tuple(o.only)) or case.number.startswith(tuple(o.without)):
            continue
        start = time.time()
        rows = list(run(o, case))
        seconds = time.time() - start
        for name, sky, true, value, low, high, z, verdict in rows:
            wrong += verdict == "wrong"
            print(
                "%s\t%s\t%s\t%.6g\t%.6g\t%.6g\t%.6g\t%.2f\t%s\t%.1f"
                % (case.number, name, sky, true, value, low, high, z, verdict, seconds),
                flush=True,
            )
            if wrong and o.stop:
                sys.exit(1)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
