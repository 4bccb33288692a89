#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""years.py OUT [SCENE ...]: how often the intervals of a year hold, and how often its class is wrong.

POOL hours of each scene's Mondays, those next to a limit of DGP, are rendered by SEEDS seeds at 64 x 64, nine frames,
and once with TRUTH x TRUTH pixels and 17 frames.  A year draws LENGTH hours, of these a seed each, so that errors of
its hours are independent; the others are hours whose interval holds no limit, the same in all years and taken as true.
The hours above one limit are about 5 % of it, so that the class is hard to say.  What is there is not made again.
"""
import os
import pathlib
import random
import sys

import truth
from truth import class_of, hours_of, near, render, verdict

WORDS = {"POOL": 60, "SEEDS": 6, "YEARS": 100, "LENGTH": 200, "TRUTH": 256}
POOL, SEEDS, YEARS, LENGTH, TRUTH = (int(os.environ.get(*word)) for word in WORDS.items())
NUMBERS = ["above_0.35", "above_0.40", "above_0.45", "DGPe5"]


def pooled(scene, out):
    """Hours of many seeds: their lines and the true one; and hours that are sure."""
    year = hours_of(render(out, scene, "year/0.tsv", truth.YEAR, 64, 9))
    names = sorted((name for name, h in year.items() if h.ev > 0), key=lambda name: near(year[name].dgp))[:POOL]
    words = " ".join(sorted(names))
    exact = hours_of(render(out, scene, f"pool.{TRUTH}.tsv", words, TRUTH, 17, 99))
    seeds = [hours_of(render(out, scene, f"pool.64.{k}.tsv", words, 64, 9, k)) for k in range(2, SEEDS + 2)]
    sure = {name: h for name, h in year.items() if name not in exact and not any(map(h.holds, truth.LIMITS))}
    return {name: ([seed[name] for seed in seeds], exact[name]) for name in names}, sure


def drawn(rng, pool, sure):
    """Two years, as seen and as it is: hour -> line."""
    limit = rng.choice([limit for limit in truth.LIMITS if sum(h.dgp > limit for _, h in pool.values()) > 2])
    above = [name for name, (_, h) in pool.items() if h.dgp > limit]
    more = [name for name, h in sure.items() if h.dgp > limit]
    wanted = LENGTH // 20 + rng.randint(-3, 4)
    above = rng.sample(above, min(wanted, len(above)))
    above += rng.sample(more, min(wanted - len(above), len(more)))
    below = [name for name, (_, h) in pool.items() if h.dgp <= limit]
    rest = [name for name, h in sure.items() if h.dgp <= limit]
    below += rng.sample(rest, min(len(rest), LENGTH - len(above) - len(below)))
    seen = {name: rng.choice(pool[name][0]) if name in pool else sure[name] for name in above + below}
    return seen, {name: pool[name][1] if name in pool else sure[name] for name in seen}


def table(path, hours):
    columns = list(next(iter(hours.values())).row)
    lines = ["\t".join(h.row[c] for c in columns) for h in hours.values()]
    path.write_text("\t".join(columns) + "\n" + "\n".join(lines) + "\n")
    return path


def main():
    out = pathlib.Path(sys.argv[1]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    rng = random.Random(1)
    inside, classes = dict.fromkeys(NUMBERS, 0), {"right": 0, "undecided": 0, "wrong": 0}
    width, years = dict.fromkeys(NUMBERS, 0), 0
    for scene in sys.argv[2:] or ["office", "translucent"]:
        pool, sure = pooled(scene, out)
        off = [line.dgp - h.dgp for lines, h in pool.values() for line in lines]
        within = sum(line.holds(h.dgp) for lines, h in pool.values() for line in lines)
        print(f"{scene}: {len(pool)} hours, {SEEDS} seeds: off by {sum(map(abs, off)) / len(off):.4f} in the mean "
              f"(bias {sum(off) / len(off):+.4f}), within interval and pixels in {within / len(off):.1%}; "
              f"{len(sure)} others")
        for _ in range(YEARS):
            seen, exact = (verdict(table(out / "drawn.tsv", hours)) for hours in drawn(rng, pool, sure))
            for name in NUMBERS:
                low, high, true = (float(v) for v in (seen[name + ".lo"], seen[name + ".hi"], exact[name]))
                inside[name] += low - 1e-9 <= true <= high + 1e-9
                width[name] += high - low
            right = ["high", "medium", "minimum", "none"][class_of(float(exact["DGPe5"]) - 1e-9)]
            classes[{right: "right", "undecided": "undecided"}.get(seen["class"], "wrong")] += 1
            years += 1
    for name in NUMBERS:
        print(f"{name}: {years} years, {inside[name]} inside, mean width {width[name] / years:.3g}")
    print(f"intervals: {len(NUMBERS) * years} tries, {sum(inside.values())} inside")
    print(f"class: {years} tries, {classes['right']} right, {classes['undecided']} undecided, {classes['wrong']} wrong")


if __name__ == "__main__":
    main()
