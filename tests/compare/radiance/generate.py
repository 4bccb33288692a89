# SPDX-License-Identifier: BSD-3-Clause
"""A random scene from a seed: a floor, things on a grid, lights above, options, rays.  Same seed, same scene."""
import math
import random

from expressions import number
from materials import Materials
from scene import Primitive, Scene

GROUND = -.0137  # no coordinate of a plane is a round number: patterns jump there
CELLS = [(x, y) for x in (-2.4, 0, 2.4) for y in (-2.4, 0, 2.4)]


def rotated(rng, points, tilt):
    """Points turned about x by up to `tilt` degrees, then about z by any angle."""
    a, b = math.radians(rng.uniform(-tilt, tilt)), rng.uniform(0, 2 * math.pi)
    result = []
    for x, y, z in points:
        y, z = y * math.cos(a) - z * math.sin(a), y * math.sin(a) + z * math.cos(a)
        result.append((x * math.cos(b) - y * math.sin(b), x * math.sin(b) + y * math.cos(b), z))
    return result


class World:
    def __init__(self, seed, coincident):
        self.rng, self.scene, self.coincident = random.Random(seed), Scene(), coincident
        self.list, self.count = self.scene.files["scene"], 0
        self.options()
        self.materials = Materials(self.rng, self.list, self.kinds)
        self.lamps = []

    def options(self):
        r, words = self.rng, self.scene.options
        self.indirect = r.choices([0, 1, 2], [8, 1.5, .5])[0]
        words.append(["-ab", str(self.indirect)])
        if self.indirect:
            words.append(["-ad", "16"])
        words += [["-dj", "0"], ["-lr", "8"], ["-lw", "0"], ["-ss", r.choice(["0", "0", "0", "1"])]]
        sampled = self.scene.option("-ss")[0] != "0"
        words.append(["-st", r.choice(["0", ".1"]) if not sampled else "0"])
        self.kinds = {"textures": not self.indirect, "tables": sampled}
        words.append(["-ds", r.choice(["0", "0", "0", "0", "0", "0", "0", ".25", ".1"])])
        words.append(["-dr", r.choice(["0", "1", "2"])])
        rare = [["-bv-"], ["-dv-"], ["-av", ".2", ".1", ".3"], ["-i+"], ["-me", ".05", ".1", ".02"],
                ["-ma", ".8", ".5", ".9"], ["-mg", ".3"]]
        words += [option for option in rare if r.random() < (.04 if option[0] == "-i+" else .08)]

    def surface(self, material, kind, reals, strings=()):
        self.count += 1
        self.list.append(Primitive(material, kind, f"s{self.count}", strings, reals))
        if self.coincident and kind not in ("source", "instance", "mesh") and self.rng.random() < .4:
            self.twin(kind, reals)

    def twin(self, kind, reals):
        """Another surface in the same place: corners of the same numbers lie in one plane to the last digit."""
        r = self.rng
        material = self.materials.material(shines=False)
        if kind == "polygon":
            corners = [reals[i:i + 3] for i in range(0, len(reals), 3)]
            if len(corners) == 4 and r.random() < .4:
                corners.pop(r.randrange(4))
            if r.random() < .5:
                corners.reverse()
            reals = [v for corner in corners for v in corner]
        elif kind == "ring" and r.random() < .5:
            reals = reals[:3] + [-v for v in reals[3:6]] + reals[6:]
        else:
            other = {"sphere": "bubble", "bubble": "sphere", "cylinder": "tube", "tube": "cylinder", "cone": "cup"}
            kind = other.get(kind, kind) if r.random() < .5 else kind
        self.count += 1
        self.list.append(Primitive(material, kind, f"s{self.count}", (), reals))

    def quad(self, material, centre, half, tilt):
        rng = self.rng
        corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
        if rng.random() < .2:
            corners = corners[:3]
        points = rotated(rng, corners, tilt)
        self.surface(material, "polygon", [c + half * v for p in points for c, v in zip(centre, p)])

    def box(self, material, low, high):
        """Six polygons that face outward."""
        for axis in range(3):
            for side in (0, 1):
                u, v = (axis + 1) % 3, (axis + 2) % 3
                loop = [(0, 0), (1, 0), (1, 1), (0, 1)]
                reals = []
                for a, b in loop if side else loop[::-1]:
                    point = [0.0] * 3
                    point[axis] = (low, high)[side][axis]
                    point[u], point[v] = (low, high)[a][u], (low, high)[b][v]
                    reals += point
                self.surface(material, "polygon", reals)

    def thing(self, x, y):
        r = self.rng
        material = self.materials.material()
        centre = (x, y, number(r, .6, 1.4))
        kinds = ["quad", "sphere", "bubble", "ring", "cylinder", "tube", "cone", "box"]
        kind = r.choices(kinds, [5, 3, .5, 1, 1, .5, 1, 1])[0]
        if kind == "quad":
            self.quad(material, centre, number(r, .6, 1), 80)
        elif kind in ("sphere", "bubble"):
            self.surface(material, kind, list(centre) + [number(r, .4, .9)])
        elif kind == "box":
            low = [c - number(r, .3, .6) - .0119 for c in centre]
            self.box(material, low, [c + number(r, .3, .6) + .0083 for c in centre])
        else:
            axis = rotated(r, [(0, 0, 1)], 90)[0]
            top = [c + a for c, a in zip(centre, axis)]
            reals = {"ring": list(centre) + list(axis) + [r.choice([0, .3]), .8],
                     "cone": list(centre) + top + [r.choice([.2, .7]), r.choice([0, .4])]}
            self.surface(material, kind, reals.get(kind, list(centre) + top + [.4]))

    def volume(self, x, y):
        r = self.rng
        material = self.materials.closed(self.lamps)
        centre = (x, y, number(r, .7, 1.1))
        if r.random() < .5:
            self.surface(material, "sphere", list(centre) + [number(r, .4, .9)])
        else:
            low = [c - number(r, .3, .6) - .0119 for c in centre]
            self.box(material, low, [c + number(r, .3, .6) + .0083 for c in centre])

    def instance(self, x, y):
        """One or two things in an octree of their own, turned, scaled and moved; seldom twice, nested."""
        r = self.rng
        stem = f"inner{len(self.scene.files)}"
        outer, self.list = self.list, []
        self.scene.files[stem] = self.list
        materials, self.materials = self.materials, Materials(r, self.list, self.kinds)
        for _ in range(r.randint(1, 2)):
            self.thing(number(r, -.4, .4), number(r, -.4, .4))
        if len(self.scene.files) < 4 and r.random() < .15:
            self.instance(.3, .2)
        self.list, self.materials = outer, materials
        modifier = materials.material() if r.random() < .15 else "void"
        transform = ["-rz", str(r.randint(-180, 180)), "-rx", str(r.randint(-20, 20))]
        transform += r.choice([[], ["-mx"], ["-my"]])
        transform += ["-s", r.choice([".7", "1", "1.1"]), "-t", str(x), str(y), ".1"]
        self.surface(modifier, "instance", [], [stem + ".oct"] + transform)

    def mesh(self, x, y):
        r = self.rng
        strings = [r.choice(["wave.rtm", "quad.rtm"]), "-rx", str(r.randint(-70, 70)), "-rz", str(r.randint(-90, 90)),
                   "-s", ".9", "-t", str(x), str(y), "1"]
        self.surface(self.materials.material(shines=False), "mesh", [], strings)

    def lights(self):
        r, m = self.rng, self.materials
        kinds = r.sample(["sun", "lamp", "panel", "spot", "sky", "glow", "sun"], r.randint(1, 3))
        for kind in kinds:
            spot = [number(r, -3, 3), number(r, -3, 3), number(r, 3.5, 5)]
            if kind == "sun":
                up = [number(r, -1, 1), number(r, -1, 1), number(r, .3, 1)]
                self.surface(m.light("light", 3000, True), "source", up + [r.choice([.5, 2, 5])])
            elif kind == "sky":
                name = m.light("glow", 1, True)
                self.list[-1].reals.append(0)
                self.surface(name, "source", [0, 0, 1, r.choice([180, 360])])
            elif kind == "lamp":
                self.lamps.append(m.light("light", 300))
                self.surface(self.lamps[-1], "sphere", spot + [.1])
            elif kind == "panel":
                self.lamps.append(m.light("light", 30))
                self.quad_down(self.lamps[-1], spot, .5)
            elif kind == "glow":
                name = m.light("glow", 20)
                self.list[-1].reals.append(number(r, 3, 9))
                self.quad_down(name, spot, .4)
            else:
                name = m.light("spotlight", 500)
                aim = [-spot[0] / 5, -spot[1] / 5, -1]
                self.list[-1].reals += [r.choice([30, 60, 90])] + aim
                self.lamps.append(name)
                self.surface(name, "sphere", spot + [.1])

    def quad_down(self, material, centre, half):
        x, y, z = centre
        self.surface(material, "polygon", [x - half, y - half, z, x - half, y + half, z,
                                           x + half, y + half, z, x + half, y - half, z])

    def resting_eye(self):
        """On the floor or a side of a box, which lie in planes to the last digit."""
        r = self.rng
        eye = [number(r, -3, 3), number(r, -3, 3), GROUND]
        flat = [p.reals for p in self.scene.files["scene"] if p.kind == "polygon" and len(p.reals) == 12
                and any(len({p.reals[i] for i in (a, a + 3, a + 6, a + 9)}) == 1 for a in range(3))]
        if flat and r.random() < .7:
            reals, share = r.choice(flat), [r.uniform(.1, .9), r.uniform(.1, .9)]
            across = [[reals[3 * k + a] - reals[a] for a in range(3)] for k in (1, 3)]
            eye = [reals[a] + share[0] * across[0][a] + share[1] * across[1][a] for a in range(3)]
        return eye

    def rays(self, count, resting):
        r = self.rng
        for _ in range(count):
            target = [r.uniform(-3.4, 3.4), r.uniform(-3.4, 3.4), r.uniform(0, 2.2)]
            if r.random() < .6:
                a, z = r.uniform(0, 2 * math.pi), r.uniform(.4, 6)
                eye = [7 * math.cos(a), 7 * math.sin(a), z]
            else:
                eye = [r.uniform(-3.4, 3.4), r.uniform(-3.4, 3.4), r.uniform(.2, 3)]
            if resting:
                eye = self.resting_eye()
                target[2] += r.choice([0, 2])
            ray = eye + [t - e for t, e in zip(target, eye)]
            self.scene.rays.append(tuple(float(f"{v:.6g}") for v in ray))


def generate(seed, ray_count, coincident=False, resting=False, volumes=True):
    """coincident: surfaces lie in one place with others; resting: eyes on surfaces; volumes: of what absorbs light."""
    world = World(seed, coincident)
    r = world.rng
    world.lights()
    floor = world.materials.add(world.materials.modifier(), "plastic", [], world.materials.colour() + [0, 0])
    world.surface(floor, "polygon", [-5, -5, GROUND, 5, -5, GROUND, 5, 5, GROUND, -5, 5, GROUND])
    if r.random() < .3:
        wall = [-4, 4.0173, GROUND, 4, 4.0173, GROUND, 4, 4.0173, 3, -4, 4.0173, 3]
        world.surface(world.materials.material(), "polygon", wall)
    for x, y in r.sample(CELLS, r.randint(2, 5)):
        maker = r.choices([world.thing, world.volume, world.instance, world.mesh],
                          [7, 2 if volumes else 0, 1.5, .7])[0]
        maker(x, y)
    world.rays(ray_count // 4 if world.indirect else ray_count, resting)  # those take a hundred times as long
    world.scene.prune()
    return world.scene
