# SPDX-License-Identifier: BSD-3-Clause
# Illuminance and melanopic EDI at an eye in five rooms: by ptrace with nine bands of mel and twelve of V, by ptrace
# with many narrow bands, and by RADIANCE's rtrace -cs 20 (6.0 or later, on PATH, with RAYPATH), whose melanopic value
# is converted by that of D65.  LUXPY as for tables.py; needs numpy.
#     python3 studies/spectra/radiance.py LUXPY build/bin out/radiance > studies/spectra/radiance.tsv
import os
import subprocess
import sys

import numpy as np

from cases import actions, column, d65, lights, nm, samples

BIN, OUT = os.path.abspath(sys.argv[2]), os.path.abspath(sys.argv[3])
RUNS, RAYS = 4, 64  # of ptrace, of rtrace
PARTS = {'mel': [379, 470, 505, 780], 'V': [379, 530, 580, 780]}  # nm: each in three actions of 15 bands
tint = {'blue': .05 + .55 * np.exp(-.5 * ((nm - 460) / 45) ** 2), 'clear': .9 - .05 * ((nm - 550) / 230) ** 2,
        'green': .15 + .6 * np.exp(-.5 * ((nm - 535) / 60) ** 2)}


def face(name, material, *points):
    return f'{material} polygon {name} 0 0 12 ' + ' '.join('%g' % x for p in points for x in p) + '\n'


def room(back, side, pane, sky='', panel=''):
    """Two walls of samples (R9 is red, R11 green, R12 blue), the others, floor and ceiling grey."""
    faces = [
        ('grey', 'floor', (0, 0, 0), (4, 0, 0), (4, 5, 0), (0, 5, 0)),
        ('white', 'ceiling', (0, 0, 3), (0, 5, 3), (4, 5, 3), (4, 0, 3)),
        ('back', 'back', (0, 5, 0), (4, 5, 0), (4, 5, 3), (0, 5, 3)),
        ('side', 'side', (0, 0, 0), (0, 5, 0), (0, 5, 3), (0, 0, 3)),
        ('white', 'other', (4, 0, 0), (4, 0, 3), (4, 5, 3), (4, 5, 0)),
        ('white', 'left', (0, 0, 0), (0, 0, 3), (1, 0, 3), (1, 0, 0)),
        ('white', 'right', (3, 0, 0), (3, 0, 3), (4, 0, 3), (4, 0, 0)),
        ('white', 'sill', (1, 0, 0), (1, 0, .8), (3, 0, .8), (3, 0, 0)),
        ('white', 'head', (1, 0, 2.4), (1, 0, 3), (3, 0, 3), (3, 0, 2.4))]
    text = 'void plastic grey 0 0 5 .3 .3 .3 0 0\nvoid plastic white 0 0 5 .7 .7 .7 0 0\n'
    for name, k in (('back', back), ('side', side)):
        text += spectrum(f'{name}_s', samples[k - 1]) + f'{name}_s plastic {name} 0 0 5 1 1 1 0 0\n'
    text += spectrum('pane_s', tint[pane]) + 'pane_s glass pane 0 0 3 1 1 1\n'
    text += face('window', 'pane', (1, 0, .8), (1, 0, 2.4), (3, 0, 2.4), (3, 0, .8))
    if sky in lights:
        text += spectrum('sky_s', lights[sky] / lights[sky][180]) + 'sky_s glow sky_glow 0 0 4 20 20 20 0\n' \
            'sky_glow source sky 0 0 4 0 0 1 180\nsky_glow source ground 0 0 4 0 0 -1 180\n'
    elif sky:
        text += subprocess.run('genssky ' + sky, shell=True, cwd=OUT, capture_output=True, text=True).stdout + \
            'skyfunc glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 0 1 180\n'
    if panel:
        text += spectrum('panel_s', lights[panel] / lights[panel][180]) + 'panel_s light panel 0 0 3 30 30 30\n' + \
            face('lamp', 'panel', (1.5, 2, 2.99), (1.5, 3.5, 2.99), (2.5, 3.5, 2.99), (2.5, 2, 2.99))
    return text + ''.join(face(name, m, *points) for m, name, *points in faces)


def spectrum(name, s):
    with open(os.path.join(OUT, name + '.dat'), 'w') as f:
        f.write('1\n380 780 401\n' + '\n'.join('%.6g' % v for v in s) + '\n')
    return f'void specfile {name} 1 {name}.dat 0 0\n'


def rtrace(rays, words):
    command = f'rtrace -h -I -u+ -cs 20 -cw 380 780 {words} scene.oct'
    lines = subprocess.run(command, shell=True, cwd=OUT, input=rays, capture_output=True, text=True, check=True).stdout
    return np.array([line.split() for line in lines.strip().split('\n')], float)


def octree(text):
    with open(os.path.join(OUT, 'scene.rad'), 'w') as f:
        f.write(text)
    subprocess.run('oconv -w scene.rad > scene.oct', shell=True, cwd=OUT, check=True)


