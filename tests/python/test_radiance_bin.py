# SPDX-License-Identifier: BSD-3-Clause
"""luxpipe-radiance: a folder that programs take for RADIANCE's."""

import os
import re
import subprocess
import sys

import luxpipe
import pytest
from conftest import SCENE, VIEW


@pytest.fixture()
def folder(tmp_path):
    """A folder made beside a RADIANCE that is an oconv which copies, and a rpict that must not be called."""
    for name, text in (("oconv", 'cat "$@"'), ("rpict", "exit 9")):
        program = tmp_path / "radiance" / "bin" / name
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text(f"#!/bin/sh\n{text}\n")
        program.chmod(0o755)
    (tmp_path / "radiance" / "lib").mkdir()
    return tmp_path / "with blank"


def make(folder, *options):
    words = [sys.executable, "-c", "from luxpipe._radiance_bin import main; main()", str(folder), *options]
    return subprocess.run(words, capture_output=True, text=True)


def test_ours_and_links(folder):
    done = make(folder, "-radiance", str(folder.parent / "radiance" / "bin"))
    assert done.returncode == 0 and f"export PATH='{folder}/bin':$PATH" in done.stdout
    assert "missing" in done.stderr and " rtrace " not in done.stderr and " oconv" not in done.stderr
    assert (folder / "bin" / "oconv").is_symlink() and not (folder / "bin" / "rpict").is_symlink()
    assert (folder / "lib").resolve() == folder.parent / "radiance" / "lib"
    assert make(folder, "-radiance", str(folder.parent / "radiance" / "bin")).returncode == 0  # again


def test_rpict_and_evalglare(folder):
    make(folder, "-radiance", str(folder.parent / "radiance" / "bin"))
    bare = {"PATH": "/usr/bin:/bin", "LUXPIPE_UNTIL": "3"}  # what a program that knows nothing of luxpipe gives
    words = ["-t", "10", "-ab", "2", "-ad", "1000", "-aa", ".2", "-x", "32", "-y", "32", "-vf", str(VIEW)]
    rpict = [str(folder / "bin" / "rpict"), *words]
    piped = subprocess.run([*rpict, *map(str, SCENE)], env=bare, capture_output=True)
    filed = subprocess.run([*rpict, "-o", "x.pic", *map(str, SCENE)], env=bare, capture_output=True, cwd=folder)
    assert piped.returncode == filed.returncode == 0 and filed.stdout == b""
    one, other = luxpipe.read(piped.stdout), luxpipe.read(folder / "x.pic")
    assert one.shape == (32, 32, 3) and (one == other).all()
    seed = subprocess.run([*rpict, *map(str, SCENE)], env={**bare, "LUXPIPE_OPTIONS": "-seed 2"}, capture_output=True)
    assert seed.returncode == 0 and (luxpipe.read(seed.stdout) != one).any()
    assert luxpipe.measure(piped.stdout).row.get("frame", 0) in (0, 2)
    glare = subprocess.run([str(folder / "bin" / "evalglare"), "x.pic"], env=bare, capture_output=True, cwd=folder)
    assert glare.stdout == luxpipe.evalglare(folder / "x.pic") and b"dgp,dgi" in glare.stdout


def frames_of(picture):
    return int(re.search(rb"\nFRAMES=(\d+)\n", picture)[1])


def test_rpict_takes_the_samples_that_its_error_asks_for(folder):
    make(folder)
    rpict = [str(folder / "bin" / "rpict"), "-ab", "2", "-x", "64", "-y", "64", "-vf", str(VIEW), *map(str, SCENE)]
    count = {}
    for error in ("8", "4", "2"):
        done = subprocess.run(rpict, env={"PATH": "/usr/bin:/bin", "LUXPIPE_UNTIL": f"{error}%"}, capture_output=True)
        assert done.returncode == 0, done.stderr
        count[error] = frames_of(done.stdout)
    assert 1 < count["8"] < count["4"] < count["2"] < 300
    assert count["2"] > 2 * count["4"]  # errors fall with the root of the frames
    for name, value in (("LUXPIPE_UNTIL", "4"), ("LUXPIPE_FRAMES", "3")):  # the second is the older name
        fixed = subprocess.run(rpict, env={"PATH": "/usr/bin:/bin", name: value}, capture_output=True)
        assert frames_of(fixed.stdout) == 3
        assert (b"LUXPIPE_FRAMES=3: is called LUXPIPE_UNTIL=4 now" in fixed.stderr) == (name == "LUXPIPE_FRAMES")


def test_rpict_fails_as_rpict(folder):
    make(folder)
    rpict = str(folder / "bin" / "rpict")
    done = subprocess.run([rpict, "-vf", "no.vf", str(SCENE[0])], capture_output=True, text=True)
    assert done.returncode == 2 and done.stderr.startswith("ptrace: no.vf: ") and done.stderr.count("\n") == 1
    done = subprocess.run([rpict, "-version"], capture_output=True, text=True)
    assert done.returncode == 0 and "luxpipe" in done.stdout


def test_a_radiance_that_is_not_there(folder):
    done = make(folder, "-radiance", "/nowhere")
    assert done.returncode == 1 and done.stderr == "luxpipe-radiance: /nowhere: is no folder\n"
    assert not os.path.exists(folder)


def test_errors_are_one_line(folder, monkeypatch):
    (folder.parent / "file").write_text("")
    assert make(folder.parent / "file").stderr.count("\n") == 1
    monkeypatch.setenv("LUXPIPE_BIN", "/nowhere")
    done = make(folder)
    assert done.returncode == 1
    assert done.stderr == "luxpipe-radiance: luxpipe: vcmetrics: no such program in /nowhere\n"
