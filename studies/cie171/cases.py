# SPDX-License-Identifier: BSD-3-Clause
"""The cases of CIE 171:2006, chapters 5 and 6, that have an analytical answer: geometry, scene text, sensors and
references.  The
room is x 0..4, y 0..4, z 0..3 m, black, y north; the sun of the skies stands 60 degrees high in the south and is
left out.  Each
value is derived here, from no table."""

from skies import *

UP, DOWN, NORTH, SOUTH = (0, 0, 1), (0, 0, -1), (0, 1, 0), (0, -1, 0)
Z = [2.75 - 0.5 * k for k in range(6)]
HALF_SINE2 = math.sin(math.radians(0.2665)) ** 2


def wall(y, normal, names="ABCDEF", z=Z):
    return {n: ((2, y, h), normal) for n, h in zip(names, z)}


def line(z, normal, names, first=0.25, step=0.5):
    return {n: ((2, first + step * k, z), normal) for k, n in enumerate(names)}


def polygon(material, name, *corners):
    numbers = " ".join("%.9g" % c for p in corners for c in p)
    return "%s polygon %s 0 0 %d %s\n" % (material, name, 3 * len(corners), numbers)


def flat(material, name, axis, at, u, v):
    """A rectangle at coordinate `at` of an axis; u, v as in rectangle()."""

    def corner(a, b):
        p = [a, b]
        p.insert(axis, at)
        return p

    return polygon(material, name, corner(u[0], v[0]), corner(u[1], v[0]), corner(u[1], v[1]), corner(u[0], v[1]))


def holed(material, name, axis, at, u, v, hole_u, hole_v):
    parts = [
        ((u[0], u[1]), (v[0], hole_v[0])),
        ((u[0], u[1]), (hole_v[1], v[1])),
        ((u[0], hole_u[0]), hole_v),
        ((hole_u[1], u[1]), hole_v),
    ]
    return "".join(
        flat(material, "%s%d" % (name, k), axis, at, a, b)
        for k, (a, b) in enumerate(parts)
        if a[1] > a[0] and b[1] > b[0]
    )


def plastic(name, reflectance):
    return "void plastic %s 0 0 5 %g %g %g 0 0\n" % ((name,) + 3 * (reflectance,))


BLACK = plastic("black", 0)
PANE = "void glass pane 0 0 3 .9584 .9584 .9584\n"
# without reflection, and with a transmittance that is the polynomial's
POLYNOMIAL_PANE = "void brightfunc share 2 if({0},{0},0) . 0 0\nshare glass pane 0 0 4 1 1 1 1\n".format(
    "+".join("%g*abs(Rdot)^%d" % (c, k) for k, c in enumerate(POLYNOMIAL)).replace("+-", "-")
)
GROUND_TEXT = "void glow ground_glow 0 0 4 {0} {0} {0} 0\nground_glow source ground 0 0 4 0 0 -1 180\n".format(GROUND)


def room(*open_faces, material="black"):
    faces = {
        "floor": (2, 0, (0, 4), (0, 4)),
        "ceiling": (2, 3, (0, 4), (0, 4)),
        "south": (1, 0, (0, 4), (0, 3)),
        "north": (1, 4, (0, 4), (0, 3)),
        "west": (0, 0, (0, 4), (0, 3)),
        "east": (0, 4, (0, 4), (0, 3)),
    }
    return "".join(flat(material, n, *f) for n, f in faces.items() if n not in open_faces)


def sun(altitude, irradiance_at_normal=1.0):
    """A sun due south of 0.533 degrees."""
    level = irradiance_at_normal / (pi * HALF_SINE2)
    return "void light solar 0 0 3 {0:.9g} {0:.9g} {0:.9g}\nsolar source sun 0 0 4 0 {1:.9f} {2:.9f} .533\n".format(
        level, -math.cos(math.radians(altitude)), math.sin(math.radians(altitude))
    )


class Case:
    """by: fisheye (Ev along the normal), plate (16 pixels of a spot of reflectance .5), sensors (ptrace -points), or
    faces (sum over views of mean times area).  files: what the scene reads, by name."""

    def __init__(
        self,
        number,
        about,
        scene,
        sensors,
        reference,
        by="fisheye",
        skies=False,
        unit=1.0,
        options="-ab 1",
        name="% of E_hz",
        files=(),
        views=(),
    ):
        self.files, self.views = dict(files), views
        self.number, self.about, self.scene, self.sensors, self.by = number, about, scene, sensors, by
        self.reference, self.skies, self.options, self.name = reference, skies, options, name
        self.unit = 100 / 179 if skies else unit  # skies have 1 W/m2, 179 lx


def percent(values):
    return [100 * v for v in values]


def glazing(tau):
    """Words for the opening, letter of the case's name, material."""
    return {bare: ("bare", "", ""), glass: ("pane of glass", "", PANE), polynomial: (
        "transmittance by Tregenza's polynomial", " p", POLYNOMIAL_PANE)}[tau]


def roof(size, tau):
    lo, hi = 2 - size / 2, 2 + size / 2

    def reference(point, normal, per):
        y = point[1] + SUN[1] / SUN[2] * (3 - point[2])
        return percent(rectangle(point, normal, 2, 3, (lo, hi), (lo, hi), sky_light(tau), (), (y,), per))

    scene = BLACK + room("ceiling") + holed("black", "roof", 2, 3, (0, 4), (0, 4), (lo, hi), (lo, hi))
    words, letter, material = glazing(tau)
    if material:
        scene += material + flat("pane", "glazing", 2, 3, (lo, hi), (lo, hi))
    sensors = {**wall(4, SOUTH), **line(0, UP, "GHIJKLMN", 3.75, -0.5)}
    number = "%s, %dx%d%s" % ("5.10" if material else "5.9", size, size, letter)
    about = "roof opening %d x %d m, %s; sky through it" % (size, size, words)
    return Case(number, about, scene, sensors, reference, skies=True)


