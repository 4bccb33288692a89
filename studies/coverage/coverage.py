#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# How often the intervals of vcmetrics -ci 95 hold the truth.  Frames of each scene and seed are traced once and kept;
# ptaccum | vcmetrics measures them, and again under another -label when the method has changed.  The truth for odd
# seeds is the merged picture of all even ones and the other way round: no run is judged by its own frames.
import argparse, os, re, statistics, subprocess, sys
import judge, scenes
from report import Report, rate

PLAIN = 'Ev,Lavg,DGP,UGR,DGI,Lveil,RAMMG,desk.TAL,CR,VCP,UGP,CGI,DGR,Lmed'
METRICS = 'Ev,Lavg,DGPu,UGRu,DGIu,Lveilu,RAMMGu,desk.TAL,CRu,VCPu,UGPu,CGIu,DGRu,Lmed'
FILLED = ',DGPf,UGRf'  # with -moments
BOUND, CLASSES = .4, ('perceptible', 'disturbing')  # of DGP, and what lies below and above it
DISTANCES = [.001, .002, .004]                      # of the true DGP from that bound


def options():
    p = argparse.ArgumentParser(description='coverage of the intervals of vcmetrics')
    p.add_argument('-bin', required=True, help='the built programs')
    p.add_argument('-out', required=True, help='where everything is kept')
    p.add_argument('-scenes', default='1000-1011', help='draws of make_room.py, office, blinds, classroom, gallery')
    p.add_argument('-seeds', type=int, default=200)
    p.add_argument('-first', type=int, default=1, help='the first seed')
    p.add_argument('-size', type=int, default=48, help='pixels a side')
    p.add_argument('-frames', type=int, default=74, help='diffuse frames of a run')
    p.add_argument('-moments', action='store_true', help='keep the moments of pixels: DGPf and UGRf are judged, too')
    p.add_argument('-measure', help='ptaccum and vcmetrics of another build')
    p.add_argument('-label', default='now', help='a name for how it is measured')
    p.add_argument('-beside', help='another label, judged before, in the figure')
    p.add_argument('-ci', default='95', help='percent')
    p.add_argument('-through', choices=['stream', 'batches', 'merge'], default='stream',
                   help='intervals of the stream, of a file with batches, or of the merged files of two seeds')
    p.add_argument('-least', type=int, default=16, help='fewest frames at which -until may stop')
    p.add_argument('-truth', help='recorded values (of record) in place of those of the other seeds')
    p.add_argument('-do', default='trace,truth,measure,judge', help='also: record, classes, check')
    return p.parse_args()


def make(file, words, folder=None, source=None):
    """A file from the output of a program, whole or not at all."""
    if not os.path.exists(file):
        with open(file + '.part', 'wb') as out:
            subprocess.run(words, stdout=out, stdin=source, cwd=folder, check=True)
        os.rename(file + '.part', file)


