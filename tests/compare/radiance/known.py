# SPDX-License-Identifier: BSD-3-Clause
"""Differences from RADIANCE that docs/differences.md describes, recognised in a minimal scene.

The words that a rule stands for must be on that page (tests/compare/compare_radiance.sh looks)."""
import math


LAMPS = {"light", "spotlight", "glow", "illum"}
OPAQUE = {"plastic", "metal", "plastic2", "metal2", "ashik2", "plasfunc", "metfunc", "plasdata", "metdata"}


def has(scene, *kinds):
    return bool(set(kinds) & set(scene.kinds()))


def fresnel(scene):
    """A smooth surface of 6.0a, mirroring 8e-4 more than 6.1a's."""
    spec = {"plastic": 3, "metal": 3, "trans": 3}
    return any(p.kind in spec and p.reals[3] >= .018 and p.reals[4] == 0 for p in scene.primitives())


def pieces(scene):
    """An area light in pieces; explanation() sees that without them the difference is gone."""
    return float(scene.option("-ds", ["0"])[0]) > 0


def whole(scene):
    scene.options = [words if words[0] != "-ds" else ["-ds", "0"] for words in scene.options]


def smoothed(scene):
    """A mesh with normals that lets light through: 6.0a turns it by them; a flat one in its place shows that."""
    through = {"trans", "trans2", "transfunc", "transdata", "glass", "BRTDfunc", "WGMDfunc"}
    return any(p.kind == "mesh" and p.strings[0] == "wave.rtm" for p in scene.primitives()) and has(scene, *through)


def flat(scene):
    for p in scene.primitives():
        if p.kind == "mesh":
            p.strings[0] = p.strings[0].replace("wave.rtm", "flat.rtm")


def tree3(scene):
    return any(p.kind == "BSDF" and "tt3.xml" in p.strings for p in scene.primitives())


def matrix(scene):
    for p in scene.primitives():
        p.strings = ["klemsq.xml" if word == "tt3.xml" else word for word in p.strings]


def plain(scene):
    for p in scene.primitives():
        if p.kind == "aBSDF":
            p.modifier = "void"


def mirrored_spotlight(scene):
    return has(scene, "spotlight") and has(scene, "mirror", "prism1", "prism2") and scene.option("-dr", ["0"])[0] != "0"


def wide_beams(scene):
    for p in scene.primitives():
        if p.kind == "spotlight":
            p.reals[3] = 180


def textured_ball(scene):
    solid = has(scene, "glass", "dielectric", "interface", "BRTDfunc")
    return solid and has(scene, "sphere", "bubble") and has(scene, "texfunc")


def untextured(scene):
    for p in scene.primitives():
        if p.kind == "texfunc":
            p.strings, p.names = ["0", "0", "0", "."], ()


def at_the_rim(scene):
    """Does the ray pass a ball of glass within .01 of its radius inside its outline?"""
    if not has(scene, "glass", "dielectric", "interface"):
        return False
    eye, way = scene.rays[0][:3], scene.rays[0][3:]
    length = math.sqrt(sum(d * d for d in way))
    for p in scene.files["scene"]:
        if p.kind not in ("sphere", "bubble"):
            continue
        to = [c - e for c, e in zip(p.reals, eye)]
        along = sum(t * d for t, d in zip(to, way)) / length
        beside = math.sqrt(max(sum(t * t for t in to) - along * along, 0))
        if .99 < beside / p.reals[3] < 1.0001:
            return True
    return False


def coloured_mirror(scene):
    return has(scene, "mirror") and any(k.startswith("color") for k in scene.kinds())


def grey_mirror(scene):
    for p in scene.primitives():
        if p.kind == "mirror":
            p.reals = [.6, .6, .6]


def moving_up(scene):
    return has(scene, "BSDF", "aBSDF") and any("pict" in p.kind or "func" in p.kind or "data" in p.kind
                                               for p in scene.primitives())


def still_up(scene):
    for p in scene.primitives():
        if p.kind in ("BSDF", "aBSDF"):
            at = p.strings.index(next(word for word in p.strings if word.endswith(".xml"))) + 1
            p.strings[at:at + 3] = ["0", "0", "1"]


def listed_mist(scene):
    return any(p.kind == "mist" and p.strings for p in scene.primitives())


def unlisted(scene):
    for p in scene.primitives():
        if p.kind == "mist":
            p.strings, p.names = [], ()


