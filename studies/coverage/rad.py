# SPDX-License-Identifier: BSD-3-Clause
# What a room is made of: draws from one integer, RADIANCE primitives as text, places and finishes.
import math, random

CD = 1 / 179.0  # W/(sr m2) of 1 cd/m2


class Draws:
    """Numbers from one integer, the same in every version of Python: random() alone is used."""

    def __init__(self, draw):
        self.random = random.Random(draw).random

    def between(self, low, high):
        return low + (high - low) * self.random()

    def log(self, low, high):
        return low * (high / low) ** self.random()

    def whole(self, low, high):
        return low + int((high - low + 1) * self.random())

    def chance(self, p):
        return self.random() < p

    def one_of(self, *weighted):
        at = self.random() * sum(w for _, w in weighted)
        for value, w in weighted:
            at -= w
            if at < 0:
                return value
        return weighted[-1][0]


class Scene:
    def __init__(self):
        self.lines, self.count = [], 0

    def material(self, kind, name, *numbers):
        values = ' '.join('%.5g' % n for n in numbers)
        self.lines.append('void %s %s\n0\n0\n%d %s\n' % (kind, name, len(numbers), values))
        return name

    def polygon(self, material, points):
        self.count += 1
        text = '  '.join('%.4f %.4f %.4f' % tuple(p) for p in points)
        self.lines.append('%s polygon p%d\n0\n0\n%d %s\n' % (material, self.count, 3 * len(points), text))

    def sphere(self, material, centre, radius):
        self.count += 1
        values = ' '.join('%.4f' % n for n in (*centre, radius))
        self.lines.append('%s sphere s%d\n0\n0\n4 %s\n' % (material, self.count, values))

    def box(self, material, place, low, high):
        """A box with faces outward, its corners in the coordinates of `place`."""
        (a, b, c), (d, e, f) = low, high
        for face in ([(a, b, c), (a, e, c), (d, e, c), (d, b, c)], [(a, b, f), (d, b, f), (d, e, f), (a, e, f)],
                     [(a, b, c), (d, b, c), (d, b, f), (a, b, f)], [(a, e, c), (a, e, f), (d, e, f), (d, e, c)],
                     [(a, b, c), (a, b, f), (a, e, f), (a, e, c)], [(d, b, c), (d, e, c), (d, e, f), (d, b, f)]):
            self.polygon(material, [place(p) for p in face])


def placed(x, y, turn):
    """Coordinates from a point: to the right, forward in the direction `turn` (radians from +y to +x), up."""
    s, c = math.sin(turn), math.cos(turn)
    return lambda p: (x + p[0] * c + p[1] * s, y - p[0] * s + p[1] * c, p[2])


def unmoved(p):
    return p


def upright(at, x0, x1, y, z0, z1):
    """Corners of a rectangle that faces who stands at the origin of `at`."""
    return [at(p) for p in ((x0, y, z0), (x1, y, z0), (x1, y, z1), (x0, y, z1))]


def colour(d, low, high, tint=.15):
    grey = d.between(low, high)
    return [min(.95, grey * d.between(1 - tint, 1 + tint)) for _ in range(3)]


def finish(d, scene, name, low, high, polish):
    """A plastic, polished with this probability."""
    shine = [d.between(.02, .08), d.one_of((0, 1), (.03, 1), (.1, 2), (.2, 1))] if d.chance(polish) else [0, 0]
    return scene.material('plastic', name, *(colour(d, low, high) + shine))
