# SPDX-License-Identifier: BSD-3-Clause
"""Random materials and lights, each with its chain of modifiers."""
from expressions import number, share, wave
from modifiers import Modifiers

# Kind and how often.  `closed`: only for closed surfaces.
OPAQUE = [("plastic", 6), ("metal", 3), ("trans", 4), ("plastic2", 1), ("metal2", 1), ("trans2", 1), ("ashik2", 1),
          ("glass", 4), ("plasfunc", 1), ("metfunc", 1), ("transfunc", 1), ("plasdata", 1), ("metdata", .5),
          ("transdata", .5), ("BRTDfunc", 2), ("WGMDfunc", 1), ("BSDF", 1), ("aBSDF", .5), ("mirror", 1),
          ("prism1", .5), ("prism2", .5), ("glow", 1), ("illum", .5)]
TABLES = ["klemsq.xml", "tt3.xml", "tt4.xml"]
CLOSED = [("dielectric", 3), ("interface", 1), ("mist", 1), ("antimatter", 1)]


class Materials(Modifiers):
    def __init__(self, rng, out, options):
        super().__init__(rng, out)
        self.bumps, self.tables = options["textures"], options["tables"]

    def modifier(self):
        return self.chain(self.bumps)

    def colour(self, low=.1, high=.9):
        return [number(self.rng, low, high) for _ in range(3)]

    # RADIANCE 6.0a's Fresnel term is 8e-4 larger than 6.1a's.  It shows in smooth materials, so their gloss stays below
    # .018 here, where there is no such term; mirror, glass and dielectric do not have it.
    def finish(self, strong):
        rough = self.rng.choice([.03, .1, .2]) if strong else self.rough()
        if strong:
            return [number(self.rng, .3, 1), rough]
        return [self.specular() if rough else self.rng.choice([0, 0, .01]), rough]

    def rough(self):
        return self.rng.choice([0, 0, 0, .03, .1, .2])

    def specular(self):
        return self.rng.choice([0, 0, .02, .05, .2])

    def up(self):
        # never along a normal: an error in RADIANCE
        return self.rng.choice([[".9", ".23", ".17"], [".1", "1", ".27"], [".2", ".11", "1"],
                                ["Nz+.21", "Nx+.13", "Ny+.32"]])

    def plain(self, kind):
        """Strings, reals and the places of names of a material of that kind."""
        r = self.rng
        colour, spec = self.colour(), self.specular()
        if kind in ("metal", "metal2", "metfunc", "metdata"):
            spec = number(r, .3, 1)
        through = [number(r, .1, .9), r.choice([0, .3, 1, number(r, 0, 1)])]
        uneven = [r.choice([.05, .1, .2]), r.choice([.08, .15])]
        lobe = [r.choice(["cosine_power", "local_lobe"]), "compare.cal"] + self.transform()
        shade = [r.choice(["noop", "sq"]), "steps.dat", "compare.cal", r.choice(["along", "upward"])] + self.transform()
        rows = {
            "plastic": lambda: ([], colour + self.finish(False)),
            "metal": lambda: ([], self.colour(.4, .9) + self.finish(True)),
            "trans": lambda: ([], colour + self.finish(False) + through),
            "plastic2": lambda: (self.up() + ["."] + self.transform(), colour + [spec] + uneven),
            "metal2": lambda: (self.up() + ["."] + self.transform(), colour + [spec] + uneven),
            "trans2": lambda: (self.up() + ["."] + self.transform(), colour + [spec] + uneven + through),
            "ashik2": lambda: (self.up() + ["."] + self.transform(),
                               self.colour(0, .5) + self.colour(0, .3) + [20, 60]),
            "glass": lambda: ([], colour + r.choice([[], [1.4], [1.7]])),
            "dielectric": lambda: ([], colour + [number(r, 1.1, 1.8), r.choice([0, 0, 5])]),
            "interface": lambda: ([], colour + [number(r, 1.1, 1.8)] + self.colour(.5, 1) + [r.choice([1, 1.3])]),
            "mirror": lambda: ([], colour),
            "plasfunc": lambda: (lobe, colour + [max(spec, .1), 4]),
            "metfunc": lambda: (lobe, colour + [spec, 4]),
            "transfunc": lambda: (lobe, colour + [max(spec, .1)] + through + [3]),
            "plasdata": lambda: (shade, colour + [max(spec, .1)]),
            "metdata": lambda: (shade, colour + [spec]),
            "transdata": lambda: (shade, colour + [max(spec, .1)] + through),
            "BRTDfunc": lambda: (self.brtd(), self.colour(0, .6) + self.colour(0, .6) + self.colour(0, .3)),
            "BSDF": lambda: ([r.choice(["0", "0", ".1"]), r.choice(TABLES)] + self.up() + ["."],
                             r.choice([[], self.colour(0, .3), self.colour(0, .3) * 2, self.colour(0, .2) * 3])),
            "aBSDF": lambda: (["peak.xml"] + self.up() + ["."], r.choice([[], self.colour(0, .3)])),
            "prism1": lambda: ([".8", ".1*" + wave(r), ".13", "Dz", "."], []),
            "prism2": lambda: ([".4", ".1", ".13", "Dz", ".3", "-.1", ".13", "Dz", "."], []),
            "glow": lambda: ([], self.colour(.1, 2) + [r.choice([0, 0, -1])]),
        }
        return rows[kind]()

    def brtd(self):
        r = self.rng
        parts = [f"clip({share(r)})/2" if r.random() < .5 else "0" for _ in range(6)]
        lobes = r.choice([["0", "0", "0", "."], ["frontlobe", "frontlobe", "frontlobe", "compare.cal"]])
        return parts + lobes + self.transform()

    def wgmd(self):
        r = self.rng
        inner = [r.choice(["void", "inherit", self.modifier()]) for _ in range(3)]
        strings = [inner[0], str(number(r, 0, .3)), str(self.rough()), str(self.rough()),
                   inner[1], str(number(r, 0, .3)), str(self.rough()), str(self.rough()), inner[2]] + self.up() + ["."]
        reals = self.colour(0, .5) + self.colour(0, .5) + self.colour(0, .3)
        return self.add(self.modifier(), "WGMDfunc", strings, reals, (0, 4, 8))

    def illum(self):
        r = self.rng
        alternate = [] if r.random() < .3 else [r.choice(["void", self.material(2)])]
        return self.add(self.modifier(), "illum", alternate, self.colour(.1, 1), (0,) if alternate else ())

    def material(self, depth=0, shines=True):
        """A material for any surface, or a mixture of two; with `shines` it may be a source of light."""
        r = self.rng
        if depth < 2 and r.random() < .15:
            fore = self.material(depth + 1)
            back = "void" if r.random() < .25 else self.material(depth + 1)
            return self.mixture("void", *r.sample([fore, back], 2))
        kinds = [k for k in OPAQUE if self.tables or k[0] not in ("BSDF", "aBSDF")]
        kinds = [k for k in kinds if shines or k[0] not in ("illum", "glow")]
        kinds = [k for k in kinds if depth == 0 or k[0] not in ("illum", "mirror", "prism1", "prism2", "glow")]
        kind = r.choices([k for k, _ in kinds], [w for _, w in kinds])[0]
        if kind == "WGMDfunc":
            return self.wgmd()
        if kind == "illum":
            return self.illum()
        if kind == "mirror" and r.random() < .4:
            alternate = self.material(2)
            return self.add(self.modifier(), kind, [alternate], self.colour(), (0,))
        strings, reals = self.plain(kind)
        return self.add(self.modifier(), kind, strings, reals)

    def closed(self, lamps):
        """A material for a closed surface; `lamps` are the names of light materials, for mist."""
        r = self.rng
        kind = r.choices([k for k, _ in CLOSED], [w for _, w in CLOSED])[0]
        if kind == "mist":
            reals = [number(r, .05, .4) for _ in range(3)] + self.colour(.2, .9) + [r.choice([0, .4, -.3])]
            listed = [r.choice(lamps)] if lamps and r.random() < .7 else []
            return self.add("void", kind, listed, reals, tuple(range(len(listed))))
        if kind == "antimatter":
            first = r.choice(["void", self.material(2)])
            others = [p.name for p in self.out if p.kind in ("plastic", "metal", "glass", "dielectric")][:2]
            strings = [first] + (others or ["void"])
            return self.add("void", kind, strings, [], tuple(range(len(strings))))
        strings, reals = self.plain(kind)
        return self.add(self.modifier(), kind, strings, reals)

    def light(self, kind, radiance, distant=False):
        r = self.rng
        modifier = "void"
        if distant and r.random() < .3:  # by direction alone, see docs/differences.md
            parts = [f"{number(r, .2, 1)}+.4*{v}" for v in r.sample(["Dx^2", "Dy^2", "abs(Dz)"], 3)]
            modifier = self.add("void", "colorfunc", parts + ["."])
        elif not distant and r.random() < .3:
            modifier = self.chain(False)
        return self.add(modifier, kind, [], [radiance * number(r, .5, 1) for _ in range(3)])
