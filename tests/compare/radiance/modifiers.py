# SPDX-License-Identifier: BSD-3-Clause
"""Random patterns, textures and mixtures of them.  Files they read: parts/ and some of tests/golden/vectors."""
from expressions import bump, coefficient, number, share
from scene import Primitive

WORDS = ["AB", "A BA", "BAB A", "IA BI"]


class Modifiers:
    """Adds modifiers to `out`, a list of primitives; each method gives the name of what it added."""

    def __init__(self, rng, out):
        self.rng, self.out, self.count = rng, out, 0

    def add(self, modifier, kind, strings=(), reals=(), names=()):
        self.count += 1
        p = Primitive(modifier, kind, f"{kind}_{self.count}", strings, reals, names)
        self.out.append(p)
        return p.name

    def transform(self):
        """The xform options of a function: mostly none."""
        r = self.rng
        if r.random() < .7:
            return []
        parts = [["-rx", str(r.randint(-90, 90))], ["-rz", str(r.randint(-180, 180))], ["-s", str(number(r, .5, 2))],
                 ["-t", str(number(r, -1, 1)), str(number(r, -1, 1)), ".1"], ["-mx"], ["-ry", "30", "-my"]]
        return [word for part in r.sample(parts, r.randint(1, 3)) for word in part]

    def frame(self):
        """Origin, right and down of a text, in a random plane."""
        r = self.rng
        size = number(r, .2, .6)
        right, down = r.choice([((1, 0, 0), (0, -1, 0)), ((0, 1, 0), (0, 0, -1)), ((1, 0, .3), (.2, 0, -1)),
                                ((1, .2, 0), (.1, -2, 0))])
        return [number(r, -2, 0), number(r, 0, 2), number(r, 0, 2)] + [size * v for v in right + down]

    def coordinates(self, n):
        return [share(self.rng) for _ in range(n)]

    def pattern(self, modifier):
        r = self.rng
        kind = r.choices(["colorfunc", "brightfunc", "colordata", "brightdata", "colorpict", "colortext", "brighttext"],
                         [4, 3, 1, 2, 2, 1, 1])[0]
        if kind == "colorfunc":
            return self.add(modifier, kind, [share(r), share(r), share(r), "."] + self.transform())
        if kind == "brightfunc":
            return self.add(modifier, kind, [share(r), "."] + self.transform())
        if kind == "colordata":
            strings = ["red", "green", "blue"] + ["steps.dat"] * 3 + ["."] + self.coordinates(1)
            return self.add(modifier, kind, strings + self.transform())
        if kind == "brightdata":
            name, n = r.choice([("steps.dat", 1), ("field.dat", 2)])
            function = r.choice(["noop", "clip", "sq", "noneg"])
            return self.add(modifier, kind, [function, name, "."] + self.coordinates(n) + self.transform())
        if kind == "colorpict":
            functions = r.choice([["red", "green", "blue"], ["clip_r", "clip_g", "clip_b"], ["grey"] * 3,
                                  ["blue", "red", "green"]])
            u, v = r.choice([("frac(Px+.013)", "frac(Py+.013)"), ("frac(Py+.3)", "frac(Pz+.013)"),
                             ("Px/4+.5", "Py/4+.5")])
            return self.add(modifier, kind, functions + ["small.hdr", ".", u, v] + self.transform())
        words = r.choice(WORDS).split()
        font = [r.choice(["tiny.fnt", "tri2.fnt"]), "."] + words
        spacing = r.choice([[], [], [0], [.2], [-.2], [.5]])
        if kind == "colortext":
            colours = [number(r, 0, 1) for _ in range(6)]
            return self.add(modifier, kind, font, self.frame() + colours + spacing)
        return self.add(modifier, kind, font, self.frame() + [number(r, .5, 1), number(r, 0, .5)] + spacing)

    def texture(self, modifier):
        r = self.rng
        if r.random() < .85:
            return self.add(modifier, "texfunc", [bump(r), bump(r), bump(r), "."] + self.transform())
        strings = ["tenth", "none", "tenth"] + ["steps.dat"] * 3 + ["compare.cal"] + self.coordinates(1)
        return self.add(modifier, "texdata", strings + self.transform())

    def mixture(self, modifier, fore, back):
        """Of two modifiers of whatever sort."""
        r = self.rng
        kind = r.choices(["mixfunc", "mixdata", "mixpict", "mixtext"], [5, 1, 1, 1])[0]
        if kind == "mixfunc":
            strings = [fore, back, coefficient(r), "."] + self.transform()
        elif kind == "mixdata":
            strings = [fore, back, "clip", "steps.dat", "."] + self.coordinates(1) + self.transform()
        elif kind == "mixpict":
            function = r.choice(["clipgrey", "clip_r"])
            strings = [fore, back, function, "small.hdr", ".", "frac(Px+.013)", "frac(Py+.013)"] + self.transform()
        else:
            strings = [fore, back, "tiny.fnt", "."] + r.choice(WORDS).split()
            return self.add(modifier, kind, strings, self.frame() + r.choice([[], [.2], [-.2]]), (0, 1))
        return self.add(modifier, kind, strings, [], (0, 1))

    def chain(self, textures=True, depth=0):
        """void, or some patterns, textures, aliases and mixtures one upon the other."""
        r = self.rng
        name = "void"
        while r.random() < (.5 if name == "void" else .3):
            p = r.random()
            if p < .2 and textures:
                name = self.texture(name)
            elif p < .3 and depth < 2:
                name = self.mixture(name, self.chain(textures, depth + 1), self.chain(textures, depth + 1))
            else:
                name = self.pattern(name)
        return name
