#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# How often the intervals of Ev, mEDI, EvV and mDER hold the truth at the end of runs of some lengths, in rooms of
# make_room.py.  Sky, sun and lamps have spectra of their own, so that mDER differs from path to path.  Numbers are
# kept, not frames.  The truth for odd seeds is the mean of all even ones of the longest runs and the other way round,
# which is exact as far as light is a sum; that of mDER is the ratio of such means.
#     python3 studies/coverage/actions.py -bin build/bin -out out/coverage-actions -scenes 1300-1305
import argparse, concurrent.futures, os, statistics, subprocess
from judge import read
from make_room import Room
from report import rate
from scenes import names

METRICS = ['Ev', 'mEDI', 'EvV', 'mDER']
LIGHT = ('-action mel -action V -lamp sky_glow=12000 -lamp ground_glow=6500 -lamp solar=5000 -lamp lamp=LED-B3 '
         '-lamp shown_high=LED-B5 -lamp shown_low=LED-B5')


def options():
    p = argparse.ArgumentParser(description='coverage of the intervals of pictures of actions')
    p.add_argument('-bin', required=True, help='the built programs')
    p.add_argument('-out', required=True, help='where tables are kept')
    p.add_argument('-scenes', required=True, help='draws of make_room.py')
    p.add_argument('-seeds', type=int, default=100)
    p.add_argument('-size', type=int, default=48, help='pixels a side')
    p.add_argument('-frames', type=int, nargs='+', default=[8, 36], help='diffuse frames of runs')
    p.add_argument('-jobs', type=int, default=1)
    return p.parse_args()


def last_row(o, draw, frames, seed):
    folder = os.path.join(os.path.abspath(o.out), draw)
    if not os.path.exists(os.path.join(folder, 'view.vf')):
        Room(int(draw)).write(folder, int(draw))
    path = os.path.join(folder, '%d_%d_%d.tsv' % (o.size, frames, seed))
    if not os.path.exists(path):
        words = '-n 1 -moments- -vf view.vf -x %d -y %d -seed %d -frames %d' % (o.size, o.size, seed, frames + 1)
        command = ('set -o pipefail; ptrace -w- %s %s room.rad sky.rad | ptaccum | vcmetrics -W- -ci 95 -metrics %s'
                   ' > %s.part' % (words, LIGHT, ','.join(METRICS), path))
        subprocess.run(['bash', '-c', command], cwd=folder, check=True, stderr=subprocess.DEVNULL,
                       env=dict(os.environ, PATH=os.path.abspath(o.bin) + ':' + os.environ['PATH']))
        os.rename(path + '.part', path)
    return read(path)[-1]


def truths(longest):
    """Of odd seeds from even ones and the other way round."""
    found = {}
    for parity in 0, 1:
        means = {m: statistics.fmean(r[m] for s, r in longest.items() if s % 2 == parity) for m in METRICS[:3]}
        found[1 - parity] = dict(means, mDER=means['mEDI'] / means['EvV'])
    return found


def judge(runs, truth, metric):
    """Hits, misses below, half-width over 1.96 standard deviations."""
    rows = [(truth[s % 2][metric], r) for s, r in runs.items()]
    hits = [r[metric + '.lo'] <= t <= r[metric + '.hi'] for t, r in rows]
    below = [r[metric + '.hi'] < t for t, r in rows]
    half = statistics.median((r[metric + '.hi'] - r[metric + '.lo']) / 2 for _, r in rows)
    return hits, below, half / (1.96 * statistics.stdev(r[metric] for _, r in rows))


def main():
    o = options()
    draws, seeds = names(o.scenes), range(1, o.seeds + 1)
    tasks = [(d, n, s) for s in seeds for d in draws for n in o.frames]
    with concurrent.futures.ThreadPoolExecutor(o.jobs) as pool:
        rows = dict(zip(tasks, pool.map(lambda t: last_row(o, *t), tasks)))
    print('frames\troom\tmetric\tinside, %\tbelow, %\thalf-width over 1.96 sd')
    for n in o.frames:
        pooled = {m: [] for m in METRICS}
        for d in draws:
            truth = truths({s: rows[d, max(o.frames), s] for s in seeds})
            for m in METRICS:
                hits, below, ratio = judge({s: rows[d, n, s] for s in seeds}, truth, m)
                pooled[m].append((hits, below, ratio))
                print('%d\t%s\t%s\t%s\t%.1f\t%.2f' % (n, d, m, rate(hits), 100 * statistics.fmean(below), ratio))
        for m, of in pooled.items():
            hits, below = ([x for cell in of for x in cell[k]] for k in (0, 1))
            print('%d\tall\t%s\t%s\t%.1f\t%.2f' % (n, m, rate(hits), 100 * statistics.fmean(below),
                                                   statistics.median(cell[2] for cell in of)))


if __name__ == '__main__':
    main()