class Study:
    """One scene.  The methods that -do names make what is not there yet."""

    def __init__(self, o, name):
        self.o, self.name = o, name
        self.folder, self.words, self.regions = scenes.prepare(name, os.path.abspath(o.out))
        self.kept = os.path.join(os.path.abspath(o.out), name, str(o.size) + ('f' if o.moments else ''))
        self.tables = os.path.join(self.kept, o.label)
        self.bin, self.measuring = [os.path.abspath(folder) for folder in (o.bin, o.measure or o.bin)]
        self.seeds = range(o.first, o.first + o.seeds)
        os.makedirs(self.tables, exist_ok=True)

    def stream(self, seed):
        return os.path.join(self.kept, '%d.lux' % seed)

    def trace(self):
        for seed in self.seeds:
            # without moments: -until class is judged by noise alone
            words = '-w- -n 1 -ab 5 -moments%s -x %d -y %d -seed %d -frames %d' % (
                '+' if self.o.moments else '-', self.o.size, self.o.size, seed, self.o.frames + 1)
            make(self.stream(seed), [os.path.join(self.bin, 'ptrace')] + words.split() + self.words, self.folder)

    def vcmetrics(self, metrics, *words):
        metrics += FILLED if self.o.moments else ''
        return [os.path.join(self.measuring, 'vcmetrics'), '-W-', '-regions', self.regions, '-cr', 'pair=low/high',
                '-metrics', metrics] + list(words)

    def from_sums(self, seed, run):
        """run(what ptaccum makes of the frames of a seed)."""
        with open(self.stream(seed)) as frames:
            sums = subprocess.Popen([os.path.join(self.measuring, 'ptaccum')], stdin=frames, stdout=subprocess.PIPE,
                                    stderr=subprocess.DEVNULL)
            result = run(sums.stdout)
            sums.stdout.close()
            sums.wait()
        return result

    def measure(self):
        for seed in self.seeds:
            file = os.path.join(self.tables, '%d.tsv' % seed)
            words = self.vcmetrics(METRICS, '-ci', self.o.ci)
            if self.o.through == 'stream':
                self.from_sums(seed, lambda sums: make(file, words, source=sums))
            elif not os.path.exists(file):
                batches = self.batches(seed)
                make(file, words + [batches])
                os.remove(batches)

    def batches(self, seed):
        """A file with batches; with -through merge, of the frames of this seed and of the next one of like parity."""
        if self.o.through == 'batches':
            return self.accumulate('batches', [self.stream(seed)], '-batches', '16')
        files = [self.accumulate('batches%d' % s, [self.stream(s)], '-batches', '16') for s in (seed, seed + 2)]
        merged = self.accumulate('batches', files)
        for file in files:
            os.remove(file)
        return merged

    def truth(self):
        """Tables of the merged pictures of all even and all odd seeds there are (first line) and of parts of them."""
        there = [int(f[:-4]) for f in os.listdir(self.kept) if f.endswith('.lux')]
        for parity in 0, 1:
            seeds = sorted(s for s in there if s % 2 == parity)
            name = 'truth%d_%d' % (parity, len(seeds))
            table = os.path.join(self.kept, name + '.tsv')
            if os.path.exists(table):
                continue
            sums = [self.accumulate('sum%d' % seed, [self.stream(seed)]) for seed in seeds]
            parts = [self.accumulate('%s_%d' % (name, k), sums[k::judge.PARTS]) for k in range(judge.PARTS)]
            make(table, self.vcmetrics(PLAIN, self.accumulate(name, parts), *parts))
            for file in sums:
                os.remove(file)

    def accumulate(self, name, files, *words):
        """The sum of a stream of frames, or of the sums of several seeds."""
        out = os.path.join(self.kept, name + '.exr')
        if not os.path.exists(out):
            subprocess.run([os.path.join(self.bin, 'ptaccum'), '-last', *words, '-o', out] + files, check=True)
        return out

    def truths(self):
        return judge.recorded_truths(self.o.truth, self.name) if self.o.truth else judge.truths(self.kept)

    def found(self):
        tables = {s: os.path.join(self.tables, '%d.tsv' % s) for s in self.seeds}
        of_files = self.o.frames * (2 if self.o.through == 'merge' else 1)
        return judge.Scene(tables, self.truths(), None if self.o.through == 'stream' else of_files)

    def record(self):
        even, odd = self.truths()
        for m in even:
            print('%s\t%s\t%.7g\t%.2g' % (self.name, m, (even[m][0] + odd[m][0]) / 2, max(even[m][1], odd[m][1])))

    def class_stop(self, seed, distance):
        """Frames, and whether the class is right, of -until class where the true DGP lies at a distance from a bound:
        below it for odd seeds, above it for even ones, by DGP's constant c3."""
        above = seed % 2 == 0
        shift = BOUND + (distance if above else -distance) - self.truths()[seed % 2]['DGP'][0]
        words = self.vcmetrics('DGP', '-w', '2', '1', '1.87', '2', '1', '5.87e-5', '.0918', '%.7f' % (.16 + shift),
                               '-until', 'class')
        words.remove('-W-')
        say = self.from_sums(seed, lambda sums: subprocess.run(words, stdin=sums, stdout=subprocess.DEVNULL,
                                                               stderr=subprocess.PIPE, text=True).stderr)
        stopped = re.search(r'stopped after (\d+) frames: glare is (\w+)', say)
        return (int(stopped[1]), stopped[2] == CLASSES[above]) if stopped else None


def judge_classes(o, studies):
    print('-until class\ndistance\truns\tstops\twrong, % of stops\tframes (median of runs; > where it did not stop)')
    for distance in DISTANCES:
        runs = [s.class_stop(seed, distance) for s in studies if s.truths()[0]['DGP'][0] < .9 for seed in s.seeds]
        stops = [r for r in runs if r]
        middle = statistics.median_low([r[0] if r else o.frames + 1 for r in runs])
        print('%g\t%d\t%d\t%s\t%s' % (distance, len(runs), len(stops), rate([not right for _, right in stops]),
                                      middle if middle <= o.frames else '> %d' % o.frames))


def main():
    o = options()
    studies = [Study(o, name) for name in scenes.names(o.scenes)]
    good = True
    for step in o.do.split(','):
        if step in ('judge', 'check'):
            report = Report({s.name: s.found() for s in studies}, '%s: %d scenes, %d seeds, %d x %d' % (
                o.label, len(studies), o.seeds, o.size, o.size))
        if step == 'judge':
            report.print_all(o.least)
            path = os.path.join(o.out, '%s_%d')
            report.write_cells(path % (o.label, o.size) + '.tsv')
            if o.through == 'stream':
                report.draw(path % (o.label, o.size), o.beside and path % (o.beside, o.size))
        elif step == 'check':
            good = report.holds()
        elif step == 'classes':
            judge_classes(o, studies)
        else:
            for s in studies:
                getattr(s, step)()
    sys.exit(0 if good else 1)


if __name__ == '__main__':
    main()
