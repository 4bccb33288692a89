#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# frames.py OUT: after how many frames a value is and stays within 1 % of the long run's: median and range of the seeds;
# and how far the last frame's value lies off (root mean square).
import math, os, re, statistics, sys

LONG = 900001


def read(path):
    lines = [line.rstrip('\n').split('\t') for line in open(path)]
    return [dict(zip(lines[0], map(float, cells))) for cells in lines[1:]]


def needed(rows, metric, truth):
    """The first frame from which on it stays within 1 %; more than all of them: infinite."""
    out = float('inf')
    for row in reversed(rows):
        if not abs(row[metric] / truth - 1) <= 0.01:
            break
        out = row['frame']
    return out


found = {}
for name in os.listdir(sys.argv[1]):
    match = re.fullmatch(r'(.*)\.(default|plain|guided|focus[=.0-9]*)\.(\d+)\.tsv', name)
    if match:
        found.setdefault(match[1], {}).setdefault(match[2], {})[int(match[3])] = read(os.path.join(sys.argv[1], name))



def number(n):
    return 'more' if n == float('inf') else '%.0f' % n


print('scene\tsampling\tseeds\tmetric\tframes until within 1 %\tfewest\tmost\twithin 1 % at frame 10\t'
      'off at the last frame')
for scene, ways in sorted(found.items()):
    long_runs = [runs.pop(LONG) for runs in ways.values() if LONG in runs]
    if len(long_runs) != 1:
        continue
    truth = long_runs[0][-1]
    for way, runs in sorted(ways.items()):
        for metric in ('DGPu', 'DGP', 'screen.CRu', 'screen.CR', 'desk.TAL', 'RAMMGu', 'RAMMG'):
            best = metric if metric.endswith(('u', 'TAL')) else metric + 'u'
            n = [needed(rows, metric, truth[best]) for rows in runs.values()]
            tenth = [r[metric] for rows in runs.values() for r in rows if r['frame'] == 10]
            at10 = [abs(v / truth[best] - 1) <= 0.01 for v in tenth]
            if not n:
                continue
            off = math.sqrt(statistics.mean((rows[-1][metric] / truth[best] - 1) ** 2 for rows in runs.values()))
            print('%s\t%s\t%d\t%s\t%s\t%s\t%s\t%s\t%.1f %%' % (
                scene, way, len(n), metric, number(statistics.median_high(n)), number(min(n)), number(max(n)),
                '%d of %d' % (sum(at10), len(at10)) if at10 else '-', 100 * off))
