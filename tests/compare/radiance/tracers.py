# SPDX-License-Identifier: BSD-3-Clause
"""The same rays by rtrace and by ptrace: means and standard errors, three channels a ray."""
import math
import os
import struct
import subprocess

# What both programs are told: no ambient cache, no test skipped, no estimate in place of a sample.
EXACT = "-u+ -aa 0 -as 0 -dt 0 -dp 0 -w-"
PER_RAY = 40  # seconds a ray may take before the scene is given up, at most (timeout() below)


class Refused(Exception):
    """A program does not trace this scene, with its reason; `who` is "rtrace" or "ptrace"."""

    def __init__(self, who, why):
        super().__init__(f"{who}: {why}")
        self.who, self.why = who, why


move, stray = (0, 0, 0), False  # of the model that ptrace sees; stray: with a small polygon at the origin
scale = 1  # of the model that ptrace sees; rtrace's lengths of 1e-6 are not made for other units


def timeout(rays):
    return 60 + PER_RAY * math.sqrt(len(rays))


def environment(folder):
    env = dict(os.environ)
    if "RAYPATH" in env:  # without it each program looks where it was told to when it was built
        env["RAYPATH"] = os.pathsep.join([".", env["RAYPATH"]])
    env["LUXPIPE_THREADS"] = "1"  # scenes are traced side by side
    return env


def run(who, command, folder, text, limit):
    try:
        done = subprocess.run(command, cwd=folder, input=text.encode(), capture_output=True, timeout=limit,
                              env=environment(folder))
    except subprocess.TimeoutExpired:
        raise Refused(who, "takes too long")
    if done.returncode != 0:
        lines = done.stderr.decode(errors="replace").strip().splitlines()
        raise Refused(who, lines[-1] if lines else f"status {done.returncode}")
    return done.stdout


def ray_text(ray):
    return " ".join(f"{v:.9g}" for v in ray)


def rtrace(folder, arguments, rays, repeats, octree="scene.oct"):
    """Each ray `repeats` times; means and standard errors of the mean."""
    text = "".join((ray_text(ray) + "\n") * repeats for ray in rays)
    command = ["rtrace", "-h", "-faf"] + EXACT.split() + arguments.split() + [octree]
    out = run("rtrace", command, folder, text, timeout(rays))
    if len(out) != 12 * repeats * len(rays):
        raise Refused("rtrace", f"gives {len(out)} bytes for {len(rays)} rays")
    values = struct.unpack(f"<{3 * repeats * len(rays)}f", out)
    results = []
    for i in range(len(rays)):
        one = values[3 * repeats * i:3 * repeats * (i + 1)]
        mean = [sum(one[c::3]) / repeats for c in range(3)]
        error = [0.0] * 3
        if repeats > 1:
            for c in range(3):
                square = sum((v - mean[c]) ** 2 for v in one[c::3]) / (repeats - 1)
                error[c] = math.sqrt(square / repeats)
        results.append((mean, error))
    return results


def ptrace(tracer, folder, arguments, rays, fewest, most, least="0"):
    """least: of the chances of the ways on from a surface."""
    origins = [[f"{scale * v + by:.17g}" for v, by in zip(ray, move)] for ray in rays]
    text = "".join(" ".join(origin) + " " + ray_text(ray[3:]) + "\n" for origin, ray in zip(origins, rays))
    with open(os.path.join(folder, "placed.rad"), "w") as out:
        out.write(f"!xform -s {scale} -t {move[0]} {move[1]} {move[2]} scene.rad\n")
        if stray:
            out.write("void plastic stray 0 0 5 0 0 0 0 0\nstray polygon stray_p 0 0 9 0 0 0 .001 0 0 0 .001 0\n")
    words = arguments.split()
    for i in range(len(words)):
        if words[i] == "-me":
            words[i + 1:i + 4] = [f"{float(v) / scale:.9g}" for v in words[i + 1:i + 4]]
    file = "scene.rad" if scale == 1 and not any(move) and not stray else "placed.rad"
    command = [tracer, str(fewest), str(most), file, EXACT + " " + " ".join(words), least]
    out = run("ptrace", command, folder, text, timeout(rays))
    results = []
    for line in out.decode().splitlines():
        v = [float(word) for word in line.split()]
        results.append((v[:3], v[3:6]))
    if len(results) != len(rays):
        raise Refused("ptrace", f"gives {len(results)} values for {len(rays)} rays")
    return results
