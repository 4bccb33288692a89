# SPDX-License-Identifier: BSD-3-Clause
"""Cases under lamps, the sun and between diffuse surfaces; CASES is the list of all."""

from cases import *

WHITE_EFFICACY = 179


def lamp_over_floor(kind):
    points = {
        "A": (0, 0),
        "B": (0.5, 0),
        "C": (1, 0),
        "D": (1.5, 0),
        "E": (0.5, 0.5),
        "F": (1, 0.5),
        "G": (1.5, 0.5),
        "H": (1, 1),
        "I": (1.5, 1),
        "J": (1.5, 1.5),
    }
    sensors = {n: ((x, y, 0), UP) for n, (x, y) in points.items()}

    def reference(point, _normal, _per):
        d2 = point[0] ** 2 + point[1] ** 2 + 9
        return [1000 * 9 / d2**2 if kind == "Lambert" else 10000 / (4 * pi) * 3 / d2**1.5]

    size = 0.005
    intensity = 1000 if kind == "Lambert" else 10000 / (4 * pi)
    level = intensity / (pi * size * size) / WHITE_EFFICACY
    scene = plastic("plate", 0.5) + flat("plate", "floor", 2, 0, (-2, 2), (-2, 2))
    scene += "void light lamp_light 0 0 3 {0:.9g} {0:.9g} {0:.9g}\n".format(level)
    scene += (
        "lamp_light ring lamp 0 0 8 0 0 3 0 0 -1 0 %g\n"
        if kind == "Lambert"
        else "lamp_light sphere lamp 0 0 4 0 0 3 %g\n"
    ) % size
    return Case(
        "5.2, " + kind,
        "%s lamp 3 m over a floor of 4 x 4 m" % kind,
        scene,
        sensors,
        reference,
        by="plate",
        options="-ab 0",
        name="lx",
    )


def area(power, mirror=False):
    extent = ((1.5, 2.5), (1.5, 2.5))

    def light(_d, cosine):
        return [1000 * cosine**power]

    def reference(point, normal, per):
        total = rectangle(point, normal, 2, 3, *extent, light, per=per)[0]
        if mirror:  # the lamp's image at y = 8 - y
            total += 0.9 * rectangle(point, normal, 2, 3, extent[0], (5.5, 6.5), light, per=per)[0]
        return [total]

    modifier = "void" if power == 0 else "cosine"
    scene = "" if power == 0 else "void brightfunc cosine 2 abs(Rdot) . 0 0\n"
    scene += "{1} light lamp_light 0 0 3 {0:.9g} {0:.9g} {0:.9g}\n".format(1000 / WHITE_EFFICACY, modifier)
    scene += polygon(
        "lamp_light", "lamp", (1.5, 1.5, 2.9999999), (1.5, 2.5, 2.9999999), (2.5, 2.5, 2.9999999), (2.5, 1.5, 2.9999999)
    )
    scene += BLACK + room(*(["north"] if mirror else []))
    if mirror:
        scene += "void mirror mirror 0 0 3 .9 .9 .9\n" + flat("mirror", "north", 1, 4, (0, 4), (0, 3))
    sensors = {**({} if mirror else wall(0, NORTH)), **line(0, UP, "GHIJKLMN")}
    number = "6, mirror" if mirror else "5.3, L = 1000" + " cos" * power
    return Case(
        number,
        "lamp 1 x 1 m in the ceiling" + (", north wall a mirror of .9" if mirror else ""),
        scene,
        sensors,
        reference,
        name="lx",
    )


def through_pane(cosine):
    """Share of the sun's light that passes: mean over its disc, by the cosine, for the pane is far from linear at
85 degrees."""
    passed = total = 0.0
    for a, wa in nodes(0, math.radians(0.2665), 1):
        for f, wf in nodes(0, pi, 2):
            c = cosine * math.cos(a) + math.sqrt(1 - cosine * cosine) * math.sin(a) * math.cos(f)
            total += wa * wf * math.sin(a) * c
            passed += wa * wf * math.sin(a) * c * glass(c)
    return passed / total


def pane():
    angles = [0, 10, 20, 30, 40, 50, 60, 70, 80, 85]
    for angle in angles:
        cosine = math.cos(math.radians(angle))
        scene = sun(90 - angle, 1 / cosine) + PANE + flat("pane", "pane", 2, 1, (-30, 30), (-30, 30))
        scene += plastic("plate", 0.5) + flat("plate", "floor", 2, 0, (-1, 1), (-1, 1))
        yield Case(
            "5.5, %d deg" % angle,
            "a pane over a sensor, the sun %d degrees from its normal" % angle,
            scene,
            {"A": ((0, 0, 0), UP)},
            lambda p, n, per, c=cosine: [100 * through_pane(c)],
            by="plate",
            options="-ab 0",
            unit=100 / WHITE_EFFICACY,
            name="% of E without it",
        )


