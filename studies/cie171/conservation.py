# SPDX-License-Identifier: BSD-3-Clause
"""Cases whose answer is a conservation of light: flux through openings (5.4), closed bodies (5.8, colours of 6)."""

from lamps import *

FACES = {  # of the room: view of a face from beyond its middle, where a lamp is out of sight, and its area in m2
    "floor": ("-vtl -vp 2 2 1.4 -vd 0 0 -1 -vu 0 1 0 -vh 4 -vv 4", 16),
    "ceiling": ("-vtl -vp 2 2 1.6 -vd 0 0 1 -vu 0 1 0 -vh 4 -vv 4", 16),
    "north": ("-vtl -vp 2 2.1 1.5 -vd 0 1 0 -vu 0 0 1 -vh 4 -vv 3", 12),
    "south": ("-vtl -vp 2 1.9 1.5 -vd 0 -1 0 -vu 0 0 1 -vh 4 -vv 3", 12),
    "east": ("-vtl -vp 2.1 2 1.5 -vd 1 0 0 -vu 0 0 1 -vh 4 -vv 3", 12),
    "west": ("-vtl -vp 1.9 2 1.5 -vd -1 0 0 -vu 0 0 1 -vh 4 -vv 3", 12),
}
LAMP = 10000  # lm


def ball(radius, channels=(1, 1, 1), centre=(2, 2, 1.5)):
    """A lamp of 10,000 lm in white light of these shares."""
    level = LAMP / (4 * pi) / (pi * radius**2) / WHITE_EFFICACY
    return "void light lamp_light 0 0 3 %s\nlamp_light sphere lamp 0 0 4 %s %g\n" % (
        " ".join("%.9g" % (level * c) for c in channels),
        "%g %g %g" % centre,
        radius,
    )


def flux(number, about, scene, total, unit, name, without=""):
    """What the black faces receive, summed, is what comes in; a face with an opening receives nothing."""
    return Case(
        "5.4, " + number,
        about,
        scene,
        {"faces": ((2, 2, 0), UP)},
        lambda p, n, per: [total],
        by="faces",
        options="-i -ab 1",
        unit=unit,
        name=name,
        views=[(view, m2 / pi) for face, (view, m2) in FACES.items() if face != without],
    )


def openings():
    sky = "void glow sky_glow 0 0 4 {0:.9g} {0:.9g} {0:.9g} 0\nsky_glow source sky 0 0 4 0 0 1 180\n".format(1 / pi)
    diffuse = 2 * sum(w * c * glass(c) for c, w in nodes(0, 1, 4))
    yield flux("lamp", "the flux of a lamp in a black room", BLACK + room() + ball(0.002), LAMP, 1, "lm")
    for s in (1, 2, 3, 4):
        at = (2 - s / 2, 2 + s / 2)
        for tau, pane in ((1, ""), (diffuse, PANE + flat("pane", "glazing", 2, 3, at, at))):
            yield flux(
                "roof %d m%s" % (s, ", pane" if pane else ""),
                "flux of a uniform sky through a roof opening",
                sky + BLACK + room("ceiling") + holed("black", "roof", 2, 3, (0, 4), (0, 4), at, at) + pane,
                s * s * tau,
                1 / WHITE_EFFICACY,
                "m2 E_hz",
                "ceiling",
            )
    for width, height in ((2, 1), (3, 2), (4, 3)):
        x, z = (2 - width / 2, 2 + width / 2), (1.5 - height / 2, 1.5 + height / 2)
        for tau, pane in ((1, ""), (diffuse, PANE + flat("pane", "glazing", 1, 0, x, z))):
            yield flux(
                "facade %dx%d m%s" % (width, height, ", pane" if pane else ""),
                "flux of a uniform sky and a ground of .3 through a window",
                sky + GROUND_TEXT + BLACK + room("south") + holed("black", "front", 1, 0, (0, 4), (0, 3), x, z) + pane,
                width * height * 0.65 * tau,
                1 / WHITE_EFFICACY,
                "m2 E_hz",
                "south",
            )


def cube(reflectance):
    scene = plastic("grey", reflectance) + "!genbox grey cube 4 4 4 -i\n" + ball(0.002, centre=(2, 2, 2))
    # conservation: what the faces absorb, 96 (1 - rho) E, is what the lamp emits; the lamp itself takes light away:
    # 4 pi r^2
    return Case(
        "5.8, rho %g" % reflectance,
        "a cube of 4 m, lamp of 10,000 lm in its middle; mean of its faces",
        scene,
        {"floor": ((2, 2, 0), UP)},
        lambda p, n, per: [LAMP / (96 * (1 - reflectance))],
        by="faces",
        options="",
        unit=1 / reflectance,
        name="lx",
        views=[("-vtl -vp 2 2 1 -vd 0 0 -1 -vu 0 1 0 -vh 4 -vv 4", 1)],
    )


def luminous_weights():
    """Luminance of RADIANCE's primaries, whose sum is equal-energy white: Y of each, by Cramer's rule."""
    primaries = [(0.64, 0.33), (0.29, 0.6), (0.15, 0.06)]
    xyz = [(x / y, 1.0, (1 - x - y) / y) for x, y in primaries]

    def determinant(m):
        return sum(
            m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]) for i in range(3)
        )

    whole = determinant(xyz)
    return [determinant([(1, 1, 1) if k == i else row for k, row in enumerate(xyz)]) / whole for i in range(3)]


def sphere(number, reflectances, colours=(1, 1, 1), bounces=None):
    """A lamp in the middle of a diffuse sphere: each point has the same light, the sum of a geometric series."""
    radius = 2.0
    scene = "void plastic wall 0 0 5 %g %g %g 0 0\nwall bubble sphere 0 0 4 0 0 0 %g\n" % (*reflectances, radius)
    scene += ball(0.002, colours, (0, 0, 0))
    direct = LAMP / (4 * pi * radius**2)

    def reference(point, normal, per):
        series = [
            1 / (1 - r) if bounces is None else sum(r**k for k in range(bounces + 1)) for r in reflectances
        ]
        return [direct * sum(w * c * s for w, c, s in zip(luminous_weights(), colours, series))]

    directions = {"A": (1, 0, 0), "B": (0, -0.6, 0.8), "C": (-2 / 3, 2 / 3, -1 / 3)}
    return Case(
        number,
        "a lamp of 10,000 lm in the middle of a sphere of 2 m; each point has the same light",
        scene,
        {n: (tuple(radius * c for c in d), tuple(-c for c in d)) for n, d in directions.items()},
        reference,
        by="sensors",
        options="" if bounces is None else "-ab %d" % bounces,
        name="lx",
    )


def spheres():
    yield sphere("5.8, sphere of .9", (0.9, 0.9, 0.9))
    yield sphere("5.8, three bounces", (0.8, 0.8, 0.8), bounces=3)
    yield sphere("6, colours", (0.2, 0.5, 0.8), (2, 1, 0.25))
