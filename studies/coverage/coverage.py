#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# coverage.py OUT: how often intervals hold the long-run value, at fixed frames and where the rule of -until stops; how
# wide they are; and how far the means of the metrics lie off.  The first 20 seeds choose the tolerances, no others.
import math, os, statistics, sys

PILOT, LEAST, RULE_FRAMES, LONG = 20, 64, 73, 900001


def read(path):
    lines = [line.rstrip('\n').split('\t') for line in open(path)]
    names = lines[0]
    return [{n: c if n == 'tails' else float(c) for n, c in zip(names, cells)} for cells in lines[1:]]


def looks(rows):
    """Lines whose intervals are new: each look comes when the frames have grown by the square root of 2."""
    out, due = [], 2
    for row in rows:
        if row['frame'] >= due:
            out.append(row)
            due = math.ceil(row['frame'] * 1.41421356)
    return out


def half(row, m):
    return (row[m + '.hi'] - row[m + '.lo']) / 2


def holds(row, m, truth):
    return row[m + '.lo'] <= truth <= row[m + '.hi']


def stop(run, m, tolerance):
    for row in run:
        if row['frame'] >= LEAST and half(row, m) <= tolerance and m not in row['tails'].split():
            return row
    return None


def share(hits):
    p = sum(hits) / len(hits)
    return '%.1f +- %.1f' % (100 * p, 100 * math.sqrt(max(p * (1 - p), 1e-9) / len(hits)))


def scene(folder, name):
    truth = read(os.path.join(folder, '%d.tsv' % LONG))[-1]
    seeds = sorted(int(f[:-4]) for f in os.listdir(folder) if f[:-4].isdigit() and f.endswith('.tsv'))
    runs = [looks(read(os.path.join(folder, '%d.tsv' % s))) for s in seeds if s != LONG]
    pilot, runs = runs[:PILOT], runs[PILOT:]
    metrics = [n[:-3] for n in truth if n.endswith('.lo')]
    print('\n%s: %d runs; the long run has %d frames' % (name, len(runs), truth['frame']))
    print('metric\tlong-run\tframes\tcoverage %\twidth ratio\tbias\tbias error')
    for m in metrics:
        value = truth[m]
        width = {}  # 1.96 x the spread over the seeds, by frames
        for k, row in enumerate(runs[0]):
            at = [run[k] for run in runs if not math.isnan(half(run[k], m))]
            if row['frame'] < 4 or len(at) < len(runs) // 2:
                continue
            shown = [r[m] for r in at]
            width[row['frame']] = 1.96 * statistics.stdev(shown)
            print('%s\t%.6g\t%d\t%s\t%.2f\t%.4g\t%.2g' % (
                m, value, row['frame'], share([holds(r, m, value) for r in at]),
                statistics.median(half(r, m) for r in at) / width[row['frame']], statistics.mean(shown) - value,
                statistics.stdev(shown) / math.sqrt(len(shown))))
        near = [half(r, m) for run in pilot for r in run if r['frame'] == RULE_FRAMES and not math.isnan(half(r, m))]
        done = [s for s in (stop(run, m, statistics.median(near)) for run in runs) if s] if near else []
        if done:
            print('%s\t-until %s %.3g: %d of %d stop, median at %d\t%s\t%.2f' % (
                m, m, statistics.median(near), len(done), len(runs), statistics.median(s['frame'] for s in done),
                share([holds(s, m, value) for s in done]),
                statistics.median(half(s, m) / width[s['frame']] for s in done)))


for entry in sorted(os.listdir(sys.argv[1])):
    if os.path.exists(os.path.join(sys.argv[1], entry, '%d.tsv' % LONG)):
        scene(os.path.join(sys.argv[1], entry), entry)
