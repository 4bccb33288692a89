# SPDX-License-Identifier: BSD-3-Clause
"""The sixteen skies of ISO 15469 / CIE S 011, and quadrature: composite Gauss-Legendre, eight points a cell, cut
where an
integrand bends.  Nothing here is shared with lib/generators/cie_sky.cpp: that one integrates about the sun, this
one about the
zenith.  Plain Python."""

import math

pi = math.pi
SUN = (0.0, -math.cos(math.radians(60)), math.sin(math.radians(60)))  # 60 degrees high, due south; y is north
GRADATIONS = {1: (4, -0.7), 2: (1.1, -0.8), 3: (0, -1), 4: (-1, -0.55), 5: (-1, -0.32), 6: (-1, -0.15)}
INDICATRICES = {
    1: (0, -1, 0),
    2: (2, -1.5, 0.15),
    3: (5, -2.5, 0.3),
    4: (10, -3, 0.45),
    5: (16, -3, 0.3),
    6: (24, -2.8, 0.15),
}
# ISO 15469:2004, table 1: gradation and indicatrix of the types 1 to 15; 16 is (1 + 2 sin h)/3
TYPES = [
    (1, 1),
    (1, 2),
    (2, 1),
    (2, 2),
    (3, 1),
    (3, 2),
    (3, 3),
    (3, 4),
    (4, 2),
    (4, 3),
    (4, 4),
    (5, 4),
    (5, 5),
    (6, 5),
    (6, 6),
]

X = (0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363)
W = (0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763)


def nodes(a, b, n):
    """Points and weights of n equal cells from a to b."""
    h = (b - a) / n / 2
    for cell in range(n):
        middle = a + (2 * cell + 1) * h
        for x, w in zip(X, W):
            yield middle - h * x, h * w
            yield middle + h * x, h * w


def near(a, b, foot, height, cuts, per):
    """Points and weights on a to b, dense at foot: x = foot + height sinh t, cells of at most 1/per in t; cut at
cuts."""
    ends = sorted({a, b, *(c for c in (foot, *cuts) if a < c < b)})
    t = [math.asinh((x - foot) / height) for x in ends]
    return [
        (foot + height * math.sinh(s), w * height * math.cosh(s))
        for p, q in zip(t, t[1:])
        for s, w in nodes(p, q, max(1, math.ceil((q - p) * per)))
    ]


def luminances(dx, dy, dz):
    """Luminances in a direction of the upper half, of level 1: sixteen values."""
    c = max(-1.0, min(1.0, dx * SUN[0] + dy * SUN[1] + dz * SUN[2]))
    chi = math.acos(c)
    g = {k: 1 + a * math.exp(b / dz) for k, (a, b) in GRADATIONS.items()}
    p = {k: 1 + c_ * (math.exp(d * chi) - math.exp(d * pi / 2)) + e * c * c for k, (c_, d, e) in INDICATRICES.items()}
    return [g[i] * p[j] for i, j in TYPES] + [(1 + 2 * dz) / 3]


def over_sky(weight, azimuths=(0, pi), cells=6):
    """Integrals of weight(dx, dy, dz) luminance over altitude and azimuth from south, doubled for east and west."""
    total = [0.0] * 16
    zs = math.acos(SUN[2])
    for a, b, at_b in ((0, zs, True), (zs, pi / 2, False)):
        for s, ws in nodes(0, 1, cells):
            # squares: cells shrink towards the sun, and towards the horizon from the other side
            z, wz = (b - (b - a) * s * s, 2 * s * (b - a) * ws) if at_b else (a + (b - a) * s * s, 2 * s * (b - a) * ws)
            for u, wu in nodes(0, 1, cells):
                azimuth = azimuths[0] + (azimuths[1] - azimuths[0]) * u**3
                d = (math.sin(z) * math.sin(azimuth), -math.sin(z) * math.cos(azimuth), math.cos(z))
                w = 2 * weight(*d) * math.sin(z) * wz * wu * 3 * u * u * (azimuths[1] - azimuths[0])
                for k, value in enumerate(luminances(*d)):
                    total[k] += w * value
    return total


def horizontal(cells=6):
    return over_sky(lambda x, y, z: z, cells=cells)


LEVEL = [1 / e for e in horizontal()]  # of a sky whose horizontal illuminance is 1
GROUND = 0.3 / pi  # luminance of the ground at infinity, reflectance .3


def glass(cosine, n=1.52, t=0.9584):
    """Transmittance of a pane: Fresnel, two polarisations, all inner reflections; t the inner transmittance at the
normal."""
    if cosine <= 0:
        return 0.0
    inner = math.sqrt(1 - (1 - cosine * cosine) / (n * n))
    d = t ** (1 / inner)
    total = 0
    for r in (((cosine - n * inner) / (cosine + n * inner)) ** 2, ((n * cosine - inner) / (n * cosine + inner)) ** 2):
        total += (1 - r) ** 2 * d / (1 - r * r * d * d) / 2
    return total


# Tregenza's polynomial of clear glass of 6 mm, by powers of the cosine, as quoted in public as the report's own formula
# (discourse.radiance-online.org, thread 1053)
POLYNOMIAL = (-0.028378, 3.156075, -3.058376, -1.428919, 4.014235, -1.775827)


def polynomial(cosine):
    return max(0.0, sum(c * cosine**k for k, c in enumerate(POLYNOMIAL)))


def bare(_cosine):
    return 1.0


def rectangle(point, normal, axis, at, u, v, light, cuts_u=(), cuts_v=(), per=2.0):
    """Integral of light(direction, cosine at the plane) cos cos'/d^2 over a rectangle at coordinate `at` of `axis`;
u and v are
    its limits along the two other axes in order.  light gives a list; cells are dense at the foot of the point."""
    others = [k for k in range(3) if k != axis]
    h = abs(at - point[axis])
    total = None
    vs = near(*v, point[others[1]], h, cuts_v, per)
    for pu, wu in near(*u, point[others[0]], h, cuts_u, per):
        for pv, wv in vs:
            d = [0.0] * 3
            d[axis], d[others[0]], d[others[1]] = at - point[axis], pu - point[others[0]], pv - point[others[1]]
            length = math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
            d = [c / length for c in d]
            cosine = d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2]
            if cosine <= 0:
                continue
            w = wu * wv * cosine * abs(d[axis]) / (length * length)
            values = light(d, abs(d[axis]))
            if total is None:
                total = [0.0] * len(values)
            for k, value in enumerate(values):
                total[k] += w * value
    return total


def sky_light(tau):
    """light of rectangle(): the sixteen skies above the horizon, the ground below it, behind a pane."""

    def light(d, cosine):
        t = tau(cosine)
        return [t * GROUND] * 16 if d[2] <= 0 else [t * a * b for a, b in zip(LEVEL, luminances(*d))]

    return light
