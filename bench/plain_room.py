#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One plain scene for two renderers: the size and light of examples/scenes/office, grey and diffuse, without glass.

plain_room.py write FOLDER                         office.rad and a .ply a reflectance
plain_room.py view                                 ptrace's words for the view
plain_room.py render FOLDER VARIANT SIZE SPP SEED  FOLDER/VARIANT.SEED.exr; prints the samples' processor seconds

Mitsuba's sun is a direction, ours half a degree wide; its last bounce looks for the sky once more than -ab 5.  Its
seconds leave out loading and compiling: a picture comes before the one that is timed.  They are those of all its
threads (a single one hangs in 3.9.1).
"""
import os
import sys
import time

ROOM, CEILING, FLOOR, DESK, LAWN, BRICK = .67, .83, .19, .36, .13, .24
SUN = (-.521196, -.802754, .289724)  # towards it
SUN_RADIANCE, SKY_RADIANCE, SUN_DEGREES = 4.613e6, 10.0, .5
EYE, TO = (2, 5.5, 1.2), (2, 0, .9)
FIELD_DEGREES = 70


def box(grey, low, high):
    corner = [[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)]
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return [(grey, [corner[k] for k in face]) for face in faces]


def quads():
    """(reflectance, four corners) of all faces: metres, the window in the wall y = 0."""
    found = [
        (FLOOR, [(0, 0, 0), (4, 0, 0), (4, 6, 0), (0, 6, 0)]),
        (CEILING, [(0, 0, 2.8), (0, 6, 2.8), (4, 6, 2.8), (4, 0, 2.8)]),
        (ROOM, [(0, 0, 0), (0, 6, 0), (0, 6, 2.8), (0, 0, 2.8)]),
        (ROOM, [(4, 0, 0), (4, 0, 2.8), (4, 6, 2.8), (4, 6, 0)]),
        (ROOM, [(0, 6, 0), (4, 6, 0), (4, 6, 2.8), (0, 6, 2.8)]),
        (LAWN, [(-60, -60, -.3), (60, -60, -.3), (60, 60, -.3), (-60, 60, -.3)]),
    ]
    for low, high in (((0, -.25, 0), (4, 0, .85)), ((0, -.25, 2.6), (4, 0, 2.8)), ((0, -.25, .85), (.3, 0, 2.6)),
                      ((3.7, -.25, .85), (4, 0, 2.6))):
        found += box(ROOM, low, high)
    for low, high in (((1.1, 1.7, .72), (2.9, 2.5, .75)), ((1.69, 1.83, .88), (2.31, 1.87, 1.26)),
                      ((.01, 2.9, 0), (.36, 4.5, 1.2)), ((3.1, 2.9, .42), (3.56, 3.36, .5))):
        found += box(DESK, low, high)
    return found + box(BRICK, (-9, -22, -.3), (9, -14, 5.2))


def write(folder):
    with open(f"{folder}/office.rad", "w") as rad:
        for grey in sorted({g for g, _ in quads()}):
            rad.write(f"void plastic g{grey}\n0\n0\n5 {grey} {grey} {grey} 0 0\n")
        rad.write(f"void light sun\n0\n0\n3 {SUN_RADIANCE} {SUN_RADIANCE} {SUN_RADIANCE}\n"
                  f"sun source disc\n0\n0\n4 {SUN[0]} {SUN[1]} {SUN[2]} {SUN_DEGREES}\n"
                  f"void glow sky\n0\n0\n4 {SKY_RADIANCE} {SKY_RADIANCE} {SKY_RADIANCE} 0\n"
                  "sky source all\n0\n0\n4 0 0 1 360\n")
        for k, (grey, corners) in enumerate(quads()):
            rad.write(f"g{grey} polygon q{k}\n0\n0\n12 {' '.join(str(x) for p in corners for x in p)}\n")
    for grey in {g for g, _ in quads()}:
        faces = [corners for g, corners in quads() if g == grey]
        with open(f"{folder}/{grey}.ply", "w") as ply:
            ply.write(f"ply\nformat ascii 1.0\nelement vertex {4 * len(faces)}\n"
                      "property float x\nproperty float y\nproperty float z\n"
                      f"element face {2 * len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
            ply.writelines("{} {} {}\n".format(*p) for corners in faces for p in corners)
            for first in range(0, 4 * len(faces), 4):
                ply.write(f"3 {first} {first + 1} {first + 2}\n3 {first} {first + 2} {first + 3}\n")


def render(folder, variant, size, samples, seed):
    import math
    import drjit
    import mitsuba
    mitsuba.set_variant(variant)
    grey = lambda value: {"type": "rgb", "value": [value] * 3}
    irradiance = SUN_RADIANCE * math.pi * math.sin(math.radians(SUN_DEGREES / 2)) ** 2
    scene = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 7},
        "sensor": {
            "type": "perspective", "fov": FIELD_DEGREES,
            "to_world": mitsuba.ScalarTransform4f().look_at(origin=EYE, target=TO, up=(0, 0, 1)),
            "film": {"type": "hdrfilm", "width": size, "height": size, "rfilter": {"type": "box"},
                     "pixel_format": "rgb", "component_format": "float32"},
            "sampler": {"type": "independent"}},
        "sky": {"type": "constant", "radiance": grey(SKY_RADIANCE)},
        "sun": {"type": "directional", "direction": [-x for x in SUN], "irradiance": grey(irradiance)},
    }
    for k, value in enumerate(sorted({g for g, _ in quads()})):
        scene[f"mesh{k}"] = {"type": "ply", "filename": f"{folder}/{value}.ply", "face_normals": True,
                             "bsdf": {"type": "twosided", "b": {"type": "diffuse", "reflectance": grey(value)}}}
    scene = mitsuba.load_dict(scene)
    took, picture = [], None
    for spp in (1, samples):  # the first compiles
        start = time.process_time()
        picture = mitsuba.render(scene, spp=spp, seed=seed + len(took))
        drjit.eval(picture)
        drjit.sync_thread()
        took.append(time.process_time() - start)
    mitsuba.Bitmap(picture).convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.Float32, False).write(
        os.path.join(folder, f"{variant}.{seed}.exr"))
    print(f"{took[-1]:.3f}")


if __name__ == "__main__":
    if sys.argv[1] == "write":
        write(sys.argv[2])
    elif sys.argv[1] == "view":
        print("-vp", *EYE, "-vd", *(b - a for a, b in zip(EYE, TO)), "-vh", FIELD_DEGREES, "-vv", FIELD_DEGREES)
    else:
        render(sys.argv[2], sys.argv[3], *(int(word) for word in sys.argv[4:7]))
