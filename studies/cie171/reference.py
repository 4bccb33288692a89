#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""reference.py: the derived values of all cases as a table: case, point, sky, value, and by how much the value
moves when the
quadrature has twice the cells along each axis."""

import sys

from variants import CASES


def rows(cases=CASES, per=3.0, refine=True):
    for case in cases:
        for name, (point, normal) in case.sensors.items():
            values = case.reference(point, normal, per)
            finer = case.reference(point, normal, 2 * per) if refine else values
            for sky, (v, f) in enumerate(zip(values, finer), 1):
                yield case.number, name, str(sky) if case.skies else "-", f, abs(v / f - 1) if f else abs(v)


if __name__ == "__main__":
    print("# derived values of CIE 171:2006; python3 studies/cie171/reference.py")
    print("case\tpoint\tsky\tvalue\tmoved")
    wanted = [c for c in CASES if not sys.argv[1:] or any(c.number.startswith(a) for a in sys.argv[1:])]
    for case, point, sky, value, moved in rows(wanted):
        print("%s\t%s\t%s\t%.7g\t%.1e" % (case, point, sky, value, moved))
