# SPDX-License-Identifier: BSD-3-Clause
"""python.py BIN [PAIRS [SIZE [FRAMES]]]: what luxpipe.render() costs beside the pipe that it runs.

The office by the shell's pipe and by luxpipe.render(), in turns (5 pairs, 512 x 512, 64 frames); for each pair the
ratio of processor times (user and system, of all programs) and of wall times, then the medians.  The pictures are the
same, which the last lines of the metrics show.  Runs with the package of this source tree.
"""

import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

TOP = Path(__file__).resolve().parents[1]
BIN = Path(sys.argv[1]).resolve()
PAIRS, SIZE, FRAMES = (int(word) for word in (sys.argv[2:] + ["5", "512", "65"][len(sys.argv) - 2:]))
SCENE = [str(TOP / "examples" / "scenes" / "office" / name)
         for name in ("view.vf", "materials.rad", "layout.rad", "sky_1400.rad")]

PIPE = f"""ptrace -vf "$1" -x {SIZE} -y {SIZE} -seed 1 -frames {FRAMES} "$2" "$3" "$4" | ptaccum -every x2/16 |
    vcmetrics -format jsonl -ci 95 -metrics Ev,DGP,DGPf -max-frames {FRAMES} | tail -n 1 | cut -d , -f 3"""
PYTHON = f"""
import sys, luxpipe
result = luxpipe.render(sys.argv[2:], sys.argv[1], None, size={SIZE}, max_frames={FRAMES})
print('"Ev":' + str(result["Ev"].value))
"""


def run(words):
    """Return processor seconds, wall seconds and output of a command and all that it starts."""
    environment = {**os.environ, "PATH": f"{BIN}:{os.environ['PATH']}", "LUXPIPE_BIN": str(BIN),
                   "PYTHONPATH": str(TOP / "python")}
    start = time.monotonic()
    process = subprocess.Popen([*words, *SCENE], env=environment, stdout=subprocess.PIPE, text=True)
    said = process.stdout.read().strip()
    _, status, used = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"bench/python.py: {words[0]} failed")
    return used.ru_utime + used.ru_stime, time.monotonic() - start, said


def main():
    print("pair\tpipe_cpu\tpython_cpu\tcpu_ratio\tpipe_wall\tpython_wall\twall_ratio", flush=True)
    ratios = []
    for pair in range(PAIRS):
        runs = {"pipe": ["bash", "-c", PIPE, "pipe"], "python": [sys.executable, "-c", PYTHON]}
        order = ["pipe", "python"] if pair % 2 == 0 else ["python", "pipe"]
        took = {name: run(runs[name]) for name in order}
        pipe, python = took["pipe"], took["python"]
        ratios.append([python[0] / pipe[0], python[1] / pipe[1]])
        print(pair, *(f"{x:.2f}" for x in (pipe[0], python[0])), f"{ratios[-1][0]:.4f}",
              *(f"{x:.2f}" for x in (pipe[1], python[1])), f"{ratios[-1][1]:.4f}", sep="\t", flush=True)
    print("median\t\t\t{:.4f}\t\t\t{:.4f}".format(*map(statistics.median, zip(*ratios))))
    print(f"the pipe says {pipe[2]}, luxpipe.render {python[2]}", file=sys.stderr)


main()
