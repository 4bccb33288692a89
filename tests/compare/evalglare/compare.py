#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""compare.py [options]: random pictures and option sets by evalglare and by `vcmetrics -like evalglare`.

Needs evalglare on PATH.  `make compare-evalglare N=1000` runs it; --help lists the options.  A row, which is all that
one run prints, is equal if every word is, numbers to two units of their last digit or a millionth.  Each row that
differs is shrunk (options taken out, pixels made plain) and written to a folder: the picture and the two commands.
A row that evalglare does not live through (it ends by a signal: a memory fault) is counted apart: it has no answer to
compare with.  Status 0: at least --share of the rows with an answer are equal; 1: fewer; 77: evalglare is not here.
"""
import argparse
import multiprocessing
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

from choices import random_options  # noqa: E402
from pictures import random_picture  # noqa: E402
from shrink import shrink  # noqa: E402

ROWS_A_PICTURE = 4


def words_differ(ours, theirs):
    if ours == theirs:
        return False
    try:
        a, b = float(ours), float(theirs)
    except ValueError:
        return True
    if a != a or b != b:
        return (a != a) != (b != b)
    unit = 10.0 ** -len(theirs.partition(".")[2])
    return not abs(a - b) <= max(2 * unit, 1e-6 * abs(b))


def first_difference(ours, theirs):
    """None, or a line about where two outputs part."""
    a, b = ours.split("\n"), theirs.split("\n")
    if len(a) != len(b):
        return f"{len(a)} lines against {len(b)}"
    for line, (x, y) in enumerate(zip(a, b), 1):
        p, q = x.split(), y.split()
        if len(p) != len(q):
            return f"line {line}: {len(p)} words against {len(q)}"
        for word, (s, t) in enumerate(zip(p, q), 1):
            if words_differ(s, t):
                return f"line {line}, word {word}: {s} against {t}"
    return None


class Runner:
    def __init__(self, vcmetrics, folder):
        self.vcmetrics, self.folder = vcmetrics, folder

    def output(self, command, options, path):
        words = command + [word for option in options for word in option] + [path]
        done = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        return done.stdout.decode("latin1") + f"status {done.returncode}\n", done.returncode < 0

    def compare(self, picture, options):
        """None or what differs, and whether evalglare has answered."""
        path = os.path.join(self.folder, f"picture{os.getpid()}.hdr")
        picture.write(path)
        theirs, ended_by_signal = self.output(["evalglare"], options, path)
        ours, we_too = self.output(self.vcmetrics.split() + ["-like", "evalglare"], options, path)
        if ended_by_signal and not we_too:
            return None, False
        return first_difference(ours, theirs) or ("both end by a signal" if we_too else None), True

    def difference(self, picture, options):
        return self.compare(picture, options)[0]


def one_picture(task):
    """Rows of one picture's seed: (row's seed, options, None or what differs, whether evalglare has answered)."""
    runner, seed, count = task
    picture = random_picture(seed)
    rows = []
    for k in range(count):
        options = random_options(f"{seed} {k}", picture)
        rows.append((seed, options, *runner.compare(picture, options)))
    return rows


def write_case(runner, out, seed, options):
    folder = os.path.join(out, str(seed))
    os.makedirs(folder, exist_ok=True)
    picture, options = shrink(random_picture(seed), options, runner.difference)
    picture.write(os.path.join(folder, "minimal.hdr"))
    typed = " ".join(word for option in options for word in option)
    with open(os.path.join(folder, "commands"), "w") as text:
        text.write(f"evalglare {typed} minimal.hdr\nvcmetrics -like evalglare {typed} minimal.hdr\n")
        text.write(f"# {runner.difference(picture, options)}\n")
        text.write("".join(f"# {line}\n" for line in picture.lines))
        plain = max(set(picture.pixels), key=picture.pixels.count)
        for i, pixel in enumerate(picture.pixels):
            if pixel != plain:
                x, y = i % picture.width, picture.height - 1 - i // picture.width
                text.write(f"# x {x} y {y} (from the bottom): {' '.join(map(str, pixel))}\n")
    return folder, typed, runner.difference(picture, options)


def main():
    parse = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parse.add_argument("-n", type=int, default=100, help="rows (100)")
    parse.add_argument("--seed", type=int, default=1, help="the first picture's (1)")
    parse.add_argument("--vcmetrics", default="vcmetrics", help="the program, and options to go with it")
    parse.add_argument("--jobs", type=int, default=os.cpu_count())
    parse.add_argument("--out", default="out/compare-evalglare", help="folder for rows that differ")
    parse.add_argument("--share", type=float, default=.995, help="of rows that must be equal (.995)")
    parse.add_argument("--shrink", type=int, default=10, help="how many rows that differ are shrunk (10)")
    given = parse.parse_args()
    if not shutil.which("evalglare"):
        print("compare.py: evalglare is not on PATH", file=sys.stderr)
        return 77
    pictures = (given.n + ROWS_A_PICTURE - 1) // ROWS_A_PICTURE
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(given.vcmetrics, folder)
        tasks = [(runner, given.seed + k, min(ROWS_A_PICTURE, given.n - ROWS_A_PICTURE * k)) for k in range(pictures)]
        with multiprocessing.Pool(given.jobs) as pool:
            rows = [row for part in pool.imap(one_picture, tasks) for row in part]
        differ = [row for row in rows if row[2]]
        for number, (seed, options, what, _) in enumerate(differ):
            print(f"picture {seed}: {' '.join(word for option in options for word in option)}: {what}", flush=True)
            if number < given.shrink:
                place, typed, what = write_case(runner, given.out, seed, options)
                print(f"    {place}: {typed}: {what}", flush=True)
    answered = sum(row[3] for row in rows)
    equal = answered - len(differ)
    seeds = f"pictures {given.seed} to {given.seed + pictures - 1}"
    print(f"{len(rows)} rows, {seeds}: {equal} equal, {100 * equal / max(answered, 1):.2f} % of {answered}; "
          f"{len(rows) - answered} without an answer of evalglare's")
    return 0 if equal >= given.share * answered else 1


if __name__ == "__main__":
    sys.exit(main())
