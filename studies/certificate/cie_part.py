# SPDX-License-Identifier: BSD-3-Clause
"""The page's first part: CIE 171's values, how wide their intervals are, and printed entries that differ (page.py)."""

import math
import os
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "studies", "cie171"))
from compare import table  # noqa: E402

CIE = os.path.join(TOP, "studies", "cie171")
HERE = os.path.join(TOP, "studies", "certificate")


def median(values):
    ordered = sorted(values)
    return (ordered[(len(ordered) - 1) // 2] + ordered[len(ordered) // 2]) / 2


def rms(v):
    return math.sqrt(math.fsum(x * x for x in v) / len(v)) if v else 0.0


def percent_off(r):
    true, value = float(r["derived"]), float(r["value"])
    return 100 * (value / true - 1) if true else 0.0


def markdown_table(head, rows):
    return (
        ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
        + ["| " + " | ".join(r) + " |" for r in rows]
        + [""]
    )


def groups(rows, key):
    found = {}
    for r in rows:
        found.setdefault(r[key], []).append(r)
    return found


def seen_from(r):
    """The least error of a value, in percent of it, that is wrong: 5 standard errors, and what the derivation has."""
    true, half = abs(float(r["derived"])), (float(r["high"]) - float(r["low"])) / 2
    return 100 * (5 * half / 1.96 / true + 1e-4) if true else 0.0


def summary(rows):
    """Cells: values, rms and largest difference in percent, inside, largest number of standard errors, wrong, and the
    error that would be wrong, in the middle value and in the one that is known least."""
    off = [percent_off(r) for r in rows]
    inside = sum(r["verdict"] == "inside" for r in rows)
    seen = [seen_from(r) for r in rows if float(r["derived"])]
    return [
        "%d" % len(rows),
        "%.3f" % rms(off),
        "%+.2f" % max(off, key=abs),
        "%.1f" % (100 * inside / len(rows)),
        "%.1f" % max(float(r["errors"]) for r in rows),
        "%d" % sum(r["verdict"] == "wrong" for r in rows),
        "%.2g to %.2g" % (median(seen), max(seen)) if seen else "-",
    ]


HEAD = ["values", "rms, %", "largest, %", "inside, %", "standard errors, at most", "wrong", "would be seen from, %"]


def by_sensors(row):
    return row["case"].endswith("sensors")


def inside(rows):
    return "%.1f %%" % (100 * sum(r["verdict"] == "inside" for r in rows) / len(rows))


def machine(facts):
    return facts.get("machine") or "a machine that was not recorded"


def cie_part():
    facts, rows = table(os.path.join(CIE, "results.tsv"))
    derived = table(os.path.join(CIE, "reference.tsv"))[1]
    cases = groups(rows, "case")
    seconds = math.fsum(float(r[0]["seconds"]) for r in cases.values())
    printed = {c.split(",")[0] for c in cases if c.startswith("5.")}
    sensors, others = [r for r in rows if by_sensors(r)], [r for r in rows if not by_sensors(r)]
    coarse = sum(seen_from(r) > 1 for r in rows)
    least = max(rows, key=seen_from)
    lines = [
        "## CIE 171:2006",
        "",
        "The document has %d cases with an analytical answer (5.2 to 5.14).  Here they are %d rows with %d values: the "
        "cases in several sizes and ways of measuring, and, as *6*, tests of ours after its chapter 6.  Each value is "
        "derived from first principles in "
        "`studies/cie171` (the quadrature moves by at most %.0e when its cells are halved), then measured.  A value "
        "is *inside* if its 95 %% interval, widened by .0001 of the value for the derivation, holds the derived one, "
        "and *wrong* if it is more than 5 standard errors away.  Behind a case stands *sensors* where it was measured "
        "by `ptrace -points`, *mesh* where a lamp or a lit square is a mesh, *p* where the pane has Tregenza's "
        "polynomial."
        % (len(printed), len(cases), len(rows), max(float(r["moved"]) for r in derived)),
        "",
        "*Would be seen from*: the error at which a value would have been wrong, in the middle value of the row and in "
        "the one that is known least.  \"wrong: 0\" says no more than that.  It is above 1 %% in %d of %d values, and "
        "%.2g %% in %s, %s."
        % (coarse, len(rows), seen_from(least), least["case"], least["point"]),
        "",
        "`%s`, %s, commit %s: one try, %.0f seconds on %s."
        % (facts["command"], facts["date"], facts["commit"], seconds, machine(facts)),
        "",
    ]
    lines += markdown_table(
        ["case"] + HEAD,
        [[c] + summary(r) for c, r in cases.items()]
        + [["all by sensors"] + summary(sensors), ["all others"] + summary(others), ["all"] + summary(rows)],
    )
    lines += [
        "Inside are %s of the values by sensors and %s of the others: the %s of both together is neither.  "
        "The sixteen skies of a sensor share their random numbers, so that they are one try of an interval, not "
        "sixteen: %d values by sensors are %d tries, and a row of the last table has more seeds.  So do the same "
        "sensor and view of two cases."
        % (inside(sensors), inside(others), inside(rows), len(sensors),
           len({(r["case"], r["point"]) for r in sensors})),
        "",
        *widths_part(),
        "### By type of sky",
        "",
    ]
    skies = groups([r for r in rows if r["sky"] != "-"], "sky")
    lines += markdown_table(["type"] + HEAD, [[s] + summary(r) for s, r in skies.items()])
    return lines + errata_part(
        {(r["case"], r["point"], r["sky"]): r for r in derived}, {(r["case"], r["point"], r["sky"]): r for r in rows}
    )


def widths_part():
    """How wide intervals are beside the spread of their values over seeds: widths.tsv, by widths.py."""
    facts, rows = table(os.path.join(HERE, "widths.tsv"))
    stated = {way: [float(r["stated"]) / float(r["spread"]) for r in rows if r["way"] == way]
              for way in dict.fromkeys(r["way"] for r in rows)}
    held = {way: [sum(int(r[k]) for r in rows if r["way"] == way) for k in ("held", "tries")] for way in stated}
    return [
        "Why more than 95 %% of the others hold: an interval takes frames for independent, but the frames of one block "
        "of 64 are points of one scrambled sequence, and err less than is stated.  Whole blocks as units "
        "(`ptaccum -every 64`) count what the sequence spares: they are narrower, and hold.  Sixteen units of 64 are "
        "%s frames, and no picture of the table has so many; with fewer nothing narrower has been shown to hold."
        % facts["frames"],
        "",
        *markdown_table(
            ["units", "standard error stated over spread: least", "middle", "most", "intervals held", "of"],
            [[way, "%.2f" % min(v), "%.2f" % median(v), "%.2f" % max(v), str(held[way][0]), str(held[way][1])]
             for way, v in stated.items()],
        ),
        "%s, %s seeds, %s frames; an interval holds that has the mean of all seeds in it.  `%s`, %s, commit %s, on %s."
        % (facts["what"], facts["seeds"], facts["frames"], facts["command"], facts["date"], facts["commit"],
           machine(facts)),
        "",
    ]


def errata_part(derived, measured):
    errata = table(os.path.join(CIE, "errata.tsv"))[1]
    rows = []
    for e in errata:
        key = e["case"], e["point"], e["sky"]
        true, printed = float(derived[key]["value"]), float(e["printed"])
        ours = "%.4g" % float(measured[key]["value"]) if key in measured else ""
        rows.append(
            [
                e["table"],
                e["case"],
                e["point"],
                e["sky"],
                e["printed"],
                "%.4g" % true,
                "%+.1f" % (100 * (printed / true - 1)),
                ours,
                e["reason"],
            ]
        )
    return [
        "### Printed entries that differ",
        "",
        "Entries of the tables, as public transcriptions have them: %d differ from the derivation.  The tables of "
        "these cases have %d values here; how many of them the transcriptions hold was not recorded.  The report "
        "itself was not at hand, so that an error of the table cannot be told from one of the transcription."
        % (len(rows), sum(key[0] in {e["case"] for e in errata} for key in derived)),
        "",
        *markdown_table(["table", "case", "point", "type", "says", "derived", "%", "luxpipe", "reason"], rows),
    ]
