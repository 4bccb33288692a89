# SPDX-License-Identifier: BSD-3-Clause
"""Cases under lamps and the sun."""

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


POLAR = (0, 15, 30, 45, 60)  # degrees from the nadir
AROUND = tuple(range(0, 361, 40))  # degrees from x to y
CANDELA = [[round(800 + 3 * p * math.cos(math.radians(a - 50)) - 0.1 * p * p) for a in AROUND] for p in POLAR]
# from the lamp to the point, against the ray
CANDELA_CAL = """{ nadir angle and azimuth of the way from the lamp }
value(v) = v;
polar = Acos(Dz) * 180/PI;
around = if(atan2(-Dy,-Dx), atan2(-Dy,-Dx), atan2(-Dy,-Dx) + 2*PI) * 180/PI;
"""


def candela(x, y):
    """Intensity toward a point of the floor 3 m below, bilinear in the table."""
    polar, around = math.degrees(math.atan2(math.hypot(x, y), 3)), math.degrees(math.atan2(y, x)) % 360
    i, j = min(int(polar / 15), 3), min(int(around / 40), 8)
    u, v = polar / 15 - i, around / 40 - j
    rows = [CANDELA[i + k][j] * (1 - v) + CANDELA[i + k][j + 1] * v for k in (0, 1)]
    return rows[0] * (1 - u) + rows[1] * u


def asymmetric():
    """A lamp of 5 x 10 angles, of ours: the report's is not at hand."""
    size = 0.001
    text = "2\n0 60 5\n0 360 10\n" + "\n".join(" ".join("%d" % c for c in row) for row in CANDELA) + "\n"
    scene = "void brightdata table 5 value lamp.dat lamp.cal polar around 0 0\n"
    scene += "table light lamp_light 0 0 3 {0:.9g} {0:.9g} {0:.9g}\n".format(1 / (pi * size**2) / WHITE_EFFICACY)
    scene += "lamp_light sphere lamp 0 0 4 0 0 3 %g\n" % size
    scene += plastic("plate", 0.5) + flat("plate", "floor", 2, 0, (-2, 2), (-2, 2))
    points = {"A": (0.3, 0.2), "B": (1.5, 0.2), "C": (0.4, 1.7), "D": (-1.1, 1.3), "E": (-1.6, -0.4), "F": (0.9, -1.5)}
    return Case(
        "5.2, asymmetric",
        "lamp of a table of 5 x 10 intensities 3 m over a floor",
        scene,
        {n: ((x, y, 0), UP) for n, (x, y) in points.items()},
        lambda p, n, per: [candela(p[0], p[1]) * 3 / (p[0] ** 2 + p[1] ** 2 + 9) ** 1.5],
        by="plate",
        options="-ab 0",
        name="lx",
        files={"lamp.dat": text, "lamp.cal": CANDELA_CAL},
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


def clock():
    """A day whose declination is 0 (22 March, no year given), in solar time: the sun's place in closed form.
    Sensors face up, east and south."""
    latitude, hour = math.radians(52), math.radians(15 * (9 - 12))
    way = (-math.sin(hour), -math.cos(hour) * math.sin(latitude), math.cos(hour) * math.cos(latitude))
    normal_irradiance = 100 / WHITE_EFFICACY
    scene = "!genciesky 5 3 22 +9 -a 52 -B 0 -R %.9g\n" % (normal_irradiance * way[2])
    return Case(
        "6, sun by the clock",
        "the sun at 9 h of solar time at an equinox, 52 degrees north",
        scene,
        {"up": ((0, 0, 0), UP), "east": ((0, 0, 0), (1, 0, 0)), "south": ((0, 0, 0), SOUTH)},
        lambda p, n, per: [100 * sum(a * b for a, b in zip(way, n))],
        by="sensors",
        options="-ab 0",
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
