# SPDX-License-Identifier: BSD-3-Clause
"""HTML of the Markdown that page.py writes."""

import html
import re


def inline(text):
    text = html.escape(text, quote=False)
    text = re.sub(r"`([^`]*)`", r"<code>\1</code>", text)
    return re.sub(r"\*([^*]+)\*", r"<em>\1</em>", text)


def as_html(text):
    """HTML of the Markdown that page() writes: headings, paragraphs, tables, one kind of code."""
    out, rows, code = [], [], False
    for line in text.split("\n"):
        if rows and not line.startswith("|"):
            body = ["<tr>" + "".join("<td>%s</td>" % inline(c) for c in r) + "</tr>" for r in rows[2:]]
            out += ["<table><tr>%s</tr>" % "".join("<th>%s</th>" % inline(c) for c in rows[0]), *body, "</table>"]
            rows = []
        if line.startswith("```"):
            out.append("</pre>" if code else "<pre>")
            code = not code
        elif line.startswith("|"):
            rows.append([c.strip() for c in line.strip("|").split("|")])
        elif line.startswith("#"):
            level = len(line) - len(line.lstrip("#"))
            out.append("<h%d>%s</h%d>" % (level, inline(line[level + 1 :]), level))
        elif line:
            out.append(html.escape(line) if code else "<p>%s</p>" % inline(line))
    style = (
        "body{font:16px/1.4 sans-serif;max-width:70em;margin:2em auto;padding:0 1em}table{border-collapse:collapse}"
        "td,th{border:1px solid #ccc;padding:.2em .6em;text-align:left}"
    )
    return (
        '<!DOCTYPE html>\n<html lang="en"><meta charset="utf-8"><title>luxpipe: certificate</title>'
        '<style>%s</style>\n%s\n'
        "</html>\n" % (style, "\n".join(out))
    )
