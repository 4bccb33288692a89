# SPDX-License-Identifier: BSD-3-Clause
# What the study prints.  Errors are binomial where runs are independent (one look, pooled over scenes).  Looks, metrics
# and tolerances of one run are not independent: pooled over these, the error is that of the mean over runs.
import math, os, statistics, subprocess
from collections import defaultdict

CLAIMED = ['Ev', 'Lavg', 'DGP', 'UGR', 'DGI', 'Lveil', 'desk.TAL', 'pair.CR', 'DGPf', 'UGRf']
NUMBERS = ['inside', 'below', 'half', 'ratio', 'mean', 'truth', 'truth_error', 'sd']  # of a cell, for the file
FROM = 3  # frames: pooled figures leave out the first look


def rate(hits):
    """Percent and binomial error; that of all or none is the one of Laplace's rule."""
    n, k = len(hits), sum(hits)
    return '%.1f +- %.1f' % (100 * k / n, 100 * math.sqrt((k + 1) * (n - k + 1) / (n + 2) ** 3)) if n else '-'


def rate_of_runs(shares):
    if len(shares) < 2:
        return '-'
    return '%.1f +- %.1f' % (100 * statistics.mean(shares), 100 * statistics.stdev(shares) / math.sqrt(len(shares)))


def ratio_text(cells):
    ratios = [c.ratio for c in cells]
    return '%.2f (%.1f)' % (statistics.median(ratios), max(ratios)) if ratios else '-'