def sun_in_medium(scene):
    media = has(scene, "mist", "dielectric", "interface") or scene.option("-me")
    return media and has(scene, "source") and has(scene, "light")


def clear(scene):
    """Media that absorb nothing; a surface's interface has two sides."""
    scene.options = [words for words in scene.options if words[0] != "-me"]
    for p in scene.primitives():
        if p.kind == "mist":
            p.reals[3:6] = [1, 1, 1]
        if p.kind in ("dielectric", "interface"):
            p.reals[:3] = [1, 1, 1]
        if p.kind == "interface":
            p.reals[4:7] = [1, 1, 1]


def patterned_lamp(scene):
    return has(scene, "dielectric", "interface") and any(p.kind in LAMPS and p.modifier != "void"
                                                         for p in scene.primitives())


def plain_lamps(scene):
    for p in scene.primitives():
        if p.kind in LAMPS:
            p.modifier = "void"


def bent(scene):
    return has(scene, "dielectric", "interface") and has(scene, "light", "spotlight", "glow", "illum")


def see_through(scene):
    """Nothing that stops light for good: RADIANCE remembers opaque surfaces only."""
    for p in scene.primitives():
        if p.kind in OPAQUE:
            p.kind, p.strings, p.names, p.reals = "trans", [], (), [.5, .5, .5, 0, 0, .01, 0]


def fractal_noise(scene):
    return any("fnoise3" in word for p in scene.primitives() for word in p.strings)


def plain_noise(scene):
    for p in scene.primitives():
        p.strings = [word.replace("fnoise3", "noise3") for word in p.strings]


def triangles(scene):
    return [p for p in scene.primitives() if p.kind == "polygon" and len(p.reals) == 9]


def edge_on_lamp(scene):
    """A square without a corner, over a lamp that had the same corners: its edge runs through the lamp's middle."""
    return bool(triangles(scene)) and has(scene, *LAMPS) and float(scene.option("-dj", ["0"])[0]) == 0


def off_middle(scene):
    """Larger triangles, about the corner opposite to their longest side."""
    for p in triangles(scene):
        corners = [p.reals[i:i + 3] for i in (0, 3, 6)]
        fixed = max(range(3), key=lambda k: math.dist(corners[(k + 1) % 3], corners[(k + 2) % 3]))
        p.reals = [v + .03 * (v - f) for c in corners for v, f in zip(c, corners[fixed])]


# Name, the page's words, the test, and what takes the difference away (None: the test says enough).
RULES = [
    ("edge through a lamp's middle", "runs through the middle of a lamp", edge_on_lamp, off_middle),
    ("fewer pieces", "RADIANCE takes fewer pieces for rays of low weight", pieces, whole),
    ("Fresnel of 6.0a", "6.0a's is 8.3e-4 larger at every angle", fresnel, None),
    ("smoothed meshes of 6.0a", "6.0a bends by the interpolated normal", smoothed, flat),
    ("mirrored spotlight", "narrows the beam of a spotlight in a mirror", mirrored_spotlight, wide_beams),
    ("overlapping mists", "Overlapping volumes of a mist with a list", listed_mist, unlisted),
    ("sun in a medium", "A sun in mist or in a solid", sun_in_medium, clear),
    ("patterned lamp behind a solid", "A lamp's pattern seen through a solid", patterned_lamp, plain_lamps),
    ("bent round what is remembered", "tests them on the straight line", bent, see_through),
    ("grazing chains in a textured ball", "Chains of grazing reflections", textured_ball, untextured),
    ("rim of a glass ball", "The rim of a glass ball", at_the_rim, None),
    ("mirrored light below 0", "Coloured light below 0 in a mirror", coloured_mirror, grey_mirror),
    ("up vector in a pattern's place", "in that pattern's coordinates", moving_up, still_up),
    ("fnoise3 on its grid", "within rounding of a multiple of .0005", fractal_noise, plain_noise),
    ("rank-3 tree", "A rank-3 tree that gives transmission for one side only", tree3, matrix),
    ("pattern on aBSDF", "Beside the peak of an `aBSDF` a pattern acts once", lambda scene: has(scene, "aBSDF"), plain),
]


def explanation(scene, differs):
    """The name of the first rule that explains the scene, or None.  `differs` tells whether a scene still does."""
    for name, _, test, remedy in RULES:
        if not test(scene):
            continue
        if remedy:
            other = scene.copy()
            remedy(other)
            if differs(other):
                continue
        return name
    return None
