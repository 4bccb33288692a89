# SPDX-License-Identifier: BSD-3-Clause
"""A scene that shows a difference, made as small as it goes with the difference still there.

Each step proposes a simpler scene; it is kept if oconv and both programs take it and one ray still differs.  Steps: one
ray, fewer surfaces (halves, quarters, ones), modifiers by-passed, options left out, strings and numbers made simple."""
import tempfile

import tracers
from judge import judge

# Options a row keeps: what rtrace takes without them depends on its version.
BASE = {"-ab", "-ad", "-dj", "-lr", "-lw", "-ds", "-ss", "-st", "-dr"}
SIMPLE_STRINGS = ["0", ".5", "Px"]
NOT_NOTHING = [".5", "Px"]  # of a BSDF's up vector: 0 0 0 is another difference


class Shrinker:
    def __init__(self, scene, ray, floor, bed, tracer, extra, budget):
        self.best, self.floor, self.bed, self.tracer, self.extra = scene.copy(), floor, bed, tracer, extra
        self.best.rays = [ray]
        self.left = budget

    def shows(self, scene):
        if self.left <= 0:
            return False
        self.left -= 1
        return self.differs(scene)

    def differs(self, scene):
        """By more than one in a hundred: a shadow caused by rounding is not enough."""
        with tempfile.TemporaryDirectory() as folder:
            self.bed(folder)
            if scene.write(folder):
                return False
            try:
                _, wrong = judge(scene, folder, self.tracer, self.extra, 2, 3, self.floor)
            except tracers.Refused:
                return False
            return any(p.deviation() > .005 for p in wrong)

    def keep(self, scene):
        scene.prune()
        if scene.files["scene"] and self.shows(scene):
            self.best = scene
            return True
        return False

    def without(self, doomed):
        scene = self.best.copy()
        for stem, list_ in scene.files.items():
            scene.files[stem] = [p for i, p in enumerate(list_) if (stem, i) not in doomed]
        return scene

    def fewer_surfaces(self):
        size = None
        while True:
            places = [(stem, i) for stem, list_ in self.best.files.items()
                      for i, p in enumerate(list_) if p.is_surface()]
            size = min(size or len(places), len(places)) // 2 or 1
            gone = False
            for at in range(len(places) - size, -1, -size):
                if self.keep(self.without(set(places[at:at + size]))):
                    gone = True
                    break
            if not gone:
                if size == 1:
                    return
            else:
                size = 2 * size

    def bypass(self):
        """Modifiers that others name are replaced by their own modifier, their fore- or background."""
        for stem in list(self.best.files):
            i = len(self.best.files.get(stem, [])) - 1
            while i >= 0 and stem in self.best.files:
                p = self.best.files[stem][i]
                if not p.is_surface():
                    for target in [p.modifier] + [p.strings[k] for k in p.names] + ["void"]:
                        if self.keep(self.renamed(stem, i, target)):
                            break
                i = min(i, len(self.best.files.get(stem, []))) - 1

    def renamed(self, stem, i, target):
        scene = self.best.copy()
        name = scene.files[stem][i].name
        del scene.files[stem][i]
        for p in scene.files[stem]:
            if p.modifier == name:
                p.modifier = target
            for k in p.names:
                p.strings[k] = ">".join(target if part == name else part for part in p.strings[k].split(">"))
        return scene

    def fewer_options(self):
        for words in list(self.best.options):
            if words[0] in BASE:
                continue
            scene = self.best.copy()
            scene.options = [w for w in scene.options if w != words]
            self.keep(scene)

    def find(self, stem, name):
        """A primitive of the best scene so far; None if it is no longer there."""
        return next((p for p in self.best.files.get(stem, []) if p.name == name), None)

    def change(self, stem, name, edit):
        scene = self.best.copy()
        edit(next(p for p in scene.files[stem] if p.name == name))
        return self.keep(scene)

    def simpler(self):
        """Modifiers dropped, transforms dropped, expressions and numbers shortened."""
        for stem, name in [(stem, p.name) for stem, list_ in self.best.files.items() for p in list_]:
            p = self.find(stem, name)
            if p and p.modifier != "void" and not p.is_surface():
                self.change(stem, name, lambda q: setattr(q, "modifier", "void"))
            if self.find(stem, name):
                self.simpler_strings(stem, name)
                self.simpler_numbers(stem, name)

    def simpler_strings(self, stem, name):
        p = self.find(stem, name)
        start = next((k for k, s in enumerate(p.strings) if s[0] == "-" and s[1:2].isalpha()), None)
        if start is not None and p.kind != "source":
            self.change(stem, name, lambda q: q.strings.__delitem__(slice(start, None)))
        p = self.find(stem, name)
        simple = NOT_NOTHING if p.kind in ("BSDF", "aBSDF") else SIMPLE_STRINGS
        for k, s in enumerate(p.strings):
            if k in p.names or not any(c in s for c in "*+("):
                continue
            for text in simple:
                if self.change(stem, name, lambda q: q.strings.__setitem__(k, text)):
                    break

    def simpler_numbers(self, stem, name):
        p = self.find(stem, name)
        if p.kind == "source":  # an angle of 400 degrees is none
            return
        for digits in (1, 2):
            rounded = [float(f"{v:.{digits}g}") for v in p.reals]
            if rounded == p.reals or self.change(stem, name, lambda q: setattr(q, "reals", rounded)):
                break

    def run(self):
        if not self.shows(self.best):
            return None
        size = None
        while size != (size := len(self.best.primitives()) + len(self.best.options)):
            self.fewer_surfaces()
            self.bypass()
            self.fewer_options()
        self.simpler()
        return self.best
