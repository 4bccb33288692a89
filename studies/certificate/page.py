#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""page.py: docs/certificate.md and docs/certificate.html from the tables that hold the figures; nothing on the page
is typed here.

page.py           writes both
page.py -check    fails if the pages are not what their tables give"""

import os
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "studies", "cie171"))
from compare import table  # noqa: E402
from as_html import as_html  # noqa: E402
from cie_part import CIE, HERE, cie_part, machine, markdown_table  # noqa: E402


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
