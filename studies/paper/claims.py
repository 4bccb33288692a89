#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# claims.py OUT SCENE...: each claim of the paper beside what we measure, all against the last frame of the run.  Errors
# are the worst of the scenes (of those whose name holds the sun in view, sky_1100, said apart).
import os, sys

out, scenes = sys.argv[1], sys.argv[2:]


def read(scene):
    lines = [line.rstrip('\n').split('\t') for line in open(os.path.join(out, scene, 'metrics.tsv'))]
    return [{n: c if n in ('tails', 'errors') else float(c) for n, c in zip(lines[0], cells)} for cells in lines[1:]]


runs = {scene: read(scene) for scene in scenes}
last = int(max(rows[-1]['frame'] for rows in runs.values()))


def off(scene, metric, frame, truth=None):
    """Signed, in percent of the last value, at the last line up to this frame."""
    rows = runs[scene]
    at = [r for r in rows if r['frame'] <= frame][-1]
    return 100 * (at[metric] / rows[-1][truth or metric] - 1)


def worst(metric, frame, truth=None):
    if frame >= last:
        return '-'
    found = {s: off(s, metric, frame, truth) for s in scenes}
    where = max(found, key=lambda s: abs(found[s]))
    return '%+.2f %% (%s)' % (found[where], where)


print('claim\tpaper\tours\twithout bias')
for metric, unbiased, frame, paper in [
        ('Ev', '', 1, 'within 0.2 %'), ('Ev', '', 10, 'within 0.01 %'),
        ('DGP', 'DGPu', 10, 'within 5 %, from above'), ('DGP', 'DGPu', 100, 'under 1 %'),
        ('desk.TAL', '', 1, 'under 5 %'), ('desk.TAL', '', 10, 'under 1 %'),
        ('screen.CR', 'screen.CRu', 100, 'above 1 %'), ('screen.CR', 'screen.CRu', 1000, 'under 1 %'),
        ('RAMMG', 'RAMMGu', 100, '10 to 12 %'), ('RAMMG', 'RAMMGu', 1000, '2 to 3 %')]:
    print('%s at frame %d\t%s\t%s\t%s' % (metric, frame, paper, worst(metric, frame),
                                          worst(unbiased, frame, unbiased) if unbiased else ''))
signs = [off(s, 'DGP', n) for s in scenes for n in (1, 2, 5, 10, 50) if n < last]
print('DGP of early frames\talways from above\t%d of %d above, lowest %+.2f %%' %
      (sum(v > 0 for v in signs), len(signs), min(signs)))
falling = sum(a['RAMMG'] > b['RAMMG'] for rows in runs.values() for a, b in zip(rows[2:], rows[3:]))
steps = sum(len(rows) - 3 for rows in runs.values())
print('RAMMG from frame to frame\tfalling\t%d of %d steps fall' % (falling, steps))
by_dgp = sorted(scenes, key=lambda s: runs[s][-1]['DGP'])
print('lowest and highest DGP\tovercast, 11 h with the sun in the window\t%s %.3f, %s %.3f' % (
    by_dgp[0], runs[by_dgp[0]][-1]['DGP'], by_dgp[-1], runs[by_dgp[-1]][-1]['DGP']))
print('frames of these runs\t10000\t%d' % last)