def facade(width, height, tau):
    x, z = (2 - width / 2, 2 + width / 2), ((1, 2) if height == 1 else (0, 3))

    def reference(point, normal, per):
        at_sun = point[2] - point[1] * SUN[2] / SUN[1]
        return percent(rectangle(point, normal, 1, 0, x, z, sky_light(tau), (), (at_sun,), per))

    scene = BLACK + room("south") + holed("black", "front", 1, 0, (0, 4), (0, 3), x, z) + GROUND_TEXT
    words, letter, material = glazing(tau)
    if material:
        scene += material + flat("pane", "glazing", 1, 0, x, z)
    sensors = {
        **wall(4, SOUTH),
        **line(0, UP, "GHIJKLMN", 3.75, -0.5),
        **line(3, DOWN, [n + "'" for n in "GHIJKLMN"], 3.75, -0.5),
    }
    number = "%s, %dx%d%s" % ("5.12" if material else "5.11", width, height, letter)
    about = "south window %d x %d m, %s; sky and a ground of reflectance .3 at infinity" % (width, height, words)
    return Case(number, about, scene, sensors, reference, skies=True)


WINDOW = ((1, 3), (1, 2))
FRONT = BLACK + room("south") + holed("black", "front", 1, 0, (-8, 12), (0, 3), *WINDOW) + GROUND_TEXT


def perpendicular(distance, height, width):
    """Factor of a point to a rectangle at a right angle, with a corner at the point's foot (closed form)."""
    far = math.hypot(height, distance)
    return (math.atan(width / distance) - distance / far * math.atan(width / far)) / (2 * pi)


def two_parts(point, normal, per, edge, lower, upper, cuts=()):
    """Window of 5.13 and 5.14: light `lower` below z = edge, `upper` above."""
    total = [0.0] * 16
    edge = min(max(edge, 1), 2)
    for z, light in (((1, edge), lower), ((edge, 2), upper)):
        if z[1] > z[0]:
            part = rectangle(point, normal, 1, 0, WINDOW[0], z, light, (), cuts, per)
            total = [a + 100 * b for a, b in zip(total, part)]
    return total


def eaves(depth):
    def reference(point, normal, per):
        def mask(d, _cosine):
            t = (3 - point[2]) / d[2]
            x, s = point[0] + d[0] * t, -(point[1] + d[1] * t)
            factor = perpendicular(s, 3, x + 8) + perpendicular(s, 3, 12 - x)
            return [0.3 * GROUND * (1 - factor)] * 16

        at_sun = -point[1] * SUN[2] / SUN[1]
        return two_parts(point, normal, per, 3 * point[1] / (point[1] + depth), sky_light(bare), mask, (at_sun,))

    scene = FRONT + plastic("grey", 0.3) + flat("grey", "eaves", 2, 3, (-8, 12), (-depth, 0))
    return Case(
        "5.13, %g m" % depth,
        "window 2 x 1 m under eaves %g m deep, reflectance .3" % depth,
        scene,
        line(0, UP, "ABCDEFGH", 3.75, -0.5),
        reference,
        skies=True,
    )


def house_hides(q, per):
    """Irradiance that the black room takes from a point of the mask at y = -6, which looks north."""
    light = sky_light(bare)
    faces = [(1, 0, (0, 4), (0, 3))]
    if q[0] < 0 or q[0] > 4:
        faces.append((0, 0 if q[0] < 0 else 4, (0, 4), (0, 3)))
    if q[2] > 3:
        faces.append((2, 3, (0, 4), (0, 4)))
    total = [0.0] * 16
    for axis, at, u, v in faces:
        part = rectangle(q, NORTH, axis, at, u, v, light, per=per)
        total = [a + b for a, b in zip(total, part)]
    return total


def opposite(height):
    # vertical surface that looks north: sky by quadrature over azimuths 90 to 180 degrees from south, ground .3/2
    north = over_sky(lambda x, y, z: y, (pi, pi / 2))
    north = [-level * e for level, e in zip(LEVEL, north)]

    def reference(point, normal, per):
        def mask(d, _cosine):
            t = (-6 - point[1]) / d[1]
            hidden = house_hides((point[0] + d[0] * t, -6, d[2] * t), per / 2)
            return [0.3 / pi * (e + 0.15 - h) for e, h in zip(north, hidden)]

        at_sun = -point[1] * SUN[2] / SUN[1]
        edge = height * point[1] / (point[1] + 6)
        top = 3 * point[1] / (point[1] + 6)  # above it the mask sees the roof of the room
        return two_parts(point, normal, per / 2, edge, mask, sky_light(bare), (at_sun, top))

    scene = (
        BLACK + room("south") + holed("black", "front", 1, 0, (0, 4), (0, 3), *WINDOW) + GROUND_TEXT
    )  # the room stands alone
    scene += plastic("grey", 0.3) + flat("grey", "opposite", 1, -6, (-8, 12), (0, height))
    return Case(
        "5.14, %d m" % height,
        "window 2 x 1 m opposite a wall %d m high at 6 m, reflectance .3" % height,
        scene,
        line(0, UP, "ABCDEFGH", 3.75, -0.5),
        reference,
        skies=True,
    )
