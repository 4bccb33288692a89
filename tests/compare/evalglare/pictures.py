# SPDX-License-Identifier: BSD-3-Clause
"""Random pictures, each from its seed alone: a view, a size, and radiances that look like what people measure.

Synthetic rooms (windows with mullions, desks, screens), suns and lamps, photographs' noise, vignettes and glints.
"""
import math
import random
import struct

TYPES = "aaaavvvhhsc"


class Picture:
    """Header lines and RGBE quadruples, top row first."""

    def __init__(self, width, height, lines, pixels):
        self.width, self.height, self.lines, self.pixels = width, height, lines, pixels

    def write(self, path):
        head = "#?RADIANCE\n" + "".join(line + "\n" for line in self.lines) + "FORMAT=32-bit_rle_rgbe\n\n"
        with open(path, "wb") as out:
            out.write(head.encode() + b"-Y %d +X %d\n" % (self.height, self.width))
            for start in range(0, len(self.pixels), self.width):
                out.write(b"".join(self.pixels[start:start + self.width]))


def rgbe(red, green, blue):
    top = max(red, green, blue)
    if top < 1e-32:
        return b"\0\0\0\0"
    fraction, exponent = math.frexp(top)
    scale = fraction * 256 / top
    return struct.pack("4B", int(red * scale), int(green * scale), int(blue * scale), exponent + 128)


def random_view(r):
    """A view type and sizes that evalglare takes, and the number of pixels across and up."""
    kind = r.choice(TYPES)
    width = r.choice([r.randint(21, 90), r.randint(60, 200), 128, 256])
    height = width
    if kind == "a":
        across = r.choice([180, 180, 180, r.uniform(60, 180), 200])
    elif kind == "h":
        across = 180
    elif kind == "s":
        across = r.choice([180, r.uniform(60, 179)])
    elif kind == "c":
        across = r.uniform(60, 175)
    else:
        across = r.uniform(20, 130)
    up = across
    if kind in "avc" and r.random() < .5:
        up = min(across * r.uniform(.4, 1.2), 110 if kind == "c" else 150)
        height = max(21, int(width * up / across))
    if kind == "c":
        up = min(up, 110)
    view = f"-vt{kind} -vp 0 0 0 -vd {direction(r)} -vu 0 0 1 -vh {across:.6g} -vv {up:.6g} -vo 0 -va 0 -vs 0 -vl 0"
    return view, kind, width, height


def direction(r):
    if r.random() < .5:
        return r.choice(["0 1 0", "1 0 0", "0 -1 0"])
    return f"{r.uniform(-1, 1):.4g} {r.uniform(.2, 1):.4g} {r.uniform(-.4, .4):.4g}"


def luminances(r, width, height):
    """Radiance (W/sr/m2, grey) at (x, y) from -1 to 1: a room, then what shines."""
    base, slope = 10 ** r.uniform(-.5, .8), r.uniform(-.5, .5)
    boxes = []
    for _ in range(r.randint(0, 3)):  # windows and screens
        x, y = r.uniform(-.8, .8), r.uniform(-.5, .8)
        boxes.append((x, y, r.uniform(.05, .4), r.uniform(.05, .4), 10 ** r.uniform(.8, 2.3), r.randint(0, 6)))
    pixel = 2 / max(width, height)
    spots = []
    for _ in range(r.choice([0, 1, 3, 10, 30, 100])):  # lamps, suns, glints
        x, y, size = r.uniform(-.9, .9), r.uniform(-.9, .9), pixel * r.choice([.4, .6, 1, 1.6, 3, 8])
        spots.append((x, y, size, 10 ** r.uniform(1, 4)))
    noise = r.choice([0, .02, .1, .4, .8])
    vignette = r.uniform(0, .5)
    rows = []
    for j in range(height):
        y = 1 - (2 * j + 1) / height
        row = []
        for i in range(width):
            x = (2 * i + 1) / width - 1
            value = base * (1 + slope * y) * (1 - vignette * (x * x + y * y) / 2)
            for bx, by, bw, bh, shine, bars in boxes:
                if abs(x - bx) < bw and abs(y - by) < bh and not (bars and (x - bx) / bw * bars % 1 < .15):
                    value = shine * (1 + .2 * y)
            row.append(value * math.exp(r.gauss(0, noise)) if noise else value)
        rows.append(row)
    for sx, sy, size, shine in spots:
        for j in cells(1 - sy, size, height):
            for i in cells(1 + sx, size, width):
                if ((2 * i + 1) / width - 1 - sx) ** 2 + (1 - (2 * j + 1) / height - sy) ** 2 < size ** 2:
                    rows[j][i] = shine
    return rows


def cells(middle, reach, count):
    """The cells of `count` over 0 to 2 that a spot can touch."""
    return range(max(0, int((middle - reach) * count / 2) - 1), min(count, int((middle + reach) * count / 2) + 2))


def random_picture(seed):
    r = random.Random(f"picture {seed}")
    view, kind, width, height = random_view(r)
    rows = luminances(r, width, height)
    if kind in "ah" and r.random() < .5:  # a fisheye's black corners
        for j in range(height):
            for i in range(width):
                if math.hypot((2 * i + 1) / width - 1, (2 * j + 1) / height - 1) > 1:
                    rows[j][i] = 0
    tint = r.choice([(1, 1, 1), (1, 1, 1), (1.2, 1, .7), (.8, 1, 1.4)])
    exposure = r.choice([None, None, r.uniform(.01, 20)])
    lines = ["VIEW= " + view]
    if exposure:
        lines.append(f"EXPOSURE={exposure:.6g}")
    if r.random() < .15:
        lines.append("PRIMARIES= .64 .33 .3 .6 .15 .06 .3127 .329" if r.random() < .5 else
                     "PRIMARIES= 0.6400 0.3300 0.2900 0.6000 0.1500 0.0600 0.3333 0.3333")
    if r.random() < .1:
        lines.insert(0, "pcomb -e 'a picture of before'")
    scale = exposure or 1
    pixels = [rgbe(*(value * scale * t for t in tint)) for row in rows for value in row]
    return Picture(width, height, lines, pixels)
