# SPDX-License-Identifier: BSD-3-Clause
"""Random option sets for one picture: lists of whole options, so that one can be taken out at a time."""
import random


def place(r, picture):
    return [str(r.randrange(picture.width)), str(r.randrange(picture.height))]


def number(value):
    return f"{value:.4g}"


def random_options(seed, picture):
    r = random.Random(f"options {seed}")
    kind = picture.lines and next(line for line in picture.lines if line.startswith("VIEW=")).split("-vt")[1][0]
    out = []
    mode = r.random()
    if mode < .05:
        return [["-V"]]
    if mode < .10:
        out += [["-1"], ["-i", number(r.uniform(300, 8000))]]
    elif mode < .13:
        ev = r.uniform(300, 8000)
        out += [["-2", number(ev * r.uniform(0, .9))], ["-i", number(ev)]]
    elif mode < .60:
        out.append(["-d"])
    elif mode < .75:
        out.append(["-D"])
    if r.random() < .4:
        out.append(["-b", number(r.choice([3, 5, 7, r.uniform(1.5, 20), r.uniform(150, 6000)]))])
    if r.random() < .25:
        out.append(["-r", number(r.choice([.05, .1, .2, .4, r.uniform(.03, .8)]))])
    for option, chance in (("-s", .1), ("-x", .15), ("-y", .05), ("-C l+", .1), ("-4", .02), ("-P 1", .05)):
        if r.random() < chance:
            out.append(option.split())
    if r.random() < .15:
        out.append(["-Y", number(10 ** r.uniform(3.5, 5.5))])
    if r.random() < .25:
        out.append([r.choice(["-t", "-T"])] + place(r, picture) + [number(r.uniform(.1, 1))])
    if r.random() < .1:
        out.append(["-q", r.choice("012")])
    if r.random() < .1:
        out.append(["-G", r.choice("123")])
    if r.random() < .1:
        out.append(["-B", number(r.uniform(.05, .6))])
    if r.random() < .05:
        out.append(["-k", number(10 ** r.uniform(-3, 0))])
    if r.random() < .05:
        out.append(["-w", "2", "1", number(r.uniform(1.6, 2)), "2", "1", "5.87e-05", "0.092", "0.159"])
    if r.random() < .08:
        out.append(["-l"] + place(r, picture) + [number(r.uniform(.1, 1))])
    elif r.random() < .06:
        inner = r.uniform(.1, .8)
        out.append(["-L"] + place(r, picture) + [number(inner), number(inner + r.uniform(.1, 1))])
    if kind == "a" and r.random() < .04:
        out.append(["-z", number(r.uniform(8, 30)), "1"])
    return out
