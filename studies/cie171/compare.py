#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""compare.py values.tsv: another program's values beside the derived ones.  values.tsv has the columns case, point,
sky (- where
there is none) and value, as in studies/cie171/results.tsv; rows that are missing are left out.  Prints the
differences in percent, then
the largest and the root mean square of each case."""

import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def table(path):
    """Rows as dictionaries; lines that begin with # apart, as a dictionary of their words."""
    facts, rows, head = {}, [], None
    with open(path) as f:
        for line in f:
            cells = line.rstrip("\n").split("\t")
            if line.startswith("# "):
                facts[cells[0][2:]] = "\t".join(cells[1:])
            elif head is None:
                head = cells
            elif len(cells) == len(head):
                rows.append(dict(zip(head, cells)))
            else:
                sys.exit("%s: a row of %d cells, not %d: %s" % (path, len(cells), len(head), line.strip()[:60]))
    return facts, rows


def main(path):
    derived = {
        (r["case"], r["point"], r["sky"]): float(r["value"]) for r in table(os.path.join(HERE, "reference.tsv"))[1]
    }
    rows = table(path)[1]
    if not rows or not {"case", "point", "sky", "value"} <= set(rows[0]):
        sys.exit("compare.py: %s: has no columns case, point, sky and value" % path)
    cases = {}
    print("case\tpoint\tsky\tderived\tvalue\tpercent")
    for r in rows:
        key = r["case"], r["point"], r["sky"]
        if key not in derived:
            sys.exit("compare.py: %s: no such value: %s" % (path, " ".join(key)))
        true, value = derived[key], float(r["value"])
        percent = 100 * (value / true - 1) if true else (0.0 if value == 0 else math.inf)
        cases.setdefault(key[0], []).append(percent)
        print("%s\t%s\t%s\t%.6g\t%.6g\t%.3f" % (*key, true, value, percent))
    print("\ncase\tvalues\tlargest\trms")
    for case, d in cases.items():
        print("%s\t%d\t%.3f\t%.3f" % (case, len(d), max(d, key=abs), math.sqrt(math.fsum(x * x for x in d) / len(d))))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
