# SPDX-License-Identifier: BSD-3-Clause
"""Differences from RADIANCE that docs/differences.md describes, recognised in a minimal scene.

A rule is a name, the words of that page it stands for (a test looks for them there), and a test of the scene."""



def has(scene, *kinds):
    return bool(set(kinds) & set(scene.kinds()))


def fresnel(scene):
    """A smooth surface of 6.0a, mirroring 8e-4 more than 6.1a's."""
    spec = {"plastic": 3, "metal": 3, "trans": 3}
    return any(p.kind in spec and p.reals[3] >= .018 and p.reals[4] == 0 for p in scene.primitives())


def pieces(scene):
    """An area light in pieces, seen by another surface than the first."""
    large = any(p.kind in ("polygon", "ring", "cylinder") for p in scene.primitives())
    lights = has(scene, "light", "spotlight", "glow", "illum")
    return float(scene.option("-ds", ["0"])[0]) > 0 and large and lights


RULES = [
    ("Fresnel of 6.0a", "6.0a's is 8.3e-4 larger at every angle", fresnel),
    ("fewer pieces", "RADIANCE takes fewer pieces for rays of low weight", pieces),
    ("aBSDF", "Samples beside the peak of an `aBSDF`", lambda scene: has(scene, "aBSDF")),
]


def explanation(scene):
    """The name of the first rule that explains the scene, or None."""
    for name, _, test in RULES:
        if test(scene):
            return name
    return None
