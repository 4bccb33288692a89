#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""measure.py -bin FOLDER: the second half of the certificate: other programs, intervals, devices.  Runs each command
and writes studies/certificate/measured.tsv: what was tried how often, how often it held, seconds, date, commit.
A row that cannot be measured here (no RADIANCE on PATH) stays as it was; so does one that was measured since lib
changed last, unless -all is given."""

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "studies", "cie171"))
from compare import table  # noqa: E402
from facts import machine  # noqa: E402

TABLE = os.path.join(TOP, "studies", "certificate", "measured.tsv")
COLUMNS = ["what", "of", "tries", "held", "least", "seconds", "date", "commit", "machine", "command"]
COVERAGE = (
    "python3 -B studies/coverage/coverage.py -bin $BIN -out $OUT/rooms -scenes 2000-2002 -seeds 16 -size 32 -frames 25 "
    "-truth tests/golden/coverage.tsv -do trace,measure,judge"
)
SENSORS = "python3 -B studies/coverage/sensors.py -bin $BIN -out $OUT/sensors -scenes 2000 -seeds 16 -points 60 -jobs 2"
RTRACE = "python3 tests/compare/radiance/compare.py -n 60 --seed 5001 --tracer $BIN/trace_rays --out $OUT/rtrace"
SEEDS = (
    "for s in $(seq 25); do python3 -B studies/cie171/run.py -bin $BIN -only '5.9, 1x1' '5.10, 1x1' '5.11, 2x1' "
    "-not '5.10, 1x1, s' -points AGN -skies 5 -size 64 -cells 2 -frames 17 -seed $s; done"
)
YEARS = (
    "PATH=$BIN:$PATH YEAR='Mo 8-18 1/2' POOL=40 SEEDS=4 YEARS=200 python3 -B studies/year/years.py $OUT/years office"
)
SENSOR_SEEDS = (
    "for s in $(seq 14); do python3 -B studies/cie171/run.py -bin $BIN -only '5.10, 1x1, s' '5.12, 2x1, s' "
    "'5.13, 1 m, s' -skies 5 -cells 2 -frames 17 -seed $s; done"
)
SIXTEEN = r"(?m)^%s(?:\t[^\t]*){6}\t(?P<percent>[\d.]+) "  # percent at the look of 17 frames

# what, counted in, least percent that holds, command, words of its output: of tries, held or missed; percent, of which
# a number of tries is given
PARTS = [
    (
        "pictures of 64 x 64 pixels of a scene for each feature, against rtrace: blocks within noise",
        "views",
        100,
        "TOP=$PWD BIN=$BIN bash tests/tools/suite.sh",
        r"(?m)^(?P<held>ok)|^(?P<missed>not ok)",
        0,
    ),
    (
        "random scenes against rtrace, 400 rays each: equal, or different as docs/differences.md says (scenes that "
        "rtrace does not end in 860 s count as missed)",
        "scenes",
        100,
        RTRACE,
        r"(?m)^(?P<tries>\d+) scenes, .*?: (?:.*?, )?(?P<held>\d+) agrees(?:.*?, (?P<known>\d+) known)?",
        0,
    ),
    (
        "their pixels, within noise or as docs/differences.md says",
        "pixels",
        100,
        RTRACE,
        r"(?m)^(?P<tries>\d+) pixels: .*, (?P<missed>\d+) differ$",
        0,
    ),
    (
        "rows of random pictures against evalglare 3.06: every word equal, to two units of its last digit or 1e-6",
        "rows",
        99.5,
        "python3 tests/compare/evalglare/compare.py -n 300 --seed 5001 --vcmetrics $BIN/vcmetrics --out $OUT/evalglare",
        r"(?m): (?P<held>\d+) equal, [\d.]+ % of (?P<tries>\d+);",
        0,
    ),
    *(
        (
            "95 %% intervals of %s: three rooms that nobody designed, 16 seeds, 17 frames" % metric,
            "tries",
            88,
            COVERAGE,
            SIXTEEN % re.escape(metric),
            48,
        )
        for metric in ("Ev", "Lavg", "DGP", "desk.TAL", "pair.CR")
    ),
    (
        "95 % intervals of CIE 171's values: A, G, N of 5.9 to 5.11 under sky 5, 25 seeds, 17 frames of 64 x 64",
        "tries",
        93,
        SEEDS,
        r"(?m)\t(?P<held>inside)\t|\t(?P<missed>outside|wrong)\t",
        0,
    ),
    (
        "the same by sensors: all points of 5.10, 5.12 and 5.13 under sky 5, 14 seeds, 65 frames",
        "tries",
        93,
        SENSOR_SEEDS,
        r"(?m)\t(?P<held>inside)\t|\t(?P<missed>outside|wrong)\t",
        0,
    ),
    (
        "95 % intervals of sensors: 60 points of a room, 16 seeds, 64 frames",
        "tries",
        93,
        SENSORS,
        r"(?m)^point(?:\t[^\t]*){2}\t(?P<percent>[\d.]+) ",
        960,
    ),
    (
        "95 % intervals of a year of 200 hours at 64 x 64, 40 of them near a limit: counts above three limits, DGPe5",
        "tries",
        93,
        YEARS,
        r"(?m)^intervals: (?P<tries>\d+) tries, (?P<held>\d+) inside",
        0,
    ),
    (
        "classes of these years: said, and right (the others are said to be undecided, or wrong: the next row)",
        "years",
        0,
        YEARS,
        r"(?m)^class: (?P<tries>\d+) tries, (?P<held>\d+) right",
        0,
    ),
    (
        "classes of these years: not wrong",
        "years",
        95,
        YEARS,
        r"(?m)^class: (?P<tries>\d+) tries, .* (?P<missed>\d+) wrong$",
        0,
    ),
    *(
        (
            "frames and rays with the bits of tests/golden/bits.tsv: %s" % words,
            "rows",
            100,
            "$BIN/bits_test %s" % device,
            r"(?m)^(?P<tries>\d+) rows on .*, (?P<missed>\d+) moved",
            0,
        )
        for words, device in (
            ("the processor, a path at a time", "cpu"),
            ("its lanes, 16 paths at a time", "cpu:lanes16"),
            ("OpenCL on it (PoCL)", "opencl"),
        )
    ),
]


def git(*words):
    return subprocess.run(["git", "-C", TOP, *words], stdout=subprocess.PIPE).stdout.decode().strip()


def is_new(row):
    quiet = ["git", "-C", TOP, "diff", "--quiet", row["commit"], "--", "lib"]
    return subprocess.run(quiet, stderr=subprocess.DEVNULL).returncode == 0


def counts(text, pattern, tries):
    """Tries and how many held; None where the output has no such words."""
    found = [m.groupdict() for m in re.finditer(pattern, text)]
    if not found:
        return None
    if tries:
        return tries, round(float(found[0]["percent"]) * tries / 100)
    if "tries" in found[0]:
        all_of = int(found[0]["tries"])
        known = int(found[0].get("known") or 0)
        return all_of, int(found[0]["held"]) + known if "held" in found[0] else all_of - int(found[0]["missed"])
    return len(found), sum(bool(m["held"]) for m in found)


def main():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("-bin", default="build/bin")
    p.add_argument("-all", action="store_true")
    o = p.parse_args()
    old = {r["what"]: r for r in table(TABLE)[1]} if os.path.exists(TABLE) else {}
    rows, output = [], {}
    with tempfile.TemporaryDirectory() as folder:
        env = dict(os.environ, BIN=os.path.abspath(o.bin), OUT=folder)
        for what, of, least, command, pattern, tries in PARTS:
            row = old.get(what)
            if not (row and is_new(row) and not o.all):
                if command not in output:
                    start = time.time()
                    done = subprocess.run(["bash", "-c", command], cwd=TOP, env=env, stdout=subprocess.PIPE,
                                          stderr=subprocess.STDOUT)
                    output[command] = done.stdout.decode(errors="replace"), time.time() - start
                text, seconds = output[command]
                found = counts(text, pattern, tries)
                if found:
                    today = time.strftime("%Y-%m-%d", time.gmtime())
                    commit = git("log", "-1", "--format=%h", "--", "lib")
                    values = [what, of, *found, "%g" % least, "%.0f" % seconds, today, commit, machine(), command]
                    row = dict(zip(COLUMNS, map(str, values)))
                else:
                    print("measure.py: not measured here: %s: %s" % (what, text.strip()[-200:]), file=sys.stderr)
            if row:
                rows.append(row)
    with open(TABLE, "w") as f:
        f.write("\t".join(COLUMNS) + "\n" + "".join("\t".join(r[c] for c in COLUMNS) + "\n" for r in rows))


if __name__ == "__main__":
    main()
