# SPDX-License-Identifier: BSD-3-Clause
# From the tables of a scene to cells: a metric and a number of frames over all seeds, with how many intervals hold the
# truth, how many lie wholly below it, and how wide they are; and where a rule of -until would have stopped.
import math, os, statistics
from collections import defaultdict

PARTS = 8  # of a truth: its error and its bias come from them; a quarter of the bias counts as error
LOOKS = [2, 3, 4, 5, 8, 13, 17, 25, 36, 50, 73, 103, 146, 207]
LINEAR = ['Ev', 'Lavg', 'desk.TAL']  # no bias
FALL = {'RAMMG': .72}  # bias falls with this power of the frames (long runs); that of others, to first order, with 1
TOLERANCES = [.7, 1, 1.4, 2]  # of -until, in median half-widths of the last look but two
NAN = float('nan')


def read(path):
    lines = [line.rstrip('\n').split('\t') for line in open(path)]
    number = lambda cell: float(cell) if cell not in ('', '-') else NAN
    words = ('tails', 'errors', 'file')
    return [{k: v if k in words else number(v) for k, v in zip(lines[0], cells)} for cells in lines[1:]]


def plain(column):
    return column[:-1] if column.endswith('u') else column


def truths(folder):
    """metric -> (value, standard error) for even and for odd seeds, from the pictures of the other ones."""
    out = []
    for parity in 1, 0:
        counts = [int(f[7:-4]) for f in os.listdir(folder) if f.startswith('truth%d_' % parity) and f.endswith('.tsv')]
        whole, *parts = read(os.path.join(folder, 'truth%d_%d.tsv' % (parity, max(counts))))
        values = {}
        for m in list(whole)[1:]:
            them = [p[m] for p in parts]
            bias = 0 if m in LINEAR else (statistics.mean(them) - whole[m]) / (PARTS ** FALL.get(m, 1) - 1)
            values[m] = whole[m] - bias, math.hypot(statistics.stdev(them) / math.sqrt(PARTS), bias / 4)
        out.append(values)
    return out


def recorded_truths(path, scene):
    """The same from a file of scene, metric, value and error; the same for all seeds."""
    values = {r['metric']: (float(r['value']), float(r['error'])) for r in table(path) if r['scene'] == scene}
    return [values, values]


def table(path):
    lines = [line.rstrip('\n').split('\t') for line in open(path) if not line.startswith('#')]
    return [dict(zip(lines[0], cells)) for cells in lines[1:]]


class Interval:
    def __init__(self, seed, truth, value, low, high, tails):
        self.seed, self.value, self.half, self.tails = seed, value, (high - low) / 2, tails
        self.inside, self.below = low <= truth <= high, high < truth


class Cell:
    """All runs at one look, of a metric."""

    def __init__(self, runs, truth, truth_error):
        self.runs, self.truth, self.truth_error = len(runs), truth, truth_error
        values = [r.value for r in runs if math.isfinite(r.value)]
        self.sd = statistics.stdev(values) if len(values) > 2 else NAN
        self.mean = statistics.mean(values) if values else NAN
        self.intervals = [r for r in runs if not math.isnan(r.half)]
        self.half = statistics.median(r.half for r in self.intervals) if self.intervals else NAN
        self.ratio = self.half / (1.96 * self.sd) if self.sd > 0 else NAN
        # Judged where most runs claim an interval, and of values that vary: a DGP of 1 is 1 in all runs.
        self.judged = len(self.intervals) * 2 > self.runs and self.sd > 1e-7 * abs(truth)

    def share(self, what):
        return statistics.mean(getattr(r, what) for r in self.intervals) if self.intervals else NAN


class Scene:
    """cells[metric, look]; no cell is missing.  of_files: frames of tables that are of files, not of streams."""

    def __init__(self, tables, truth, of_files):
        rows = {seed: {int(r.get('frame', of_files)): r for r in read(path)} for seed, path in tables.items()}
        some = next(iter(rows.values()))
        self.looks = [k for k in sorted(some) if k in LOOKS + [of_files]]
        columns = [c[:-3] for c in some[self.looks[0]] if c.endswith('.lo')]
        self.metrics = [plain(c) for c in columns]
        self.cells = {}
        for c in columns:
            m = plain(c)
            errors = [t[m][1] for t in truth]
            for k in self.looks:
                runs = [Interval(seed, truth[seed % 2][m][0], at[k][c], at[k][c + '.lo'], at[k][c + '.hi'],
                                 m in map(plain, at[k]['tails'].split())) for seed, at in rows.items()]
                self.cells[m, k] = Cell(runs, statistics.mean(t[m][0] for t in truth), max(errors))

    def judged(self, metric, looks):
        return [self.cells[metric, k] for k in looks if k in self.looks and self.cells[metric, k].judged]

    def by_run(self, metrics, looks, what):
        """Of each run the share of its intervals, over metrics and looks, that are `what`: inside or below."""
        hits = defaultdict(list)
        for m in metrics:
            for cell in self.judged(m, looks):
                for r in cell.intervals:
                    hits[r.seed].append(getattr(r, what))
        return [statistics.mean(h) for h in hits.values()]

    def stops(self, metric, least):
        """(frames, interval, width ratio) of each run and tolerance: the first look that is narrow enough."""
        cells = [(k, self.cells[metric, k]) for k in self.looks if self.cells[metric, k].judged]
        if len(cells) < 3:
            return []
        out, done = [], set()
        for k, cell in cells:
            for r in cell.intervals if k >= least else []:
                for t in TOLERANCES:
                    if r.half <= t * cells[-3][1].half and not r.tails and (r.seed, t) not in done:
                        done.add((r.seed, t))
                        out.append((k, r, r.half / (1.96 * cell.sd)))
        return out
