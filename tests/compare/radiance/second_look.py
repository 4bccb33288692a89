# SPDX-License-Identifier: BSD-3-Clause
"""Rays that differ, looked at once more: light by ways hardly ever taken, and edges.

Rare ways: rtrace follows each reflection of a reflection, ptrace one way of several with its share as the chance, so
that it may never see the sun by the fifth reflection in a pane and then knows nothing of its error.  Traced again with
each way as likely as the others, which has the same mean, that light is seen.

Edges: where one of the programs itself changes as much between rays 1e-4 or 1e-5 apart, or rtrace with the scene
rounded to single precision (a frozen octree), an edge is in the way, and which side of it a program finds does not
count as a difference."""
import os
import subprocess

import tracers

SMALL = (1e-4, 1e-5)  # how far neighbours of a ray are; nearer ones where light changes steeply beside the edge
FEW = 10
RARE_SAMPLES = [1 << 17, 1 << 20]
RARE_NOISE = .03       # an estimate with more does not say that both programs agree
RARE_FAR = .3          # further off than this and than its noise: the light is not rare, it is missing
OURS, THEIRS = (65536, 65536), 16
QUICK = (4096, 4096)   # a shrinker's trial: more noise finds an edge sooner, and the trial is in vain


def look_for_rare_ways(pixels, scene, folder, tracer, extra):
    """Takes the estimate with equal chances where it is a good one; a short look tells where more are in vain."""
    arguments = scene.arguments() + " " + extra
    for p in pixels:
        for samples in RARE_SAMPLES:
            try:
                mean, error = tracers.ptrace(tracer, folder, arguments, [p.ray], samples, samples, "1")[0]
            except tracers.Refused:  # it takes too long
                break
            if all(e <= RARE_NOISE * m for m, e in zip(mean, error)):
                p.ours, p.rare = (mean, error), True
                break
            if any(e > 0 and abs(m - v) > RARE_FAR * v + 8 * e for m, e, v in zip(mean, error, p.theirs[0])):
                break


def neighbours(ray):
    for axis in range(3):
        for sign in (-1, 1):
            for far in SMALL:
                other = list(ray)
                other[axis] += sign * far
                yield tuple(other)


def frozen(folder):
    """The scene with its numbers in single precision; False if there is none."""
    with open(os.path.join(folder, "frozen.oct"), "wb") as out:
        made = subprocess.run(["oconv", "-w", "-f", "scene.rad"], cwd=folder, stdout=out, stderr=subprocess.DEVNULL)
    return made.returncode == 0


def among(value, near, slack):
    """Each channel within what the values near the ray span."""
    return all(min(v[c] for v in near) - slack[c] <= value[c] <= max(v[c] for v in near) + slack[c] for c in range(3))


def slack(value, relative, least):
    mean, error = value
    return [relative * abs(v) + least + 4.5 * e for v, e in zip(mean, error)]


def mark_edges(pixels, relative, least, scene, folder, tracer, extra, samples=OURS):
    """`relative` of a value and `least` are no difference (judge.py)."""
    arguments = scene.arguments()
    theirs = tracers.rtrace(folder, arguments, [n for p in pixels for n in neighbours(p.ray)], THEIRS)
    count = len(theirs) // len(pixels)
    rounded = []
    if frozen(folder):
        rounded = tracers.rtrace(folder, arguments, [p.ray for p in pixels], THEIRS, "frozen.oct")
    for i, p in enumerate(pixels):
        near = [v for v, _ in theirs[count * i:count * i + count] + rounded[i:i + 1]] + [p.theirs[0]]
        p.edge = among(p.ours[0], near, slack(p.ours, relative, least))
    rest = [p for p in pixels if not p.edge]
    for p in rest[:FEW]:  # many have another reason
        try:
            ours = tracers.ptrace(tracer, folder, arguments + " " + extra, list(neighbours(p.ray)), *samples)
        except tracers.Refused:  # it takes too long
            continue
        near = [v for v, _ in ours] + [p.ours[0]]
        p.edge = among(p.theirs[0], near, slack(p.theirs, relative, least))
