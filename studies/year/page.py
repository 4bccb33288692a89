#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""page.py OUT VIEWS WEATHER PLAN SCENE ...: the page of a year: views by verdict, where they look, their worst hours,
the heat maps."""
import csv
import html
import math
import pathlib
import subprocess
import sys

COLOURS = {"high": "#2a9d6f", "medium": "#c9b400", "minimum": "#e07b20", "none": "#aa1432", "undecided": "#334"}
STYLE = ("body { font: 14px sans-serif; margin: 2em } td, th { padding: 3px 10px; text-align: right } "
         "figure { display: inline-block; margin: 4px } img, svg { max-width: 100%; height: auto } "
         "figure img { width: 192px } .beside { display: flex; align-items: start; gap: 2em } "
         ".plan text { font-weight: bold; paint-order: stroke; stroke: #fff; stroke-width: 3px }")
SCALE = 60  # pixels a metre
FALSECOLOR = ["-tone", "falsecolor", "-nolegend", "-max", "20000", "-decades", "4"]


def views_of(path):
    """Name -> point, direction, options of ptrace."""
    views = {}
    for line in open(path):
        words = line.split()
        if len(words) > 2 and words[0] == "VIEW=":
            numbers = {o: [float(x) for x in words[words.index(o) + 1:words.index(o) + 4]] for o in ("-vp", "-vd")}
            views[words[1]] = numbers["-vp"], numbers["-vd"], words[2:]
    return views


def render(out, name, hour, weather, scene, size, words, tone):
    """Writes OUT/NAME_HOUR.png and returns its name."""
    ptrace = subprocess.Popen(["ptrace", "-w-", *words, "-x", str(size[0]), "-y", str(size[1]), "-wea", weather,
                               "-hours", hour, "-hours-apart", "-frames", "17", *scene],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    subprocess.run(["ptaccum", "-last", "-o", str(out / f"{name}_%s.png"), *tone], stdin=ptrace.stdout, check=True)
    ptrace.wait()
    return f"{name}_{hour}.png"


def plan(out, views, rows, hour, corners, weather, scene):
    """The room from above with an arrow for each view, in the colour of its class."""
    west, south, east, north, top = map(float, corners.split())
    width, height = (east - west) * SCALE, (north - south) * SCALE
    above = (f"-vtl -vp {(west + east) / 2} {(south + north) / 2} {top} -vd 0 0 -1 -vu 0 1 0 -vh {east - west} "
             f"-vv {north - south}")
    room = render(out, "plan", hour, weather, scene, (round(width), round(height)), above.split(), ["-stops", "1"])
    out = [f'<svg class="plan" width="{width + 20:.0f}" height="{height + 20:.0f}" '
           f'viewBox="-10 -10 {width + 20:.0f} {height + 20:.0f}">',
           f'<image href="{room}" width="{width:.0f}" height="{height:.0f}" opacity=".6"/>',
           f'<rect width="{width:.0f}" height="{height:.0f}" fill="none" stroke="#000" stroke-width="3"/>']
    for row in rows:
        (x, y, _), (dx, dy, _), _ = views[row["view"]]
        x, y, length = (x - west) * SCALE, (north - y) * SCALE, math.hypot(dx, dy)
        tip = x + 36 * dx / length, y - 36 * dy / length
        colour = COLOURS[row["class"]]
        out.append(f'<circle cx="{x:.0f}" cy="{y:.0f}" r="6" fill="{colour}"/><line x1="{x:.0f}" y1="{y:.0f}" '
                   f'x2="{tip[0]:.0f}" y2="{tip[1]:.0f}" stroke="{colour}" stroke-width="4"/>'
                   f'<text x="{tip[0] + 4:.0f}" y="{tip[1] + 12:.0f}">{html.escape(row["view"])}</text>')
    return "\n".join(out) + "</svg>"


def between(row, name, form):
    return form.format(float(row[name])) + " <small>" + form.format(float(row[name + ".lo"])) + " to " + form.format(
        float(row[name + ".hi"])) + "</small>"


def main():
    out, views, weather, corners, scene = pathlib.Path(sys.argv[1]), views_of(sys.argv[2]), *sys.argv[3:5], sys.argv[5:]
    rows = list(csv.DictReader(open(out / "views.tsv"), delimiter="\t"))
    order = list(COLOURS)
    rows.sort(key=lambda row: (order.index(row["class"]), float(row["DGPe5"])))
    worst = [line.rstrip("\n").split("\t") for line in open(out / "worst.tsv")]
    page = ["<!DOCTYPE html><html lang=en><meta charset=utf-8><title>A year</title>", f"<style>{STYLE}</style>",
            f"<h1>{rows[0]['hours']} hours</h1>",
            "<table><tr><th>view<th>class (EN 17037)<th>DGPe5<th>hours above 0.40<th>undecided hours<th>autonomy"]
    for row in rows:
        page.append(f'<tr><td>{html.escape(row["view"])}<td style="color:{COLOURS[row["class"]]}">{row["class"]}'
                    f'<td>{between(row, "DGPe5", "{:.3f}")}<td>{between(row, "above_0.40", "{:.0f}")}'
                    f'<td>{row["undecided"]}<td>{between(row, "GA", "{:.1%}")}')
    page += ["</table><h1>Plan, and the worst hour of each view</h1><div class=beside>",
             plan(out, views, rows, worst[0][2].split()[-1], corners, weather, scene), "<div>"]
    for dgp, view, command in worst:
        name = render(out, view, command.split()[-1], weather, scene, (192, 192), views[view][2], FALSECOLOR)
        page.append(f'<figure><img src="{name}" alt="{name}"><figcaption>{html.escape(view)}, '
                    f"{command.split()[-1]}: DGP {dgp}</figcaption></figure>")
    page += ["</div></div><h1>Hours</h1>", (out / "year.svg").read_text(), "</html>"]
    (out / "report.part").write_text("\n".join(page))
    (out / "report.part").rename(out / "report.html")


if __name__ == "__main__":
    main()