def weights():
    """What RADIANCE's -pM and -pY take of each of its 20 bands, by skies that have little else."""
    bands, values = [], []
    for k in range(20):
        octree('void spectrum s 0 0 22 380 780 ' + ' '.join('1' if i == k else '0' for i in range(20)) +
               '\ns glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 360\n')
        bands.append(rtrace('0 0 0 0 0 1\n', '-ab 1 -ad 64 -co+')[0])
        values.append([rtrace('0 0 0 0 0 1\n', '-ab 1 -ad 64 ' + word)[0, 0] for word in ('-pM', '-pY')])
    return np.linalg.solve(bands, values)


def ptrace(seed, frames, ray, words, columns):
    with open(os.path.join(OUT, 'eye.pts'), 'w') as f:
        f.write(ray)
    command = (f'{BIN}/ptrace -w- -ab 4 -points eye.pts -seed {seed} -frames {frames} {words} scene.rad | '
               f'{BIN}/ptaccum -last -o - | {BIN}/vcmetrics -W- -last -metrics ' + ','.join(columns))
    done = subprocess.run(['bash', '-c', command], cwd=OUT, capture_output=True, text=True, check=True)
    row = dict(zip(*(line.split('\t') for line in done.stdout.split('\n')[:2])))
    return np.array([float(row['eye.' + c]) for c in columns])


def by_many_bands(ray):
    """mEDI and Ev of a short run, by the bands of every run over by many narrow ones: with the same paths."""
    few = ptrace(1, 5, ray, '-action mel -action V', ['mEDI.mean', 'EvV.mean'])
    words, columns = '-bands 15', []
    for name, limits in PARTS.items():
        for k, (a, b) in enumerate(zip(limits, limits[1:])):
            with open(os.path.join(OUT, f'{name}{k}.csv'), 'w') as f:
                f.writelines(f'{n} {w if a < n <= b else 0:.8g}\n' for n, w in zip(nm, actions[name]))
            words += f' -action {name}{k}.csv'
            columns.append(f'E_{name}{k}.mean')
    watts = ptrace(1, 5, ray, words, columns)
    v = 683.002 * watts[3:].sum()
    return few / [683.002 * watts[:3].sum() * (d65 @ actions['V']) / (d65 @ actions['mel']), v]


def main():
    os.makedirs(OUT, exist_ok=True)
    sky_of_mie = '6 21 16 -a 48 -o -11 -m -15'
    rooms = {'blue glass, D65 sky, red wall': (lambda: room(9, 11, 'blue', 'D65'), d65 * tint['blue']),
             'F11 panel, red and blue walls': (lambda: room(9, 12, 'clear', panel='F11'), lights['F11']),
             'LED-B3 panel, blue and yellow walls': (lambda: room(12, 10, 'clear', panel='LED-B3'), lights['LED-B3']),
             'genssky behind clear glass, green wall': (lambda: room(11, 13, 'clear', sky_of_mie), None),
             'lamp A, and a north sky behind green glass':
                 (lambda: room(9, 10, 'green', 'north sky, 12000 K', 'A'), None)}
    m_of, y_of = weights().T

    def m_over_y(s):
        octree(spectrum('s', s / s.max()) + 's glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 360\n')
        bands = rtrace('0 0 0 0 0 1\n', '-ab 1 -ad 64 -co+')[0]
        return bands @ m_of / (bands @ y_of)

    d65_ratio = m_over_y(d65)

    def of_light(s):
        exact = s @ actions['mel'] / (s @ actions['V']) / (d65 @ actions['mel'] / (d65 @ actions['V']))
        return '%+.2f' % (100 * (m_over_y(s) / d65_ratio / exact - 1))

    print('# M over Y of D65: %.4f; M/Y to mDER of lamp A alone %s %%, of daylight of 12000 K %s %%' %
          (d65_ratio, of_light(lights['A']), of_light(lights['north sky, 12000 K'])))
    print('room\tmEDI, lx\tEv, lx\t9 bands, %\tV 12 bands, %\tM to mEDI, %\terror\tY to Ev, %\terror\t'
          'M/Y to mDER, %\terror\tof its light alone, %')
    ray = '2 4 1.2 0 -1 0\n'
    for name, (make, light) in rooms.items():
        alone = '-' if light is None else of_light(light)
        octree(make())
        bands = by_many_bands(ray)
        words, wanted = '-action mel -action V', ['mEDI.mean', 'EvV.mean']
        ours = np.array([ptrace(seed, 33, ray, words, wanted) for seed in range(2, RUNS + 2)]) / bands
        # Each ray has random numbers of its own.
        theirs = rtrace(RAYS * ray, '-co+ -ab 4 -aa 0 -ad 4000 -as 0 -lr 8 -lw 1e-6 -dj 0 -ds .1 -st 0')
        theirs = np.stack([theirs @ m_of / d65_ratio, theirs @ y_of], 1)
        numbers = list(100 * (bands - 1))
        for a, b in ((ours[:, 0], theirs[:, 0]), (ours[:, 1], theirs[:, 1]),
                     (ours[:, 0] / ours[:, 1], theirs[:, 0] / theirs[:, 1])):
            numbers.append(100 * (b.mean() / a.mean() - 1))
            numbers.append(100 * np.hypot(*(x.std(ddof=1) / x.mean() / len(x) ** .5 for x in (a, b))))
        values = ours.mean(0)
        cells = ['%.1f' % v for v in values] + ['%+.2f' % n for n in numbers] + [alone]
        print('\t'.join([name] + cells), flush=True)


if __name__ == '__main__':
    main()