class Report:
    def __init__(self, found, title):
        """found: name -> Scene."""
        self.found, self.title = found, title
        one = next(iter(found.values()))
        self.looks, self.metrics = one.looks, one.metrics
        self.late = [k for k in self.looks if k >= FROM]
        self.claimed = [m for m in CLAIMED if m in self.metrics]

    def cells(self, metric, look):
        return [c for s in self.found.values() for c in s.judged(metric, [look])]

    def by_run(self, metrics, what):
        return [share for s in self.found.values() for share in s.by_run(metrics, self.late, what)]

    def print_by_look(self, title, text):
        print('\n%s\n%s' % (title, '\t'.join(['metric'] + ['%d' % k for k in self.looks])))
        for m in self.metrics:
            print('\t'.join([m] + [text(self.cells(m, k)) for k in self.looks]))

    def print_all(self, least):
        errors = [c.truth_error / c.sd for m in self.claimed for c in self.cells(m, self.looks[-1])]
        print('%s; standard error of the truth over that of a run at the last look: median %.2f, at most %.2f' % (
            self.title, statistics.median(errors), max(errors)))
        self.print_by_look('inside, %, by frames', lambda cells: rate([r.inside for c in cells for r in c.intervals]))
        self.print_by_look('half-width over 1.96 standard deviations of seeds: median (largest) of scenes, by frames',
                           ratio_text)
        self.print_by_look('scenes with an interval, by frames', lambda cells: '%d' % len(cells))
        self.print_pooled()
        self.print_failures()
        self.print_stops(least)

    def print_pooled(self):
        print('\npooled over scenes and looks from %d frames on\nmetric\tinside %%\twholly below %%' % FROM)
        for metrics in [[m] for m in self.metrics] + [self.claimed]:
            rates = [rate_of_runs(self.by_run(metrics, what)) for what in ('inside', 'below')]
            print('\t'.join([' '.join(metrics)] + rates))

    def print_failures(self):
        seeds = max(c.runs for s in self.found.values() for c in s.cells.values())
        least = .85 if seeds >= 100 else .8
        print('\nscenes with less than 88 %% over looks from %d frames on, or less than %d %% at a look\n'
              'scene\tmetric\tover looks\tlooks: %%' % (FROM, 100 * least))
        for name, s in self.found.items():
            for m in self.claimed:
                shares = s.by_run([m], self.late, 'inside')
                at = [(k, c.share('inside')) for k in self.late for c in s.judged(m, [k])]
                low = ['%d: %.0f' % (k, 100 * share) for k, share in at if share < least]
                if shares and (statistics.mean(shares) < .88 or low):
                    print('\t'.join([name, m, rate_of_runs(shares), ' '.join(low)]))

    def print_stops(self, least):
        print('\nat the stop: first look from %d frames on that is narrower than a tolerance\n'
              'metric\tstops\tframes (median)\tinside %%\twholly below %%\twidth ratio' % least)
        for m in self.metrics:
            inside, below, all_stops = defaultdict(list), defaultdict(list), []
            for name, s in self.found.items():
                stops = s.stops(m, least)
                all_stops += stops
                for _, r, _ in stops:
                    inside[name, r.seed].append(r.inside), below[name, r.seed].append(r.below)
            if all_stops:
                frames, ratio = [statistics.median(stop[i] for stop in all_stops) for i in (0, 2)]
                rates = [rate_of_runs([statistics.mean(h) for h in hits.values()]) for hits in (inside, below)]
                print('%s\t%d\t%g\t%s\t%s\t%.2f' % (m, len(all_stops), frames, *rates, ratio))

    def write_cells(self, path):
        with open(path, 'w') as out:
            out.write('\t'.join(['scene', 'metric', 'frames', 'runs', 'intervals'] + NUMBERS) + '\n')
            for name, s in self.found.items():
                for (m, k), c in s.cells.items():
                    numbers = [c.share(n) if n in NUMBERS[:2] else getattr(c, n) for n in NUMBERS]
                    whole = ['%d' % n for n in (k, c.runs, len(c.intervals))]
                    out.write('\t'.join([name, m] + whole + ['%.7g' % n for n in numbers]) + '\n')

    def draw(self, path, beside):
        """Of PATH.dat, PATH.svg: coverage by frames, pooled over scenes.  beside: the PATH of another label."""
        with open(path + '.dat', 'w') as out:
            out.write(' '.join(['frames'] + [m.split('.')[-1] for m in self.claimed]) + '\n')
            for k in self.looks:
                hits = [[r.inside for c in self.cells(m, k) for r in c.intervals] for m in self.claimed]
                shares = ['%.2f' % (100 * statistics.mean(h)) if h else 'nan' for h in hits]
                out.write(' '.join(['%d' % k] + shares) + '\n')
        panels = ([beside] if beside else []) + [path]
        words = ['set terminal svg size %d,360 font "sans,12"' % (420 * len(panels)), 'set output "%s.svg"' % path,
                 'set multiplot layout 1,%d' % len(panels), 'set logscale x 2', 'set yrange [40:100]',
                 'set xlabel "frames"', 'set ylabel "95 % intervals that hold the truth, %"', 'set key bottom right']
        for panel in panels:
            words += ['set title "%s"' % os.path.basename(panel).replace('_', ' '), 'plot 95 dt 2 lc "black" notitle, '
                      'for [i=2:%d] "%s.dat" using 1:i with linespoints pt 7 ps .4 title columnheader(i)' % (
                          len(self.claimed) + 1, panel)]
        try:
            subprocess.run(['gnuplot', '-e', '; '.join(words)], check=True)
        except FileNotFoundError:
            print('no gnuplot here: the numbers of the figure are in %s.dat' % path)

    def holds(self):
        """The short draw of the tests: 95 % less three standard deviations of the number of runs, for every metric."""
        good = True
        for m in self.claimed:
            shares = self.by_run([m], 'inside')
            deviation = math.sqrt(.95 * .05 / len(shares)) if shares else 0
            intervals = sum(len(c.intervals) for k in self.late for c in self.cells(m, k))
            held = bool(shares) and statistics.mean(shares) >= .95 - 3 * deviation
            good = good and held
            print('%s %s: %.1f %% of %d intervals of %d runs hold the truth; standard deviation (of runs): %.1f %%' % (
                'ok' if held else 'FAILS', m, 100 * statistics.mean(shares) if shares else 0, intervals, len(shares),
                100 * deviation))
        return good
