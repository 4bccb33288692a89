#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""compare.py [options]: random scenes by ptrace and by rtrace; what differs beyond its noise is shrunk and written.

Needs rtrace, oconv and obj2mesh on PATH.  `make compare-radiance N=1000` runs it; --help lists the options.  A scene
depends on its seed alone.  Each that differs gets a folder: the scene, its minimal form and a row for
golden/vectors/found.tsv.
Status 0: no unknown difference; 1: some (or a program refused what the other took); 77: RADIANCE is not here.
"""
import argparse
import multiprocessing
import os
import shutil
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import tracers  # noqa: E402
from generate import generate  # noqa: E402
from judge import judge, typical  # noqa: E402
from known import explanation  # noqa: E402
from shrink import Shrinker  # noqa: E402

VECTORS = os.path.join(HERE, "..", "..", "golden", "vectors")
FROM_VECTORS = ["tiny.fnt", "tri2.fnt", "small.hdr", "klemsq.xml", "peak.xml", "tt3.xml", "tt4.xml", "quad.rtm"]
NEEDED = ["rtrace", "oconv", "obj2mesh"]
# of results.tsv, a line as soon as a scene is done
COLUMNS = ["seed", "status", "pixels", "differ", "edges", "rare", "noisy"]


def wave_obj(normals):
    """A rug of 5 x 5 corners, with coordinates."""
    lines = ["usemtl void"]
    for j in range(5):
        for i in range(5):
            x, y = i / 2 - 1, j / 2 - 1
            lines += [f"v {x} {y} {.2 * x * x - .1 * y}", f"vt {i / 4} {j / 4}"]
            lines += [f"vn {-.4 * x} .1 1"] if normals else []
    for j in range(4):
        for i in range(4):
            a = 5 * j + i + 1
            lines.append("f " + " ".join(f"{k}/{k}/{k if normals else ''}" for k in (a, a + 1, a + 6, a + 5)))
    return "\n".join(lines) + "\n"


class Bed:
    """The files that random scenes read; a call puts them into a folder."""

    def __init__(self, folder, tracer):
        self.folder = folder
        sources = [os.path.join(HERE, "parts", f) for f in os.listdir(os.path.join(HERE, "parts"))]
        for path in sources + [os.path.join(VECTORS, f) for f in FROM_VECTORS]:
            shutil.copy(path, folder)
        for name, normals in (("wave", True), ("flat", False)):
            with open(os.path.join(folder, name + ".obj"), "w") as out:
                out.write(wave_obj(normals))
            subprocess.run(["obj2mesh", name + ".obj", name + ".rtm"], cwd=folder, check=True,
                           stderr=subprocess.DEVNULL)
        self.tracer = os.path.join(folder, "trace_rays")  # a copy: a build may run meanwhile
        shutil.copy(tracer, self.tracer)

    def __call__(self, folder):
        for name in os.listdir(self.folder):
            os.symlink(os.path.join(self.folder, name), os.path.join(folder, name))


def compare_scene(job):
    """One seed: a dictionary that the main process reports."""
    seed, args, bed = job
    scene = generate(seed, args.rays, args.coincident, args.resting, args.scale == 1)  # xform keeps extinctions
    result = {"seed": seed, "pixels": 0, "differ": 0, "edges": 0, "rare": 0, "noisy": 0, "status": "agrees", "why": ""}
    with tempfile.TemporaryDirectory() as folder:
        bed(folder)
        fault = scene.write(folder)
        if fault:
            return dict(result, status="not made", why=fault)
        try:
            pixels, wrong = judge(scene, folder, args.tracer, args.ours)
        except tracers.Refused as refused:
            return refusal(result, refused, scene, folder, args)
    result.update(pixels=len(pixels), differ=len(wrong), edges=sum(p.edge for p in pixels),
                  rare=sum(p.rare for p in pixels), noisy=sum(p.noise() > .1 for p in pixels))
    if wrong:
        result["status"] = "differs"
        worst = max(wrong, key=lambda p: p.deviation())
        record(seed, scene, worst, typical(pixels), args, bed, result)
    return result


def refusal(result, refused, scene, folder, args):
    """Fine if both refuse; a difference if one does."""
    other = "ptrace" if refused.who == "rtrace" else "rtrace"
    try:
        if other == "ptrace":
            tracers.ptrace(args.tracer, folder, scene.arguments(), scene.rays[:1], 1, 1)
        else:
            tracers.rtrace(folder, scene.arguments(), scene.rays, 1)
    except tracers.Refused:
        return dict(result, status="both refuse", why=str(refused))
    keep_scene(os.path.join(args.out, f"refused_{result['seed']}"), scene)
    return dict(result, status="refused", why=str(refused))


def keep_scene(folder, scene):
    os.makedirs(folder, exist_ok=True)
    scene.write(folder)


def record(seed, scene, worst, floor, args, bed, result):
    """Shrinks and writes scene and row; sets what explains it."""
    folder = os.path.join(args.out, str(seed))
    keep_scene(folder, scene)
    shrinker = Shrinker(scene, worst.ray, floor, bed, args.tracer, args.ours, args.budget)
    small = shrinker.run()
    ours, theirs = worst.ours, worst.theirs
    if small is None:
        small = scene.copy()
        small.rays = [worst.ray]
    else:
        with tempfile.TemporaryDirectory() as work:
            bed(work)
            small.write(work)
            pixels, wrong = judge(small, work, args.tracer, args.ours, 2, 3, floor)
            ours, theirs = pixels[0].ours, pixels[0].theirs
    minimal = os.path.join(folder, "minimal")
    keep_scene(minimal, small)
    numbers = [" ".join(f"{v:.6g}" for v in values) for values in (theirs[0], theirs[1], ours[0], ours[1])]
    kind = "rtrace-mean(128)" if any(theirs[1]) else "rtrace"
    note = f"seed {seed}" + (f"; standard error {numbers[1]}" if any(theirs[1]) else "")
    row = [f"cmp_{seed}", kind, f"cmp_{seed}.rad", tracers.EXACT + " " + small.arguments(),
           tracers.ray_text(small.rays[0]), numbers[0], note]
    with open(os.path.join(minimal, "row.tsv"), "w") as out:
        out.write("\t".join(row) + "\n")
    result.update(known=explanation(small, shrinker.differs), kinds=" ".join(small.kinds()),
                  why=f"rtrace {numbers[0]} (+- {numbers[1]}) ptrace {numbers[2]} (+- {numbers[3]}), minimal: "
                      f"{' '.join(small.kinds())}, {len(small.primitives())} primitives")
    if result["known"]:
        result["status"] = "known"


def report(results, args, seconds):
    count = {}
    for r in results:
        count[r["status"]] = count.get(r["status"], 0) + 1
    pixels = sum(r["pixels"] for r in results)
    unknown = sum(r["differ"] for r in results if r["status"] == "differs")
    known = sum(r["differ"] for r in results if r["status"] == "known")
    lines = [f"{len(results)} scenes, seeds {args.seed} to {args.seed + args.n - 1}, {args.rays} rays each: "
             + ", ".join(f"{n} {status}" for status, n in sorted(count.items()))]
    if pixels:
        lines.append(f"{pixels} pixels: {100 * (pixels - unknown - known) / pixels:.3f} % agree within noise "
                     f"({sum(r['edges'] for r in results)} on edges, {sum(r['rare'] for r in results)} by rare ways, "
                     f"{sum(r['noisy'] for r in results)} noisy), "
                     f"{known} differ as docs/differences.md says, {unknown} differ")
    lines.append(f"{seconds:.0f} s")
    return lines


def parse_arguments():
    parser = argparse.ArgumentParser(description="random scenes by ptrace and rtrace")
    parser.add_argument("-n", type=int, default=100, help="scenes")
    parser.add_argument("--seed", type=int, default=1, help="of the first scene; the others follow")
    parser.add_argument("--rays", type=int, default=400, help="rays a scene")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--budget", type=int, default=250, help="trials to shrink a difference")
    parser.add_argument("--tracer", default="build/bin/trace_rays")
    parser.add_argument("--ours", default="", help="options for ptrace only (to see that a difference is found)")
    parser.add_argument("--coincident", action="store_true", help="surfaces in one place with others")
    parser.add_argument("--resting", action="store_true", help="eyes on surfaces")
    parser.add_argument("--scale", type=float, default=1, help="of ptrace's model, which rtrace sees at 1")
    parser.add_argument("--move", type=float, nargs=3, default=(0, 0, 0), help="of ptrace's model, likewise")
    parser.add_argument("--stray", action="store_true", help="a small polygon at the origin of ptrace's model")
    parser.add_argument("--out", default="out/compare-radiance")
    args = parser.parse_args()
    tracers.scale, tracers.move, tracers.stray = args.scale, args.move, args.stray
    args.tracer, args.out = os.path.abspath(args.tracer), os.path.abspath(args.out)
    return args


def main():
    args = parse_arguments()
    missing = [p for p in NEEDED if not shutil.which(p)]
    if missing:
        print("skipped: no " + ", ".join(missing) + " here (RADIANCE)")
        return 77
    if not os.access(args.tracer, os.X_OK):
        sys.exit(f"compare.py: {args.tracer}: no such program")
    start, results = time.time(), []
    os.makedirs(args.out, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        bed = Bed(folder, args.tracer)
        args.tracer = bed.tracer
        jobs = [(seed, args, bed) for seed in range(args.seed, args.seed + args.n)]
        with multiprocessing.Pool(args.jobs) as pool, open(os.path.join(args.out, "results.tsv"), "w") as table:
            table.write("# " + "\t".join(COLUMNS) + "\n")
            for r in pool.imap_unordered(compare_scene, jobs):
                results.append(r)
                table.write("\t".join(str(r[k]) for k in COLUMNS) + "\n")
                table.flush()
                if r["status"] not in ("agrees", "both refuse"):
                    name = r["status"] + (f" ({r['known']})" if r.get("known") else "")
                    print(f"seed {r['seed']}: {name}, {r['differ']} of {r['pixels']} pixels; {r['why']}", flush=True)
    lines = report(results, args, time.time() - start)
    print("\n".join(lines))
    return 1 if any(r["status"] in ("differs", "refused", "not made") for r in results) else 0


if __name__ == "__main__":
    sys.exit(main())
