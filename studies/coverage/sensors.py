#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# How often the intervals of grids of sensors hold the truth, in rooms of make_room.py: of points, and of numbers of a
# grid over the floor and of one on the desk.  Frames are traced once and kept; vcmetrics of another build may measure
# them under another -label.  The truth for odd seeds is the mean of all even ones and the other way round.  Frames of
# few points are independent (64 samples of a net each), so that -cuts makes four runs of 16 frames of one of 64.
import argparse, concurrent.futures, math, os, re, statistics, subprocess
from make_room import Room
from report import rate
from scenes import names

LOOKS, STOP = [16, 32, 64, 256], 0  # frames; STOP: where -until ended the run
LEAST_OF = {'point': {16: 90}}      # percent; else 93
WIDEST = {'min': 6, 'U0': 6}        # half-widths over 1.96 standard deviations among runs; else 3
HEIGHT, MARGIN = .8, .3             # m: of the grid over the floor, and from the walls


def options():
    p = argparse.ArgumentParser(description='coverage of the intervals of grids of sensors')
    p.add_argument('-bin', required=True, help='the built programs')
    p.add_argument('-out', required=True, help='where everything is kept')
    p.add_argument('-scenes', required=True, help='draws of make_room.py')
    p.add_argument('-seeds', type=int, default=200)
    p.add_argument('-first', type=int, default=1, help='the first seed')
    p.add_argument('-frames', type=int, default=LOOKS[-1], help='of a run; other seeds may have others')
    p.add_argument('-do', default='make,judge', help='judge takes all seeds that are there')
    p.add_argument('-points', type=int, default=200, help='over the floor')
    p.add_argument('-measure', help='ptaccum and vcmetrics of another build')
    p.add_argument('-label', default='now', help='a name for how it is measured')
    p.add_argument('-cuts', action='store_true', help='also the runs of 16, 32, 64 frames that follow in a stream')
    p.add_argument('-jobs', type=int, default=1)
    return p.parse_args()


