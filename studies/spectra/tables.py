# SPDX-License-Identifier: BSD-3-Clause
# The tables of lib/spectrum from the CIE's data sets, as luxpy (pip download luxpy; unzip) brings them, and the basis
# spectra of RADIANCE's primaries by the method of Mallett and Yuksel (2019).  Needs numpy and scipy.
#     python3 studies/spectra/tables.py LUXPY lib/spectrum
import sys

import numpy as np
from scipy.optimize import lsq_linear

luxpy, out = sys.argv[1] + '/', sys.argv[2] + '/'
nm = np.arange(380, 781)


def table(path, columns):
    """The numeric rows of a file: wavelength, then columns; 380 to 780 nm, no value is 0."""
    rows = []
    for line in open(luxpy + path):
        words = line.replace('\t', ' ').split(',')
        try:
            rows.append([float(w) if w.strip() not in ('', 'nan') else 0 for w in words])
        except ValueError:
            continue
    rows = np.array([r for r in rows if 380 <= r[0] <= 780])
    return rows[:, columns]


def written(values, digits):
    text = f'{values:.{digits}g}' if values else '0'
    if 'e' not in text:
        return text[1:] if text.startswith('0.') else text
    mantissa, power = text.split('e')
    return f'{mantissa}e{int(power)}'


def array(f, name, values, digits):
    f.write(f'const double {name}[{len(values)}] = {{\n')
    line = '   '
    for v in values:
        word = f' {written(v, digits)},'
        if len(line) + len(word) > 120:
            f.write(line + '\n')
            line = '   '
        line += word
    f.write(line + '\n};\n')


def source(name, licence, comment, tables):
    with open(out + name, 'w') as f:
        f.write(f'// SPDX-License-Identifier: {licence}\n')
        for line in comment:
            f.write(f'// {line}\n')
        f.write('#include "spectrum/tables.h"\n\nnamespace spectrum {\n\n// clang-format off\n')
        for name, values, digits in tables:
            array(f, name, values, digits)
        f.write('// clang-format on\n\n}  // namespace spectrum\n')


observer = table('data/cmfs/ciexyz_1931_2.dat', [1, 2, 3])
actions = table('toolboxes/photbiochem/data/S026_Table2_Data_downloaded_04062025.csv', [1, 2, 3, 4, 5])
cie = ['International Commission on Illumination (CIE), licensed CC BY-SA 4.0, https://cie.co.at/data-tables .']
source('cie_actions.cpp', 'CC-BY-SA-4.0',
       ['Action spectra of CIE S 026:2018, Table 2 (doi 10.25039/CIE.DS.vqqhzp5a), and V of the 1931 observer (doi',
        '10.25039/CIE.DS.xvudnb9b), 380 to 780 nm by 1 nm.'] + cie +
       ['Changed: no value is 0; written by studies/spectra/tables.py as C++.'],
       [(f'action_{n}', actions[:, k], 6) for k, n in enumerate(['sc', 'mc', 'lc', 'rh', 'mel'])] +
       [('action_v', observer[:, 1], 7)])

fluorescent = table('data/spds/CIE_F_1to12_1nm.csv', [2, 7, 11, 12])
led = table('data/spds/CIE_LED_B1toB5_BH1_RGB1_V1_V2.csv', range(1, 10))[::5]
daylight = table('data/spds/S0123_daylight_phase_5nm.csv', [1, 2, 3])
names = ['b1', 'b2', 'b3', 'b4', 'b5', 'bh1', 'rgb1', 'v1', 'v2']
source('cie_lights.cpp', 'CC-BY-SA-4.0',
       ['Relative spectra of illuminants of CIE 15:2018: components of daylight by 5 nm, fluorescent lamps by 1 nm,',
        'LED lamps by 5 nm; 380 to 780 nm.'] + cie +
       ['Changed: every fifth value of the LED lamps; written by studies/spectra/tables.py as C++.'],
       [(f'daylight_s{k}', daylight[:, k], 6) for k in range(3)] +
       [(f'light_f{n}', fluorescent[:, k], 6) for k, n in enumerate([2, 7, 11, 12])] +
       [(f'light_led_{n}', led[:, k], 5) for k, n in enumerate(names)])

# The smoothest three spectra that sum to 1 everywhere, lie in 0 to 1 and have the colours (1 0 0), (0 1 0), (0 0 1) in
# lib/cal/spectrum.cpp's fold.
to_rgb = np.array([[2.5653, -1.1668, -.3984], [-1.0221, 1.9783, .0438], [.0747, -.2519, 1.1772]])
middle, n = np.arange(380.5, 780), 81
xyz = np.array([np.interp(middle, nm[::10], observer[::10, k]) for k in range(3)])
fold = to_rgb @ (xyz / xyz.sum(axis=1, keepdims=True)) / to_rgb.sum(axis=1, keepdims=True)
fold = fold @ np.array([np.interp(middle, nm[::5], e) for e in np.eye(n)]).T
slope, exactly = np.eye(n)[1:] - np.eye(n)[:-1], 3e3
rows = [np.kron(np.eye(3), slope), exactly * np.kron(np.ones((1, 3)), np.eye(n)), exactly * np.kron(np.eye(3), fold)]
right = np.concatenate([np.zeros(3 * (n - 1)), exactly * np.ones(n), exactly * np.eye(3).ravel()])
basis = lsq_linear(np.vstack(rows), right, bounds=(0, 1), method='bvls', max_iter=2000).x.reshape(3, n)
basis = np.clip(basis, 0, 1).round(5)
basis[1] = (1 - basis[0] - basis[2]).round(5)
print('RGB of the basis spectra:', (fold @ basis.T).round(5).tolist())
source('primaries.cpp', 'BSD-3-Clause',
       ["Reflectances whose colours are RADIANCE's R and B alone, 380 to 780 nm by 5 nm; that of G is 1 less their",
        'sum.',
        'Written by studies/spectra/tables.py.'],
       [('primary_red', basis[0], 5), ('primary_blue', basis[2], 5)])
