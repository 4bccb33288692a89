# SPDX-License-Identifier: BSD-3-Clause
# Where the error of a room's illuminance by an action comes from, each part alone: bands, spectra made of RGB, the
# colour of daylight.
# A room is light times glass times .3 + R/(1 - R), R the mean reflectance of five grey surfaces (.6) and a wall of one
# of the samples of the CIE and of TM-30.
#     python3 studies/spectra/rooms.py LUXPY lib/spectrum/primaries.cpp
import re
import sys

import numpy as np

import cases
from cases import actions, d65, daylight, glasses, lights, nm, ranges, samples

mel, by_v = actions['mel'], actions['V']
red, blue = (np.interp(nm, nm[::5], [float(w) for w in block.split(',') if w.strip()])
             for block in re.findall(r'\[81\] = {([^}]*)}', open(sys.argv[2]).read()))
observer = cases.column('data/cmfs/ciexyz_1931_2.dat', [1, 2, 3])
to_rgb = np.array([[2.5653, -1.1668, -.3984], [-1.0221, 1.9783, .0438], [.0747, -.2519, 1.1772]])
fold = to_rgb @ (observer / observer.sum(1, keepdims=True)) / to_rgb.sum(1, keepdims=True)


def of_rgb(s):
    """The smooth spectrum of a reflectance's RGB, which is moved into the triangle of the primaries."""
    rgb = fold @ s
    y = np.array([.265, .670, .065]) @ rgb
    if rgb.min() < 0:
        rgb = y + (rgb - y) * y / (y - rgb.min())
    return rgb[1] + (rgb[0] - rgb[1]) * red + (rgb[2] - rgb[1]) * blue


def room(wall):
    mean = .5 + wall / 6
    return .3 + mean / (1 - mean)


def banded(light, glass, wall, name, count):
    begin, end = ranges[name]
    limits = np.concatenate([[379.5], begin + (end - begin) * np.arange(1, count) / count, [780.5]])
    value, weight = 0, actions[name]
    for a, b in zip(limits, limits[1:]):
        share = np.clip(np.minimum(b, nm + .5) - np.maximum(a, nm - .5), 0, None)
        mean = weight * d65 * share
        mean /= mean.sum()
        value += (light * weight * share).sum() * (mean @ glass) * room(mean @ wall)
    return value


def ratio(light):
    return light @ mel / (light @ by_v) / (d65 @ mel / (d65 @ by_v))


def row(name, errors):
    size = np.abs(errors)
    print(f'{name}\t{np.median(size):.2f}\t{np.percentile(size, 95):.2f}\t{size.max():.1f}')


print('error of\tmedian\t95 %\tlargest')
days, lamps = ['D65', 'north sky, 12000 K'], ['A', 'F11', 'LED-B3', 'LED-B1', 'LED-V1']
for kind, names, panes in [('daylight', days, ['none', 'clear']), ('behind blue glass', days, ['blue']),
                           ('lamps', lamps, ['none'])]:
    found = {part: [] for part in ['EDI, 9 bands', 'EDI, walls of RGB', 'EDI, glass of RGB', 'Ev by V, 12 bands',
                                   'Ev by V, walls of RGB']}
    for light in (lights[n] for n in names):
        for glass in (glasses[p] for p in panes):
            for wall in samples:
                truth, truth_v = (light * glass * room(wall)) @ mel, (light * glass * room(wall)) @ by_v
                smooth = of_rgb(wall)
                for part, value in zip(found, [
                        banded(light, glass, wall, 'mel', 9) / truth, (light * glass * room(smooth)) @ mel / truth,
                        (light * of_rgb(glass) * room(wall)) @ mel / truth,
                        banded(light, glass, wall, 'V', 12) / truth_v,
                        (light * glass * room(smooth)) @ by_v / truth_v]):
                    found[part].append(100 * (value - 1))
    for part, errors in found.items():
        row(f'{kind}: {part}', errors)
print('light taken for D65\tmEDI, %')
for name, light in [(f'{k} K', daylight(k)) for k in (5000, 5500, 6000, 7500, 10000, 15000)] + \
        [(n, lights[n]) for n in lamps]:
    print(f'{name}\t{100 * (1 / ratio(light) - 1):+.1f}')
