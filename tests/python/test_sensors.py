# SPDX-License-Identifier: BSD-3-Clause
"""luxpipe.sensors, luxpipe.rtrace and the program rtrace of luxpipe-radiance."""

import array
import math
import subprocess
import sys

import luxpipe
import pytest
from conftest import SCENE

RAYS = b"2 2 .8 0 0 1\n0 0 0 0 0 0\n2 1 .8 0 0 2\n"
# RADIANCE 6.0a: rtrace -h -I -ab 5 -aa 0 -u+ -ad 30000 -lr -12 -lw 1e-6 -st 0 -dj 0
OFFICE = [[65.324, 66.950, 65.542], [0, 0, 0], [73.362, 75.252, 73.437]]


@pytest.fixture()
def sky(tmp_path):
    """A sky of radiance 1 and nothing else: irradiance is pi, radiance 1."""
    path = tmp_path / "sky.rad"
    path.write_text("void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 360\n")
    return path


def rtrace(words, rays, *env):
    here = [sys.executable, "-c", "from luxpipe._rtrace import main; main()"]
    return subprocess.run([*env, *here, *words], input=rays, capture_output=True)


def numbers(text):
    return [[float(word) for word in line.split()] for line in text.decode().splitlines()]


def test_irradiance_under_a_sky(sky):
    done = rtrace(["-h", "-I", "-ab", "1", "-aa", ".1", "-ad", "2048", str(sky)], RAYS)
    assert done.returncode == 0 and b"does not need" in done.stderr
    for got, want in zip(numbers(done.stdout), [math.pi, 0, math.pi]):
        assert got == pytest.approx([want] * 3, rel=.02)
    assert done.stdout.splitlines()[1] == b"0.000000e+00\t0.000000e+00\t0.000000e+00\t"
    up, down = numbers(rtrace(["-h", "-I-", str(sky)], b"0 0 0 0 0 1\n0 0 0 1 0 -1").stdout)
    assert up == down == [1, 1, 1]


def test_formats(sky):
    rays = array.array("f", [0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0])
    done = rtrace(["-h", "-ff", str(sky)], rays.tobytes())
    assert array.array("f", done.stdout).tolist() == [1] * 6
    done = rtrace(["-h", "-fad", str(sky)], b"0 0 0 0 0 1")
    assert array.array("d", done.stdout).tolist() == [1] * 3
    done = rtrace(["-ffc", "-x", "2", "-y", "1", str(sky)], rays.tobytes())
    assert done.stdout.startswith(b"#?RADIANCE\nrtrace -ffc") and b"\nFORMAT=32-bit_rle_rgbe\n\n-Y " in done.stdout
    assert luxpipe.read(done.stdout).tolist() == [[[pytest.approx(1, rel=.01)] * 3] * 2]
    assert rtrace(["-h", str(sky)], b"").stdout == b""


@pytest.mark.parametrize("words, rays, message", [
    (["-i", "SKY"], RAYS, b"rtrace: -i: measures the surface that a ray meets, which is not done here"),
    (["-ld", "SKY"], RAYS, b"rtrace: -ld: ends rays, which is not done here"),
    (["-opN", "SKY"], RAYS, b"rtrace: -opN: values only are printed here: -ov"),
    (["-x", "a", "SKY"], RAYS, b'rtrace: -x: "a" is not a number of rays'),
    (["-I", "-h"], RAYS, b"rtrace: an octree or scene file is missing"),
    (["SKY"], b"1 2 3", b"rtrace: rays: the last one has 3 of six numbers"),
    (["SKY"], b"1 2 x 0 0 1", b"rtrace: rays: could not convert string to float: b'x'"),
    (["-ff", "SKY"], b"123", b"rtrace: rays: 3 bytes are not whole rays of -ff"),
    (["none.oct"], RAYS, b"ptrace: none.oct: cannot be "),
    (["-pXYZ", "SKY"], RAYS, b"ptrace: -pXYZ: ")])
