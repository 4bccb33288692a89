# SPDX-License-Identifier: BSD-3-Clause
"""Differences from RADIANCE that docs/differences.md describes, recognised in a minimal scene.

A rule is a name, the words of that page it stands for (a test looks for them there), and a test of the scene."""

RULES = []


def explanation(scene):
    """The name of the first rule that explains the scene, or None."""
    for name, _, test in RULES:
        if test(scene):
            return name
    return None
