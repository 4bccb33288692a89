#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""page.py: docs/certificate.md and docs/certificate.html from the tables that hold the figures; nothing on the page
is typed here.

page.py           writes both
page.py -check    fails if the pages are not what their tables give"""

import math
import os
import re
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "studies", "cie171"))
from compare import table  # noqa: E402
from as_html import as_html  # noqa: E402

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
        "these cases have %d values here; how many of them the transcriptions hold was not recorded.  The report itself "
        "was not at hand, so that an error of the table cannot be told from one of the transcription."
        % (len(rows), sum(key[0] in {e["case"] for e in errata} for key in derived)),
        "",
        *markdown_table(["table", "case", "point", "type", "says", "derived", "%", "luxpipe", "reason"], rows),
    ]


def mutations_part():
    facts, rows = table(os.path.join(HERE, "mutations.tsv"))
    faults = [r for r in rows if r["file"] != "-"]
    clean = [r for r in rows if r["file"] == "-"]
    found = [r for r in faults if r["case"] != "-"]
    return [
        "### Would a fault be seen?",
        "",
        "Faults put into the programs one at a time: %d of %d give a value that is wrong.  Without a fault none of %s "
        "is."
        % (len(found), len(faults), " ".join(r["values"] + " values" for r in clean)),
        "",
        "A fault is seen where it moves a value by more than the column *would be seen from* has, and not "
        "below.",
        "",
        "`%s`, %s, commit %s, on %s; each time `%s`, up to the first wrong value."
        % (facts["command"], facts["date"], facts["commit"], machine(facts), facts["values"]),
        "",
        *markdown_table(
            ["fault", "in", "first wrong value", "derived", "luxpipe with the fault", "standard errors", "after, s"],
            [
                [
                    r["fault"],
                    "`%s`" % r["file"],
                    "not found" if r["case"] == "-" else "%s, %s%s" % (
                        r["case"], r["point"], "" if r["sky"] == "-" else ", type " + r["sky"]),
                    r["derived"],
                    r["value"],
                    r["errors"] if r["errors"] == "-" or float(r["errors"]) < 1000 else "> 1000",
                    r["seconds"],
                ]
                for r in faults
            ],
        ),
    ]


def measured_part():
    rows = table(os.path.join(HERE, "measured.tsv"))[1]
    return [
        "## Other programs, intervals, devices",
        "",
        "Numbers of tries, and how many of them held.  *Misses* marks a row below its bound.  A commit is the last one "
        "of `lib` before the measurement: a row says nothing of later ones.",
        "",
        *markdown_table(
            ["what", "tries", "held", "%", "bound, %", "", "seconds", "date", "commit", "machine"],
            [
                [
                    r["what"],
                    "%s %s" % (r["tries"], r["of"]),
                    r["held"],
                    "%.4g" % share(r),
                    r["least"] if r["least"] != "0" else "-",
                    "*misses*" if share(r) < float(r["least"]) else "",
                    r["seconds"],
                    r["date"],
                    r["commit"],
                    r["machine"],
                ]
                for r in rows
            ],
        ),
        "Commands, in the order of the rows (`BIN`: the folder of the programs):",
        "",
        "```",
        *dict.fromkeys(r["command"] for r in rows),
        "```",
        "",
        *opencl_part(),
        *(["Not measured: intervals of whole years.", ""] if not any("year" in r["what"] for r in rows) else []),
        "Not measured: a GPU.",
        "",
    ]


def opencl_part():
    path = os.path.join(HERE, "opencl.tsv")
    if not os.path.exists(path):
        return ["OpenCL's drivers were not compared: `make opencl-stacks`.", ""]
    return [
        "Values of four frames of the office, 48 x 48 pixels, by OpenCL's drivers for processors, and how many have "
        "the bits that the processor gives without OpenCL: `make opencl-stacks`, as root.",
        "",
        *markdown_table(
            ["driver", "device", "values", "equal", "ptrace says", "seconds", "date", "commit"],
            [
                [r[k] for k in ("driver", "device", "tries", "held", "said", "seconds", "date", "commit")]
                for r in table(path)[1]
            ],
        ),
    ]


def share(row):
    return 100 * int(row["held"]) / int(row["tries"])


def page():
    commits = list(dict.fromkeys(
        [table(os.path.join(CIE, "results.tsv"))[0]["commit"], table(os.path.join(HERE, "mutations.tsv"))[0]["commit"]]
        + [r["commit"] for r in table(os.path.join(HERE, "measured.tsv"))[1]]))
    lines = [
        "# Certificate",
        "",
        "Figures of luxpipe against closed forms, other programs and itself.  `make certificate` measures again what "
        "is older than `lib` and writes this page from its tables; `ctest -R certificate` compares the two.  A row "
        "that misses its bound stays.  Rows are of %d states of the program, not of one: commits %s."
        % (len(commits), ", ".join(commits)),
        "",
        *cie_part(),
        *mutations_part(),
        *measured_part(),
        "## Another program",
        "",
        "Anybody can set the values of another program beside the derived ones: a table with the columns case, "
        "point, sky and value, separated by tabs, named as in `studies/cie171/reference.tsv`.",
        "",
        "```",
        "python3 studies/cie171/compare.py values.tsv",
        "```",
        "",
        "`studies/cie171/README.md` has the geometry and the derivations, and what is not covered.",
    ]
    return "\n".join(lines) + "\n"


def files():
    text = page()
    return {"certificate.md": text, "certificate.html": as_html(text)}


def check():
    bad = []
    for name, text in files().items():
        with open(os.path.join(TOP, "docs", name)) as f:
            if f.read() != text:
                bad.append("docs/%s is not what its tables give: python3 studies/certificate/page.py" % name)
    sys.exit("\n".join("page.py: " + b for b in bad) if bad else 0)


if __name__ == "__main__":
    if sys.argv[1:] == ["-check"]:
        check()
    for file_name, file_text in files().items():
        with open(os.path.join(TOP, "docs", file_name), "w") as out_file:
            out_file.write(file_text)
