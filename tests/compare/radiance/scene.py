# SPDX-License-Identifier: BSD-3-Clause
"""A scene as lists of primitives, one list a file: written for oconv, searched for what each primitive needs."""
import os
import subprocess

SURFACES = {"polygon", "sphere", "bubble", "ring", "cylinder", "tube", "cone", "cup", "source", "instance", "mesh"}


class Primitive:
    """One primitive of the scene language.  `names` are the places among its strings that name other modifiers."""

    def __init__(self, modifier, kind, name, strings=(), reals=(), names=()):
        self.modifier, self.kind, self.name = modifier, kind, name
        self.strings, self.reals, self.names = list(strings), list(reals), tuple(names)

    def copy(self):
        return Primitive(self.modifier, self.kind, self.name, self.strings, self.reals, self.names)

    def is_surface(self):
        return self.kind in SURFACES

    def needs(self):
        """The modifiers it names; a source of a mist may be a path of them, relay>source."""
        words = [self.modifier] + [self.strings[i] for i in self.names]
        return {part for word in words for part in word.split(">")}

    def text(self):
        strings = [f'"{s}"' if " " in s or s == "" else s for s in self.strings]
        lines = [f"{self.modifier} {self.kind} {self.name}", " ".join([str(len(strings))] + strings), "0"]
        return "\n".join(lines + [" ".join([str(len(self.reals))] + [f"{r:.6g}" for r in self.reals])]) + "\n"


class Scene:
    """`files` maps a stem to its primitives; "scene" is the outermost, the others are octrees of instances.

    `options` are rtrace's, a list of lists of words; `rays` are (origin, direction) in six numbers.
    """

    def __init__(self):
        self.files, self.options, self.rays = {"scene": []}, [], []

    def copy(self):
        other = Scene()
        other.files = {stem: [p.copy() for p in list_] for stem, list_ in self.files.items()}
        other.options = [list(words) for words in self.options]
        other.rays = list(self.rays)
        return other

    def primitives(self):
        return [p for list_ in self.files.values() for p in list_]

    def kinds(self):
        return sorted({p.kind for p in self.primitives()})

    def arguments(self):
        return " ".join(word for words in self.options for word in words)

    def option(self, name, otherwise=None):
        found = [words[1:] for words in self.options if words[0] == name]
        return found[-1] if found else otherwise

    def noisy(self):
        """Has rtrace noise of its own, beside that of BSDF tables?"""
        value = lambda name, otherwise: float(self.option(name, [otherwise])[0])  # noqa: E731
        return value("-ab", 0) > 0 or value("-dj", 0) > 0 or value("-ss", 1) > 0

    def prune(self):
        """Without modifiers that nobody names and octrees that nobody instantiates."""
        for stem in list(self.files):
            list_ = self.files[stem]
            needed = set()
            kept = []
            for p in reversed(list_):
                if p.is_surface() or p.name in needed:
                    needed |= p.needs()
                    kept.append(p)
            self.files[stem] = kept[::-1]
        used = {p.strings[0] for p in self.primitives() if p.kind == "instance"}
        for stem in list(self.files):
            if stem != "scene" and stem + ".oct" not in used:
                del self.files[stem]

    def write(self, folder):
        """Scene files and octrees; the error oconv gives, or None."""
        for stem in sorted(self.files, reverse=True, key=lambda s: (s != "scene", s)):  # inner2 before inner1
            path = os.path.join(folder, stem + ".rad")
            with open(path, "w") as out:
                out.write("\n".join(p.text() for p in self.files[stem]))
            with open(os.path.join(folder, stem + ".oct"), "wb") as out:
                made = subprocess.run(["oconv", "-w", stem + ".rad"], cwd=folder, stdout=out, stderr=subprocess.PIPE)
            if made.returncode != 0:
                return made.stderr.decode(errors="replace").strip()
        return None
