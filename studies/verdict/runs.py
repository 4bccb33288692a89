# SPDX-License-Identifier: BSD-3-Clause
# Rows of the live page's pipe for many designs, hours and seeds:  runs.py [-size 64] [-seeds 10] [-frames 17] [-jobs 2]
# [-until SECONDS] BIN OUT SCENE ...
#   SCENE: one of SCENES below, whose sky goes through the hours of a day, or a room of studies/coverage by its number.
#   Each run is a design and three edits of it, as the page sends them: the pipe `ptrace | ptaccum -every x2/16 |
#   vcmetrics -against first` sees four pictures with EDIT=0 to 3.  OUT gets its rows with scene, hour and seed; runs
#   that are there are left out, so that a study goes on where it was ended.
import argparse, concurrent.futures, os, re, subprocess, sys, tempfile, time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, '..', 'coverage'))
from make_room import Room
from scenes import names

EXAMPLES = os.path.join(HERE, '..', '..', 'examples', 'scenes')
HOURS = [round(6.5 + k * 11 / 12, 2) for k in range(13)]  # of 21 March
# folder, view, files, and edits: a pattern whose numbers are multiplied by a factor
SCENES = {
    'office': ('office', 'view.vf', 'materials.rad layout.rad', [
        (r'wall_paint\s+0\s+0\s+5', .98), (r'glazing\s+0\s+0\s+3', .6), (r'carpet\s+0\s+0\s+5', 2)]),
    'blind': ('office', 'view.vf', 'materials.rad layout.rad blind.rad', [
        (r'wall_paint\s+0\s+0\s+5', .9), (r'-a', 1.5), (r'-rx', 1.2)]),
    'classroom': ('classroom', 'window.vf', 'materials.rad room.rad furniture.rad outside.rad', [
        (r'linoleum\s+0\s+0\s+5', 1.05), (r'clear_double\s+0\s+0\s+3', .7), (r'plaster\s+0\s+0\s+5', .8)]),
    'gallery': ('gallery', 'east.vf', 'materials.rad room.rad objects.rad', [
        (r'plaster\s+0\s+0\s+5', .98), (r'rooflight\s+0\s+0\s+3', .6), (r'basin_tile\s+0\s+0\s+5', 2)]),
}
ROOM = [(r'wall_finish\s+0\s+0\s+5', .97), (r'pane\s+0\s+0\s+3', .7), (r'floor_finish\s+0\s+0\s+5', 1.6)]


def with_factor(text, pattern, factor):
    """The three numbers (or the one of an option) behind the pattern, each multiplied."""
    count = 1 if pattern.startswith('-') else 3
    number = lambda m: m[1] + ' '.join(f'{float(v) * factor:.5g}' for v in m[2].split())
    rounded = lambda m: f'{m[1]}{round(float(m[2]) * factor)}'
    change = rounded if count == 1 else number
    return re.sub(rf'({pattern}\s+)((?:[\d.]+\s*?){{{count}}})(?=\s)', change, text, count=1)


def designs(scene, hour, folder):
    """The words of ptrace for the design and each of its edits."""
    if scene.isdigit():
        Room(int(scene)).write(folder, int(scene))
        where, view, files, edits, sky = folder, 'view.vf', ['room.rad'], ROOM, os.path.join(folder, 'sky.rad')
    else:
        name, view, files, edits = SCENES[scene]
        where, files, sky = os.path.join(EXAMPLES, name), files.split(), os.path.join(folder, 'sky.rad')
        day = open(os.path.join(EXAMPLES, 'office', 'sky_day.rad')).read()
        open(sky, 'w').write(day.replace('12 21 14 +s', f'3 21 {hour} +s'))
    all = [files]
    for k, (pattern, factor) in enumerate(edits):
        changed = list(files)
        for n, name in enumerate(files):
            text = open(os.path.join(where, name)).read()
            new = with_factor(text, pattern, factor)
            if new == text: continue
            changed[n] = os.path.join(folder, f'edit{k}_{name}')
            open(changed[n], 'w').write(new)
            break
        all.append(changed)
    return where, [['-vf', view, *names, sky] for names in all]


def run(of, scene, hour, seed):
    with tempfile.TemporaryDirectory() as folder:
        where, all = designs(scene, hour, folder)
        stream = b''
        for edit, words in enumerate(all):
            trace = [of.bin + '/ptrace', '-w-', '-x', str(of.size), '-y', str(of.size), '-seed', str(seed),
                     '-frames', str(of.frames)]
            frames = subprocess.run(trace + words, cwd=where, capture_output=True, check=True).stdout
            stream += frames.replace(b'#?RADIANCE\n', b'#?RADIANCE\nEDIT=%d edit\n' % edit)
        pipe = lambda data, *words: subprocess.run(words, input=data, capture_output=True, check=True).stdout
        sums = pipe(stream, of.bin + '/ptaccum', '-every', 'x2/16')
        rows = pipe(sums, of.bin + '/vcmetrics', '-metrics', 'Ev,DGPf', '-ci', '95', '-against', 'first')
        rows = rows.decode().splitlines()
        return [f'{scene}\t{hour}\t{seed}\t{of.size}\t{row}' for row in rows[1:]], rows[0]


def main():
    options = argparse.ArgumentParser()
    for name, default in (('-size', 64), ('-seeds', 10), ('-first', 1), ('-frames', 17), ('-jobs', 2)):
        options.add_argument(name, type=int, default=default)
    options.add_argument('-until', type=float, default=1e9)
    options.add_argument('bin')
    options.add_argument('out')
    options.add_argument('scenes', nargs='+')
    of = options.parse_args()
    of.bin, end = os.path.abspath(of.bin), time.time() + of.until
    done = {tuple(line.split('\t')[:4]) for line in open(of.out)} if os.path.exists(of.out) else set()
    scenes = names(' '.join(of.scenes))
    wanted = [(s, h, seed) for seed in range(of.first, of.first + of.seeds) for h in HOURS for s in scenes
              if not s.isdigit() or h == HOURS[0]]
    wanted = [w for w in wanted if (*map(str, w), str(of.size)) not in done]
    with open(of.out, 'a') as out, concurrent.futures.ThreadPoolExecutor(of.jobs) as pool:
        jobs = {pool.submit(lambda w: run(of, *w) if time.time() < end else None, w): w for w in wanted}
        for job in concurrent.futures.as_completed(jobs):
            try:
                found = job.result()
            except subprocess.CalledProcessError as e:
                print(jobs[job], e.stderr.decode().strip()[:200], file=sys.stderr)
                continue
            if not found: continue
            rows, head = found
            if out.tell() == 0: print(f'scene\thour\tseed\tsize\t{head}', file=out)
            print('\n'.join(rows), file=out, flush=True)


main()
