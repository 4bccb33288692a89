# SPDX-License-Identifier: BSD-3-Clause
"""Both programs on the rays of a scene, with more samples where they seem to differ, until it is noise or a difference.

A ray agrees if each channel is within 0.2 % of its value and 2e-4 of the brightest (or of what is as good as black in
this scene), or within 4.5 standard errors of both means together.  Rays that do not are looked at once more
(second_look.py)."""
import math

import second_look
import tracers

RELATIVE, SIGMA = 2e-3, 4.5
BLACK = 2e-3           # of typical(): nobody sees it
FIRST, LAST = 0, 3     # stages
OURS = [(32, 64), (512, 2048), (8192, 8192), (65536, 65536)]
THEIRS = [2, 16, 128, 1024]
MANY = 10


class Pixel:
    def __init__(self, ray):
        self.ray, self.ours, self.theirs, self.edge, self.rare = ray, None, None, False, False

    def agrees(self, floor):
        """Channels as a whole: a mean of noise and a bound of what no one sees."""
        (a, ea), (b, eb) = self.ours, self.theirs
        scale = max(max(abs(v) for v in b), floor)
        for c in range(3):
            if not math.isfinite(a[c]) or not math.isfinite(b[c]):
                return False
            bound = max(RELATIVE * abs(b[c]) + 2e-4 * scale, SIGMA * math.hypot(ea[c], eb[c]), BLACK * floor)
            if abs(a[c] - b[c]) > bound:
                return False
        return True

    def sure(self):
        """More samples will not help.  (One that never varied may be waiting for a rare case.)"""
        (a, ea), (b, eb) = self.ours, self.theirs
        far = [.03 * max(a[c], b[c]) + 15 * math.hypot(ea[c], eb[c]) for c in range(3)]
        return any(ea) and any(abs(a[c] - b[c]) > far[c] for c in range(3))

    def deviation(self):
        """Relative to the brighter, for choosing the worst."""
        return max(abs(x - y) / (abs(x) + abs(y) + 1e-9) for x, y in zip(self.ours[0], self.theirs[0]))

    def noise(self):
        (a, ea), (b, eb) = self.ours, self.theirs
        return max(math.hypot(x, y) for x, y in zip(ea, eb)) / (max(abs(v) for v in a + b) + 1e-9)


def trace_stage(pixels, stage, scene, folder, tracer, extra):
    rays = [p.ray for p in pixels]
    arguments = scene.arguments()
    theirs = tracers.rtrace(folder, arguments, rays, THEIRS[stage])
    ours = tracers.ptrace(tracer, folder, arguments + " " + extra, rays, *OURS[stage])
    for p, a, b in zip(pixels, ours, theirs):
        if scene.noisy() and not any(b[1]):  # rtrace has not met the rare case; it is as noisy as we are
            b = (b[0], [e * math.sqrt(OURS[stage][1] / THEIRS[stage]) for e in a[1]])
        p.ours, p.theirs = a, b


def typical(pixels):
    """A twentieth of the scene's typical brightness: what is darker is as good as black."""
    values = sorted(max(p.theirs[0]) for p in pixels)
    return max(.05 * values[len(values) // 2], .005 * sum(values) / len(values)) + 1e-7


def judge(scene, folder, tracer, extra="", first=FIRST, last=LAST, floor=None):
    """The pixels of a scene already written to `folder`, and those that differ.  Throws tracers.Refused."""
    pixels = [Pixel(ray) for ray in scene.rays]
    trace_stage(pixels, first, scene, folder, tracer, extra)
    floor = floor or typical(pixels)
    wrong = [p for p in pixels if not p.agrees(floor) or p.noise() > .05]
    for stage in range(first + 1, last + 1):
        sure = [p for p in wrong if stage > 1 and p.sure()]
        wrong = [p for p in wrong if p not in sure]
        some = wrong[:MANY] if stage == LAST else wrong  # the dearest stage for a sample of them
        if not some:
            wrong = sure
            break
        trace_stage(some, stage, scene, folder, tracer, extra)
        still = [p for p in some if not p.agrees(floor) or (p.noise() > .05 and stage == 1)]
        wrong = sure + still + (wrong[MANY:] if len(some) < len(wrong) and 2 * len(still) > len(some) else [])
    wrong = [p for p in wrong if not p.agrees(floor)]
    if wrong and len(wrong) <= MANY:
        second_look.look_for_rare_ways(wrong, scene, folder, tracer, extra)
        wrong = [p for p in wrong if not p.agrees(floor)]
    if wrong:
        samples = second_look.OURS if first == FIRST else second_look.QUICK
        second_look.mark_edges(wrong, RELATIVE, 2e-4 * floor, scene, folder, tracer, extra, samples)
    return pixels, [p for p in wrong if not p.edge]
