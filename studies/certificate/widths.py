#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""widths.py -bin FOLDER > studies/certificate/widths.tsv: the standard errors that intervals state beside the spread
of their values over seeds.  Frames come in steps of a sixteenth, or in whole blocks of 64, each of which is a scramble
of its own (lib/kernels/sampling/sampler.h).  held: how many intervals hold the mean of all seeds."""

import argparse
import math
import os
import statistics
import sys
import tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "studies", "cie171"))
from facts import facts  # noqa: E402
from run import CASES, fisheye_view, numbers, shell, write, write_skies  # noqa: E402

NUMBERS, POINTS, SKY = ("5.9, 1x1", "5.10, 1x1", "5.11, 2x1"), "AGN", 5
WAYS = {"sixteenths of a doubling (-every x2/16)": "x2/16", "blocks of 64 frames (-every 64)": "64"}


def measured(o, folder, view, seed):
    """Value and standard error, by way."""
    shell(o.bin, folder, "ptrace -w- %s -x %d -y %d -moments- -frames %d -seed %d s%d.rad scene.rad > frames"
          % (view, o.size, o.size, o.frames + 1, seed, SKY))
    found = {}
    for way, every in WAYS.items():
        rows = shell(o.bin, folder, "ptaccum -every %s frames | vcmetrics -metrics Ev -ci 95 -last" % every)
        head, *_, last = [line.split("\t") for line in rows.decode().splitlines()]
        row = dict(zip(head, last))
        low, high = float(row["Ev.lo"]), float(row["Ev.hi"])
        found[way] = float(row["Ev"]), low, high
    return found


def main():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("-bin", default="build/bin")
    for name, default in (("size", 16), ("frames", 1024), ("seeds", 20)):
        p.add_argument("-" + name, default=default, type=int)
    o = p.parse_args()
    facts("python3 studies/certificate/widths.py", frames=o.frames, seeds=o.seeds,
          what="Ev at A, G and N of %s under sky %d, %d x %d pixels" % (" and ".join(NUMBERS), SKY, o.size, o.size))
    print("case\tpoint\tway\tspread\tstated\theld\ttries")
    for case in (c for c in CASES if c.number in NUMBERS):
        with tempfile.TemporaryDirectory() as folder:
            write(folder, "scene.rad", case.scene)
            write_skies(folder, [SKY])
            for point in POINTS:
                view = fisheye_view(*case.sensors[point])
                seen = [measured(o, folder, view + " " + case.options, seed) for seed in range(1, o.seeds + 1)]
                for way in WAYS:
                    values = [s[way][0] for s in seen]
                    mean = statistics.fmean(values)
                    held = sum(s[way][1] <= mean <= s[way][2] for s in seen)
                    stated = math.sqrt(statistics.fmean(((s[way][2] - s[way][1]) / 3.92) ** 2 for s in seen))
                    print("%s\t%s\t%s\t%.4g\t%.4g\t%d\t%d" % (case.number, point, way, statistics.stdev(values) / mean,
                                                         stated / mean, held, o.seeds), flush=True)


if __name__ == "__main__":
    main()