def run(words, folder, out=None, source=None):
    done = subprocess.run(words, cwd=folder, stdin=source, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode not in (0, 4):
        raise SystemExit(done.stderr.decode())
    if out:
        with open(out + '.part', 'wb') as f:
            f.write(done.stdout)
        os.rename(out + '.part', out)
    return done


def table(path):
    rows = [line.rstrip('\n').split('\t') for line in open(path)]
    return [dict(zip(rows[0], r)) for r in rows[1:]]


class Study:
    """One room."""

    def __init__(self, o, draw):
        self.o, self.folder = o, os.path.join(os.path.abspath(o.out), draw)
        self.bin, self.measuring = [os.path.abspath(f) for f in (o.bin, o.measure or o.bin)]
        self.tables = os.path.join(self.folder, o.label)
        os.makedirs(self.tables, exist_ok=True)
        self.room = Room(int(draw))
        if not os.path.exists(os.path.join(self.folder, 'desk.pts')):
            self.prepare(int(draw))
        self.grids = [g for g in ('floor', 'desk', 'outside') if os.path.exists(self.file(g + '.pts'))]
        self.points = [w for g in self.grids for w in ('-points', g + '.pts')]
        self.choose_limits()

    def file(self, name):
        return os.path.join(self.folder, name)

    def prepare(self, draw):
        r = self.room
        r.write(self.folder, draw)
        wide, long = r.width - 2 * MARGIN, r.depth - 2 * MARGIN
        step = math.sqrt(wide * long / self.o.points)
        nx, ny = max(2, round(wide / step)), max(2, round(long / step))
        floor = [(MARGIN + (i + .5) * wide / nx, MARGIN + (j + .5) * long / ny, HEIGHT)
                 for j in range(ny) for i in range(nx)]
        a, b, _, d = r.task
        desk = [r.ahead([a[k] + (b[k] - a[k]) * (i + .5) / 6 + (d[k] - a[k]) * (j + .5) / 4 for k in range(3)])
                for j in range(4) for i in range(6)]
        if r.sky_text:
            self.write_points('outside', [(0, 0, 60)])
        for name, points in (('floor', floor), ('desk', desk)):
            # A point in a cabinet has no light: its interval would hold without merit.
            self.write_points('all', points)
            dark = run([os.path.join(self.bin, 'ptrace'), '-points', 'all.pts', '-frames', '1', 'room.rad', 'sky.rad'],
                       self.folder).stderr.decode()
            dark = {int(n) for n in re.findall(r'all\.pts:(\d+): no light', dark)}
            self.write_points(name, [p for k, p in enumerate(points) if k + 1 not in dark])

    def write_points(self, name, points):
        with open(self.file(name + '.pts'), 'w') as f:
            f.writelines('%.4f %.4f %.4f 0 0 1\n' % tuple(p) for p in points)

    def choose_limits(self):
        """Two limits a grid, near the fifth and the half of its points, from frames that are not judged."""
        if not os.path.exists(self.file('pilot.tsv')):
            self.trace(0, 17)
            self.each(0, 'pilot.tsv', [])
        self.columns = []
        for grid in self.grids[:2]:
            values = sorted(float(r['E']) for r in table(self.file('pilot.tsv')) if r['grid'] == grid)
            limits = ['share%.2g' % values[int(len(values) * at)] for at in (.2, .5)]
            limits = ['share%g' % float(name[5:]) for name in limits]
            self.columns += ['%s.%s' % (grid, n) for n in ['mean', 'median', 'p5', 'min', 'U0'] + limits]
            self.columns += [grid + '.df'] if 'outside' in self.grids else []
        self.rule = '%s .02' % next(c for c in self.columns if 'share' in c)

    def trace(self, seed, frames):
        out = self.file('%d.lux' % seed)
        if not os.path.exists(out):
            run([os.path.join(self.bin, 'ptrace'), '-w-', '-n', '1', '-seed', str(seed), '-frames', str(frames),
                 *self.points, 'room.rad', 'sky.rad'], self.folder, out)

    def measure(self, seed, words, out):
        """What vcmetrics says on stderr."""
        frames = subprocess.Popen([os.path.join(self.measuring, 'ptaccum'), '%s.lux' % seed], cwd=self.folder,
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        done = run([os.path.join(self.measuring, 'vcmetrics'), '-W-', '-ci', '95'] + words, self.folder, out,
                   frames.stdout)
        frames.stdout.close()
        frames.wait()
        return done.stderr.decode()

    def each(self, seed, out, words):
        return self.measure(seed, ['-each', *self.points, *words], self.file(out))

    def cut(self, seed, first, n):
        """Frames first .. first + n - 1 as a stream of their own."""
        with open(self.file('%d.lux' % seed), 'rb') as f:
            pictures = f.read().split(b'#?RADIANCE')[1:]
        name = '%d.cut' % seed
        with open(self.file(name + '.lux'), 'wb') as f:
            for k, picture in enumerate([pictures[0]] + pictures[first:first + n]):
                head, pixels = picture.split(b'\n\n', 1)
                head = re.sub(rb'\nLASTFRAME=\d+', b'\nLASTFRAME=%d' % n, head)
                f.write(b'#?RADIANCE' + re.sub(rb'\nFRAME=\d+', b'\nFRAME=%d' % k, head) + b'\n\n' + pixels)
        return name

    def measure_cuts(self, seed):
        for n in LOOKS:
            for first in range(n + 1, self.o.frames - n + 2, n):
                name, at = self.cut(seed, first, n), '%d.%d' % (n, first)
                self.measure(name, ['-metrics', ','.join(self.columns)], self.file(self.table_of(seed, at + '.all')))
                self.each(name, self.table_of(seed, at), [])

    def table_of(self, seed, look):
        return os.path.join(self.o.label, '%d.%s.tsv' % (seed, look))

    def make(self, seed):
        done = self.file(self.table_of(seed, 'stop'))
        if os.path.exists(done):
            return
        self.trace(seed, self.o.frames + 1)
        self.measure(seed, ['-metrics', ','.join(self.columns)], self.file(self.table_of(seed, 'all')))
        for n in LOOKS:
            if n <= self.o.frames:
                self.each(seed, self.table_of(seed, n), ['-max-frames', str(n + 1)])
        if self.o.cuts:
            self.measure_cuts(seed)
        said = self.each(seed, self.table_of(seed, 'each'), ['-until', self.rule])
        with open(done, 'w') as f:
            f.write(re.search(r'after (\d+) frames', said).group(1))

    def read(self, seed):
        stop = int(open(self.file(self.table_of(seed, 'stop'))).read())
        rows = {int(r['frame']): r for r in table(self.file(self.table_of(seed, 'all')))}
        each = {n: table(self.file(self.table_of(seed, n))) for n in LOOKS if n in rows}
        each[STOP] = table(self.file(self.table_of(seed, 'each')))
        runs = {n: [(rows[n or stop], each[n])] for n in each}
        for n in runs:
            at = lambda: self.file(self.table_of(seed, '%d.%d' % (n, 1 + n * len(runs[n]))))
            while n and os.path.exists(at()):
                runs[n].append((table(at()[:-4] + '.all.tsv')[-1], table(at())))
        return runs, stop

    def seeds_there(self):
        return sorted(int(f.split('.')[0]) for f in os.listdir(self.tables) if f.endswith('.stop.tsv'))


def numbers(study, values):
    """The columns of a truth, (grid, E) of each point."""
    out = {}
    for c in study.columns:
        grid, what = c.split('.', 1)
        e = sorted(v for g, v in values if g == grid)
        at = lambda p: e[int(p)] + (p - int(p)) * (e[min(int(p) + 1, len(e) - 1)] - e[int(p)])
        mean = statistics.fmean(e)
        outside = [v for g, v in values if g == 'outside']
        out[c] = {'mean': lambda: mean, 'median': lambda: at(.5 * (len(e) - 1)), 'p5': lambda: at(.05 * (len(e) - 1)),
                  'min': lambda: e[0], 'U0': lambda: e[0] / mean, 'df': lambda: 100 * mean / outside[0],
                  'shar': lambda: sum(v >= float(what[5:]) for v in e) / len(e)}[what if what in (
                      'mean', 'median', 'p5', 'min', 'U0', 'df') else what[:4]]()
    return out


class Cell:
    def __init__(self):
        self.hits, self.below, self.widths, self.values = [], [], [], []

    def add(self, value, low, high, truth):
        close = 1e-6 * abs(truth)
        self.hits.append(low - close <= truth <= high + close)  # nan is a miss
        self.below.append(high + close < truth)
        self.widths.append(high - low), self.values.append(value)

    def ratio(self):
        sd = statistics.stdev(self.values)
        return statistics.median(self.widths) / 2 / 1.96 / sd if sd > 1e-6 * abs(statistics.fmean(self.values)) else 0


def judge(study, seeds):
    runs = {s: study.read(s) for s in seeds}
    frames = {s: max(run) for s, (run, _) in runs.items()}
    last = {s: [(r['grid'], float(r['E'])) for r in run[frames[s]][0][1]] for s, (run, _) in runs.items()}
    cells = {}
    for parity in 0, 1:
        others = [s for s in seeds if s % 2 != parity]
        n = sum(frames[s] for s in others)
        truth = [(column[0][0], sum(frames[s] * v for s, (_, v) in zip(others, column)) / n)
                 for column in zip(*(last[s] for s in others))]
        exact = numbers(study, truth)
        for seed in [s for s in seeds if s % 2 == parity]:
            for look, row, each in [(n, *one) for n, of in runs[seed][0].items() for one in of]:
                for c in study.columns:
                    cells.setdefault((c, look), Cell()).add(*(float(row[c + e]) for e in ('', '.lo', '.hi')), exact[c])
                for k, (r, (_, e)) in enumerate(zip(each, truth)):
                    if r['grid'] != 'outside':
                        cells.setdefault((k, look), Cell()).add(*(float(r[x]) for x in ('E', 'lo', 'hi')), e)
    return cells, [stop for _, stop in runs.values()]


def name_of(column):
    return 'point' if isinstance(column, int) else re.sub(r'\d+$', '', column) if 'share' in column else column


def report(found):
    merged = {}
    for draw, (cells, stops) in found.items():
        print('%s: %d seeds, stops at a median of %d frames' % (draw, len(stops), statistics.median(stops)))
        for (column, look), cell in cells.items():
            merged.setdefault((name_of(column), look), []).append((draw, column, cell))
    columns = list(dict.fromkeys(c for c, _ in merged))
    looks = LOOKS + [STOP]
    print('\t'.join(['inside, %'] + ['%s' % (n or 'stop') for n in looks]))
    for c in columns:
        print('\t'.join([c] + [rate([h for _, _, x in merged[c, n] for h in x.hits]) for n in looks]))
    print('\t'.join(['half-width over 1.96 sd, median of rooms (largest)'] + ['%s' % (n or 'stop') for n in looks]))
    for c in columns:
        ratios = [[x.ratio() for _, _, x in merged[c, n]] for n in looks]
        print('\t'.join([c] + ['%.2f (%.2f)' % (statistics.median(r), max(r)) for r in ratios]))
    for (c, n), all_of in merged.items():
        for draw in found if c == 'point' else []:
            hits = [h for d, _, x in all_of if d == draw for h in x.hits]
            print('points of %s at %s: %s' % (draw, n or 'stop', rate(hits)))
        for draw, column, cell in all_of if c != 'point' else []:
            share, least = 100 * statistics.fmean(cell.hits), 93
            if share < least or cell.ratio() > WIDEST.get(c.split('.')[-1], 3):
                print('misses: %s %s at %s: inside %s, below %.0f, ratio %.2f' % (
                    draw, column, n or 'stop', rate(cell.hits), 100 * statistics.fmean(cell.below), cell.ratio()))


def main():
    o = options()
    studies = {draw: Study(o, draw) for draw in names(o.scenes)}
    seeds = range(o.first, o.first + o.seeds) if 'make' in o.do else []
    with concurrent.futures.ThreadPoolExecutor(o.jobs) as pool:
        list(pool.map(lambda at: at[0].make(at[1]), [(s, seed) for seed in seeds for s in studies.values()]))
    if 'judge' in o.do:
        report({draw: judge(s, s.seeds_there()) for draw, s in studies.items()})


if __name__ == '__main__':
    main()
