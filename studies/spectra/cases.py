# SPDX-License-Identifier: BSD-3-Clause
# What bands leave out: a wall of each CIE and TM-30 sample behind three glasses under seven lights, by bands and by the
# product of the three spectra by 1 nm.  LUXPY as for tables.py; needs numpy.
#     python3 studies/spectra/cases.py LUXPY
import sys

import numpy as np

luxpy = sys.argv[1] + '/'
nm = np.arange(380, 781)


def column(path, k, step=','):
    rows = []
    for line in open(luxpy + path):
        try:
            rows.append([float(w) if w.strip() not in ('', 'nan') else 0 for w in line.replace('\t', ' ').split(step)])
        except ValueError:
            continue
    rows = np.array(rows)
    return np.array([np.interp(nm, rows[:, 0], rows[:, i]) for i in np.atleast_1d(k)])


def planck(kelvin):
    return nm ** -5. / np.expm1(1.4388e7 / nm / kelvin)


action = column('toolboxes/photbiochem/data/S026_Table2_Data_downloaded_04062025.csv', range(1, 6))
actions = dict(zip(['sc', 'mc', 'lc', 'rh', 'mel'], action), V=column('data/cmfs/ciexyz_1931_2.dat', 2)[0])
d65 = column('data/spds/CIE_D65.csv', 1)[0]
s0, s1, s2 = column('data/spds/S0123_daylight_phase_5nm.csv', [1, 2, 3])


def daylight(kelvin):
    x = (-4.6070e9 / kelvin ** 3 + 2.9678e6 / kelvin ** 2 + 99.11 / kelvin + .244063 if kelvin <= 7000 else
         -2.0064e9 / kelvin ** 3 + 1.9018e6 / kelvin ** 2 + 247.48 / kelvin + .237040)
    y = -3 * x * x + 2.87 * x - .275
    m = .0241 + .2562 * x - .7341 * y
    return s0 + (-1.3515 - 1.7703 * x + 5.9114 * y) / m * s1 + (.03 - 31.4424 * x + 30.0717 * y) / m * s2


led = 'data/spds/CIE_LED_B1toB5_BH1_RGB1_V1_V2.csv'
lights = {'D65': d65, 'north sky, 12000 K': s0 + 1.495 * s1 + .045 * s2, 'A': planck(2855.5),
          'F11': column('data/spds/CIE_F_1to12_1nm.csv', 11)[0], 'LED-B3': column(led, 3)[0],
          'LED-B1': column(led, 1)[0], 'LED-V1': column(led, 8)[0]}
glasses = {'none': np.ones(401), 'clear': .88 - .05 * ((nm - 550) / 230) ** 2,
           'blue': .05 + .55 * np.exp(-.5 * ((nm - 460) / 45) ** 2)}
samples = np.vstack([column('data/rfls/CIE_13_3_1995_R14.dat', range(1, 15)),
                     column('data/rfls/IESTM30_18_R99_1nm.dat', range(1, 100))])


def errors(weight, begin, end, count):
    """Errors in %, and what they are of."""
    limits = np.concatenate([[379.5], begin + (end - begin) * np.arange(1, count) / count, [780.5]])
    shares = [np.clip(np.minimum(b, nm + .5) - np.maximum(a, nm - .5), 0, None) for a, b in zip(limits, limits[1:])]
    for name, light in lights.items():
        for pane, glass in glasses.items():
            truth, value = (light * weight * glass * samples).sum(1), 0
            for share in shares:
                mean = weight * d65 * share
                mean /= mean.sum()
                value = value + (light * weight * share).sum() * (mean @ glass) * (samples @ mean)
            for k, e in enumerate(100 * (value / truth - 1)):
                yield abs(e), f'sample {k + 1}, glass {pane}, {name}'


ranges = {'mel': (410, 580), 'rh': (420, 590), 'sc': (410, 520), 'mc': (460, 630), 'lc': (450, 640), 'V': (460, 660)}


def main():
    print('action\tbands\tcases\tmedian\t95 %\tlargest\tof')
    for name, (begin, end) in ranges.items():
        for count in (3, 6, 9, 12, 15):
            all_of = sorted(errors(actions[name], begin, end, count))
            size = [e for e, _ in all_of]
            print(f'{name}\t{count}\t{len(size)}\t{np.median(size):.2f}\t{np.percentile(size, 95):.2f}\t'
                  f'{size[-1]:.1f}\t{all_of[-1][1]}')


if __name__ == '__main__':
    main()
