# SPDX-License-Identifier: BSD-3-Clause
# The errors of cases.py on cases by which no band was placed: 1,269 Munsell samples and the 210 of CRI2012, behind no
# glass, the CIE's measured window glass and a blue electrochromic one of another band, under the 211 measured lamps of
# TM-30's library and daylight of 5000 to 20000 K.
#     python3 studies/spectra/others.py LUXPY
import csv

import numpy as np

from cases import actions, column, d65, daylight, luxpy, nm, ranges

KINDS = {'Fluorescent Broadband': 'fluorescent', 'Fluorescent Narrowband': 'fluorescent', 'LED Phosphor': 'LED',
         'LED Mixed': 'LED', 'LED Hybrid': 'LED', 'Incandescent/Filament': 'incandescent',
         'High Intensity Discharge': 'discharge', 'Other': 'LED'}


def lamps():
    """name, kind, spectrum: of those that were measured."""
    spectra = column('data/spds/IESTM30_15_Sspds.dat', range(1, 319))
    with open(luxpy + 'data/spds/IESTM30_15_Sinfo.txt') as f:
        rows = list(csv.reader(f))[1:]
    for (_, name, kind, category, *_), s in zip(rows, spectra):
        if category == 'Commercial':
            yield name.strip(), KINDS[kind], s


walls = np.vstack([column('data/rfls/Munsell1269.dat', range(1, 1270)),
                   column('data/rfls/CRI2012_R210.dat', range(1, 211))])
glasses = {'none': np.ones(401), 'window': column('data/rfls/GlassSpecTrans_indoor_illuminants.csv', 1)[0],
           'blue': .04 + .5 * np.exp(-.5 * ((nm - 475) / 55) ** 2)}
lights = list(lamps()) + [(f'{k} K', 'daylight', daylight(k)) for k in (5000, 5500, 7500, 10000, 20000)]


def errors(action, count):
    """kind -> errors in %, light by glass by wall."""
    (begin, end), weight = ranges[action], actions[action]
    limits = np.concatenate([[379.5], begin + (end - begin) * np.arange(1, count) / count, [780.5]])
    light = np.array([s for _, _, s in lights])
    found = []
    for glass in glasses.values():
        truth, value = (light * weight * glass) @ walls.T, 0
        for a, b in zip(limits, limits[1:]):
            share = np.clip(np.minimum(b, nm + .5) - np.maximum(a, nm - .5), 0, None)
            mean = weight * d65 * share
            mean /= mean.sum()
            value = value + np.outer(light @ (weight * share) * (mean @ glass), walls @ mean)
        found.append(np.abs(100 * (value / truth - 1)))
    return np.stack(found, 1)


def main():
    assert len(lights) == 216 and not np.isnan(walls).any()
    kinds = np.array([kind for _, kind, _ in lights])
    print('action\tbands\tlight\tlamps\tcases\tmedian\t95 %\tlargest\tof')
    several = (3, 6, 9, 12, 15)
    for action, counts in [('mel', several), ('V', several), ('rh', (9,)), ('sc', (9,)), ('mc', (9,)), ('lc', (9,))]:
        for count in counts:
            e = errors(action, count)
            for kind in ['all'] + (sorted(set(kinds)) if (action, count) in (('mel', 9), ('V', 12)) else []):
                of = np.flatnonzero((kinds == kind) | (kind == 'all'))
                part = e[of]
                i, g, w = np.unravel_index(part.argmax(), part.shape)
                numbers = f'{np.median(part):.2f}\t{np.percentile(part, 95):.2f}\t{part.max():.1f}'
                print(f'{action}\t{count}\t{kind}\t{len(of)}\t{part.size}\t{numbers}\t'
                      f'wall {w + 1}, glass {list(glasses)[g]}, {lights[of[i]][0]}')


if __name__ == '__main__':
    main()