def factor(size):
    lo, hi = 2 - size / 2, 2 + size / 2

    def reference(point, normal, per):
        return [100 / pi * rectangle(point, normal, 2, 0, (lo, hi), (lo, hi), lambda d, c: [1], per=per)[0]]

    scene = (
        sun(35, 1 / math.sin(math.radians(35))) + plastic("grey", 0.3) + flat("grey", "s2", 2, 0, (lo, hi), (lo, hi))
    )
    sensors = {**wall(0, NORTH, "FEDCBA"[: 5 if size == 4 else 6]), **line(3, DOWN, "GHIJKLMN")}
    return Case(
        "5.6, S2 %g m" % size,
        "a diffuse square of %g m in the sun, 3 m below a ceiling, 2 m from a wall" % size,
        scene,
        sensors,
        reference,
        unit=100 / 0.3 / WHITE_EFFICACY,
        name="% of E_hz rho",
    )


def obstruction():
    def reference(point, normal, per):
        edge = max([point[2] + (1 - point[2]) * (4 - point[1]) / (y - point[1]) for y in (2.5, 2.7)] + [0])
        if edge >= 3:
            return [0.0]
        return [100 / pi * rectangle(point, normal, 1, 4, (0, 4), (edge, 3), lambda d, c: [1], per=per)[0]]

    scene = (
        sun(60, 1 / math.cos(math.radians(60)))
        + plastic("grey", 0.6)
        + flat("grey", "s2", 1, 4, (0, 4), (0, 3))
        + BLACK
    )
    scene += "!genbox black box 4 .2 1 | xform -t 0 2.5 0\n" + flat("black", "screen", 1, -0.01, (0, 4), (0, 6))
    return Case(
        "5.7",
        "a diffuse wall in the sun, partly hidden by a box 1 m high",
        scene,
        {**wall(0, NORTH), **line(0, UP, "GHIJK")},
        reference,
        unit=100 / 0.6 / WHITE_EFFICACY,
        name="% of E_v rho",
    )


def cube(reflectance):
    scene = plastic("grey", reflectance) + "!genbox grey cube 4 4 4 -i\n"
    level = 10000 / (4 * pi) / (pi * 0.002**2) / WHITE_EFFICACY
    scene += "void light lamp_light 0 0 3 {0:.9g} {0:.9g} {0:.9g}\nlamp_light sphere lamp 0 0 4 2 2 2 .002\n".format(
        level
    )
    # conservation: what the faces absorb, 96 (1 - rho) E, is what the lamp emits; the lamp itself takes light away:
    # 4 pi r^2
    return Case(
        "5.8, rho %g" % reflectance,
        "a cube of 4 m, lamp of 10,000 lm in its middle; mean of its faces",
        scene,
        {"floor": ((2, 2, 0), UP)},
        lambda p, n, per: [10000 / (96 * (1 - reflectance))],
        by="faces",
        options="",
        unit=1 / reflectance,
        name="lx",
    )


def patch():
    scene = sun(60) + plastic("plate", 0.5) + room("ceiling", material="plate")
    scene += holed("plate", "roof", 2, 3, (0, 4), (0, 4), (1.5, 2.5), (1.5, 2.5))
    edge = 1.5 + 3 / math.tan(math.radians(60))
    sensors = {
        "inside": ((2, edge + 0.05, 0), UP),
        "outside": ((2, edge - 0.05, 0), UP),
        "beside": ((1.4, 3.6, 0), UP),
        "middle": ((2, 3.7, 0), UP),
    }
    inside = 100 * math.sin(math.radians(60))
    return Case(
        "6, patch of sun",
        "sun 60 degrees high through a roof opening of 1 x 1 m",
        scene,
        sensors,
        lambda p, n, per: [inside if p[0] == 2 and p[1] > edge else 0],
        by="plate",
        options="-ab 0",
        unit=100 / WHITE_EFFICACY,
        name="% of E_n",
    )


def closed():
    scene = (
        sun(60, 1e5)
        + "void glow sky_glow 0 0 4 1e5 1e5 1e5 0\nsky_glow source sky 0 0 4 0 0 1 360\n"
        + plastic("white", 0.9)
    )
    return Case(
        "6, leaks",
        "a closed white room under the sun and a sky of 1e5",
        scene + room(material="white"),
        {"floor": ((2, 0.01, 0), UP), "corner": ((0.001, 0.001, 0.001), NORTH)},
        lambda p, n, per: [0],
        options="-ab 4",
        name="lx",
    )


CASES = [
    lamp_over_floor("Lambert"),
    lamp_over_floor("isotropic"),
    area(0),
    area(1),
    *pane(),
    factor(0.5),
    factor(4),
    factor(500),
    obstruction(),
    *(cube(r) for r in (0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95)),
    roof(1, bare, False),
    roof(4, bare, False),
    roof(1, glass, True),
    roof(4, glass, True),
    facade(2, 1, bare, False),
    facade(4, 3, bare, False),
    facade(2, 1, glass, True),
    facade(4, 3, glass, True),
    eaves(0.5),
    eaves(1),
    eaves(2),
    opposite(3),
    opposite(6),
    opposite(9),
    patch(),
    area(0, True),
    closed(),
]