def test_what_would_change_the_answer_is_refused(sky, words, rays, message):
    done = rtrace([str(sky) if word == "SKY" else word for word in words], rays)
    assert done.returncode in (1, 2) and done.stdout == b""
    assert done.stderr.startswith(message) and done.stderr.count(b"\n") == 1


def test_the_function_is_the_program(sky, tmp_path, monkeypatch):
    monkeypatch.setenv("LUXPIPE_UNTIL", "2")
    done = rtrace(["-h", "-I", "-faa", "-n", "1", "-ab", "2", *map(str, SCENE)], RAYS)
    office = tmp_path / "office.rad"
    office.write_text("".join(f"!xform {path}\n" for path in SCENE))
    same = luxpipe.rtrace(RAYS, office, header=False, irradiance=True, nproc=1, params=["-ab", "2"], frames=2)
    assert numbers(same) == numbers(done.stdout)
    with pytest.raises(luxpipe.Error, match="^rtrace: -i: "):
        luxpipe.rtrace(RAYS, sky, irradiance_lambertian=True)
    with pytest.raises(TypeError, match="must be bytes"):
        luxpipe.rtrace("0 0 0 0 0 1", sky)
    assert b"luxpipe" in luxpipe.rtrace(b"", sky, version=True)


def test_office_within_the_accuracy_asked_for():
    done = rtrace(["-h", "-I", "-ab", "5", *map(str, SCENE)], RAYS)
    for got, want in zip(numbers(done.stdout), OFFICE):
        assert got == pytest.approx(want, rel=.03)


def test_beside_radiance(tmp_path, monkeypatch):
    pyradiance = pytest.importorskip("pyradiance")
    octree = tmp_path / "office.oct"
    monkeypatch.chdir(SCENE[0].parent)  # its files name others
    octree.write_bytes(pyradiance.oconv(*map(str, SCENE), frozen=True))
    params = ["-ab", "5", "-aa", "0", "-ad", "5000", "-lr", "-12", "-lw", "1e-6", "-st", "0"]
    theirs = numbers(pyradiance.rtrace(RAYS, octree, header=False, irradiance=True, params=params))
    ours = numbers(luxpipe.rtrace(RAYS, octree, header=False, irradiance=True, params=params))
    for got, want in zip(ours, theirs):
        assert got == pytest.approx(want, rel=.05)


def test_sensors(sky, tmp_path):
    rows = luxpipe.sensors(sky, [(0, 0, 0, 0, 0, 1), (1, 0, 0, 1, 0, 0)])
    rows = rows.to_dict("records") if hasattr(rows, "to_dict") else rows
    assert list(rows[0]) == ["grid", "x", "y", "z", "dx", "dy", "dz", "E", "lo", "hi", "errors"]
    for row in rows:
        assert row["lo"] <= row["E"] <= row["hi"] and row["E"] == pytest.approx(179 * math.pi, rel=.02)
    for name in ("a", "b"):
        (tmp_path / f"{name}.pts").write_text("0 0 0 0 0 1\n")
    for points in (tmp_path, [tmp_path / "a.pts", tmp_path / "b.pts"]):
        table = luxpipe.sensors(sky, points, max_frames=20, until="mean 50%")
        grids = table["grid"] if hasattr(table, "columns") else [row["grid"] for row in table]
        assert list(grids) == ["a", "b"]
    with pytest.warns(luxpipe.Warning, match="after 20 frames the rule \"each 0.001%\" does not hold"):
        luxpipe.sensors(SCENE, [(2, 2, .8, 0, 0, 1)], "each 0.001%", max_frames=20)
    with pytest.raises(ValueError, match="no points"):
        luxpipe.sensors(sky, [])


def test_a_point_of_three_numbers_is_named_by_its_row():
    with pytest.raises(ValueError, match=r"^points: row 2 has 3 numbers, not six: x y z dx dy dz$"):
        luxpipe.sensors(SCENE, [(1, 2, .8, 0, 0, 1), (1, 2, 3)])
