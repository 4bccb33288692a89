# SPDX-License-Identifier: BSD-3-Clause
"""Cases once more in another form, by sensors or with a mesh; CASES is the list of all."""

import copy

from conservation import *


def by_sensors(case, options=None):
    """The same by ptrace -points, whose hemisphere is the first bounce of -ab."""
    other = copy.copy(case)
    other.number, other.by = case.number + ", sensors", "sensors"
    other.options = options or case.options
    return other


def mesh(name, corners, normal):
    """A quadrilateral as two triangles of a Wavefront file with normals at its corners."""
    text = "".join("v %.9g %.9g %.9g\n" % c for c in corners)
    return {name: text + "vn %g %g %g\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n" % normal}


def meshes():
    """S2 of 5.6 and the lamp of 5.3 as meshes: light from their right sides alone."""
    square = copy.copy(factor(4))
    square.number += ", mesh"
    square.scene = sun(35, 1 / math.sin(math.radians(35))) + plastic("grey", 0.3) + "grey mesh s2 1 s2.obj 0 0\n"
    square.files = mesh("s2.obj", [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)], UP)
    lamp = copy.copy(area(0))
    lamp.number += ", mesh"
    level = "{0:.9g} {0:.9g} {0:.9g} 0".format(1000 / WHITE_EFFICACY)
    lamp.scene = "void glow lamp_glow 0 0 4 %s\nlamp_glow mesh lamp 1 lamp.obj 0 0\n" % level + BLACK + room()
    h = 2.9999999
    lamp.files = mesh("lamp.obj", [(1.5, 1.5, h), (1.5, 2.5, h), (2.5, 2.5, h), (2.5, 1.5, h)], DOWN)
    return [square, lamp]


CASES = [
    lamp_over_floor("Lambert"),
    lamp_over_floor("isotropic"),
    asymmetric(),
    area(0),
    area(1),
    by_sensors(area(0)),
    by_sensors(area(1)),
    *openings(),
    *pane(),
    factor(0.5),
    factor(4),
    factor(500),
    *meshes(),
    obstruction(),
    *(cube(r) for r in (0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95)),
    *spheres(),
    roof(1, bare),
    roof(4, bare),
    roof(1, glass),
    roof(4, glass),
    roof(1, polynomial),
    roof(4, polynomial),
    by_sensors(roof(1, glass)),
    facade(2, 1, bare),
    facade(4, 3, bare),
    facade(2, 1, glass),
    facade(4, 3, glass),
    facade(2, 1, polynomial),
    facade(4, 3, polynomial),
    by_sensors(facade(2, 1, glass)),
    eaves(0.5),
    eaves(1),
    eaves(2),
    by_sensors(eaves(1), "-ab 2"),
    opposite(3),
    opposite(6),
    opposite(9),
    patch(),
    clock(),
    area(0, True),
    closed(),
]
