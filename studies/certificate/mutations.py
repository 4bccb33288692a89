#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""mutations.py: faults put into the programs one at a time, and the first value of CIE 171 that finds each: further
than 5 standard errors from the derived one.  Works in a tree of its own (out/mutations), without lanes, by ccache where
it is: one build has all faults, each of which asks whether it is the one that the environment names.  Prints the table
studies/certificate/mutations.tsv.

-only 3,7: these faults; 0 is none of them, which must have no wrong value."""

import argparse
import os
import shutil
import subprocess
import sys
import time

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "studies", "cie171"))
from facts import facts  # noqa: E402

COMMAND = "-points ABCDEGNefimnosu -size 48 -frames 9 -skies 2 5 12 15 16 -stop -not 5.4 5.8,_rho"

# words, file, text that stands there once, text in its place; ON: is this the fault?
FAULTS = [
    (
        "none",
        "lib/base/number.cpp",
        "namespace base {",
        'extern int luxpipe_fault __asm__("luxpipe_fault");\n'
        "int luxpipe_fault;\n"
        "__attribute__((constructor(101))) static void read_fault() {  // before constants are made\n"
        '    if (const char* text = getenv("LUXPIPE_FAULT")) luxpipe_fault = atoi(text);\n}\nnamespace base {',
    ),
    (
        "glass passes 1.01 of its light",
        "lib/kernels/material/mat_glass.h",
        "mul3(F3(Tr, Tg, Tb), g->color);",
        "mul3(scale3(F3(Tr, Tg, Tb), ON ? 1.01f : 1.0f), g->color);",
    ),
    (
        "the sun is half an hour off",
        "lib/generators/sun.cpp",
        "const double h = hours * base::pi / 12,",
        "const double h = (hours + (ON ? .5 : 0)) * base::pi / 12,",
    ),
    (
        "the sky is turned by 5 degrees",
        "lib/generators/cie_sky.cpp",
        "sun_direction(s.altitude, s.azimuth);",
        "sun_direction(s.altitude, s.azimuth + (ON ? 5 : 0) * degree);",
    ),
    (
        "normals at a mesh's corners are flipped",
        "lib/scene/obj.cpp",
        "normals.push_back({float(n.x), float(n.y), float(n.z)});",
        "const float side = ON ? -1 : 1;\n"
        "            normals.push_back({side * float(n.x), side * float(n.y), side * float(n.z)});",
    ),
    (
        "normals of a mesh's triangles are flipped",
        "lib/flatten/mesh.cpp",
        "const Vec3 normal = across * (1 / area2);",
        "const Vec3 normal = across * ((ON ? -1 : 1) / area2);",
    ),
    (
        "paths that survive roulette are not weighted",
        "lib/kernels/integrator/continue.h",
        "scale3(vertex->throughput, 1.0f / prob);",
        "scale3(vertex->throughput, ON ? 1.0f : 1.0f / prob);",
    ),
    (
        "no cosine at the sensor",
        "lib/glare/geometry.cpp",
        "omega_cos[i] = omega[i] * rays_->incidence(c);",
        "omega_cos[i] = omega[i] * (ON ? 1 : rays_->incidence(c));",
    ),
    (
        "the pdf of portals is 2 % too large",
        "lib/kernels/sampling/portals.h",
        "return t * t / (portal->area * c);",
        "return (ON ? 1.02f : 1.0f) * t * t / (portal->area * c);",
    ),
    (
        "direct light at the last bounce counts twice",
        "lib/kernels/integrator/direct.h",
        "radiance = scale3(radiance, inv_p);",
        "int last = (int)path_bounces(vertex->flags) == MAX_(par->ab, 1);\n"
        "    radiance = scale3(radiance, ON && last ? 2.0f * inv_p : inv_p);",
    ),
    (
        "luminous weights of red and blue are swapped",
        "lib/image/grey.cpp",
        "namespace image {",
        "namespace image {\n"
        "#define grey_red (ON ? 0.064788359788359784 : 0.26510582010582007)\n"
        "#define grey_blue (ON ? 0.26510582010582007 : 0.064788359788359784)",
    ),
    (
        "a lamp's area is 1 % too large",
        "lib/kernels/light/source_sample.h",
        "light->w = src->area * cosine / d2;",
        "light->w = (ON ? 1.01f : 1.0f) * src->area * cosine / d2;",
    ),
]


def must(command, **more):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
    if done.returncode:
        sys.exit("mutations.py: %s: %s" % (" ".join(command), done.stdout.decode(errors="replace")[-2000:]))
    return done.stdout.decode()


def prepare(folder):
    tree = os.path.join(folder, "tree")
    build = os.path.join(tree, "build")  # as other builds, for ccache
    if os.path.isdir(tree):
        must(["git", "-C", tree, "checkout", "-qf", "--detach", must(["git", "-C", TOP, "rev-parse", "HEAD"]).strip()])
    else:
        must(["git", "-C", TOP, "worktree", "add", "-q", "--detach", tree, "HEAD"])
    cache = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    must(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DLUXPIPE_ISPC=", *cache])
    return tree, build


def mutate(tree, number, path, old, new):
    with open(os.path.join(tree, path)) as f:
        text = f.read()
    if text.count(old) != 1:
        sys.exit("mutations.py: %s: has %d times: %s" % (path, text.count(old), old))
    declared = 'extern int luxpipe_fault __asm__("luxpipe_fault");\n' if number else "#include <cstdlib>\n"
    with open(os.path.join(tree, path), "w") as f:
        f.write(declared + text.replace(old, new.replace("ON", "(luxpipe_fault == %d)" % number)))


def measure(build, number):
    """Rows, seconds, and the wrong row or None."""
    start = time.time()
    study = os.path.join(TOP, "studies", "cie171", "run.py")
    words = [w.replace("_", " ") for w in COMMAND.split()]
    done = subprocess.run(
        [sys.executable, "-B", study, "-bin", os.path.join(build, "bin"), *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=dict(os.environ, LUXPIPE_FAULT=str(number)),
    )
    rows = [line.split("\t") for line in done.stdout.decode().splitlines() if not line.startswith(("#", "case\t"))]
    if done.returncode and not (rows and rows[-1][8] == "wrong"):
        sys.exit("mutations.py: run.py: " + done.stderr.decode(errors="replace")[-2000:])
    return rows, time.time() - start, rows[-1] if rows[-1][8] == "wrong" else None


def main():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("-only", default="")
    p.add_argument("-jobs", default="2")
    p.add_argument("-out", default=os.path.join(TOP, "out", "mutations"))
    o = p.parse_args()
    tree, build = prepare(os.path.abspath(o.out))
    for number, (_, path, old, new) in enumerate(FAULTS):
        mutate(tree, number, path, old, new)
    must(["cmake", "--build", build, "-j", o.jobs, "--target", "ptrace", "ptaccum", "vcmetrics"])
    values = "python3 studies/cie171/run.py " + COMMAND.replace("5.8,_rho", "'5.8, rho'")
    facts("python3 studies/certificate/mutations.py", values=values)
    print("fault\tfile\tcase\tpoint\tsky\tderived\tvalue\terrors\tvalues\tseconds", flush=True)
    for number, (words, path, _, _) in enumerate(FAULTS):
        if o.only and str(number) not in o.only.split(","):
            continue
        rows, seconds, wrong = measure(build, number)
        found = [wrong[k] for k in (0, 1, 2, 3, 4, 7)] if wrong else ["-"] * 6
        print("\t".join([words, path if number else "-", *found, "%d" % len(rows), "%.0f" % seconds]), flush=True)


if __name__ == "__main__":
    main()
