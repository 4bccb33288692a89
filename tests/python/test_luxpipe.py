# SPDX-License-Identifier: BSD-3-Clause
"""luxpipe from Python: the numbers of the pipe, pictures as arrays, errors, interruption."""

import base64
import doctest
import importlib
import io
import math
import os
import re
import resource
import signal
import subprocess
import sys
import warnings

import luxpipe
import numpy as np
import pytest
from conftest import SCENE, VIEW
from luxpipe._programs import program

FISHEYE = "-vta -vh 180 -vv 180 -vp 0 0 0 -vd 0 1 0 -vu 0 0 1"


def children():
    mine = subprocess.run(["ps", "-o", "comm=", "--ppid", str(os.getpid())], capture_output=True, text=True).stdout
    return [name for name in mine.split() if name in ("ptrace", "ptaccum", "vcmetrics")]


@pytest.mark.parametrize("module", ["luxpipe", "luxpipe._result", "luxpipe._render", "luxpipe._difference",
                                    "luxpipe._radiance", "luxpipe._rtrace", "luxpipe._sensors", "luxpipe._year"])
def test_doctests(module):
    found = doctest.testmod(importlib.import_module(module), extraglobs={"luxpipe": luxpipe})
    assert found.attempted and not found.failed


def test_render_is_the_pipe(office):
    line = ('"$PTRACE" -x 64 -y 64 -vf "$VIEW" "$@" | "$PTACCUM" -every x2/16 | '
            '"$VCMETRICS" -metrics Ev,DGP,DGPf -ci 95 -until "Ev 2%"')
    programs = {name.upper(): program(name) for name in ("ptrace", "ptaccum", "vcmetrics")}
    environment = {**os.environ, "VIEW": str(VIEW), **programs}
    table = subprocess.run(["sh", "-c", line, "sh", *map(str, SCENE)], env=environment, capture_output=True, text=True,
                           check=True).stdout
    names, *_, last = [row.split("\t") for row in table.splitlines()]
    row = dict(zip(names, last))
    assert office.frames == int(row["frame"])
    for name in ("Ev", "DGP", "DGPf"):
        assert office[name] == tuple(float(row[name + end]) for end in ("", ".lo", ".hi"))
    assert office.converged and "stopped after" in office.reason and office.row["tails"] == row["tails"]


def test_picture_has_the_light_at_the_eye(office):
    assert office.picture.shape == (64, 64, 3) and office.picture.dtype == np.float32
    assert not office.picture.flags.writeable
    assert luxpipe.measure(office.picture, view=FISHEYE)["Ev"].value == \
        pytest.approx(office["Ev"].value, rel=1e-6)
    luminance = 179 * (office.picture @ [0.265074, 0.670115, 0.064811])
    assert office.luminance == pytest.approx(luminance, rel=1e-5)


def test_difference_of_files_is_that_of_their_frames(tmp_path):
    files, steps = [], []
    for last in (5, 9):  # other frames: errors are independent
        frames = list(luxpipe.frames(SCENE, VIEW, size=16, max_frames=last))
        steps.append(frames)
        files.append(tmp_path / f"{last}.exr")
        args = ["-x", "16", "-y", "16", "-vf", VIEW, "-frames", str(last), *SCENE]
        trace = subprocess.run([program("ptrace"), *args], capture_output=True, check=True).stdout
        subprocess.run([program("ptaccum"), "-batches", "16", "-o", files[-1]], input=trace, check=True)
    of_files, of_frames = luxpipe.difference(*files, "Ev"), luxpipe.difference(*steps, "Ev")
    assert of_files["Ev"].value == pytest.approx(of_frames["Ev"].value, abs=1e-3)
    assert of_files["Ev"].lo == pytest.approx(of_frames["Ev"].lo, abs=.5)
    assert of_files["Ev"].lo < 0 < of_files["Ev"].hi
    assert math.isnan(luxpipe.difference(files[0], files[0])["Ev"].lo)


def test_saved_pictures(office, hdr, tmp_path):
    assert office.frames < 1000  # the stream announced 1000, the picture is by itself
    office.save(tmp_path / "office.exr")
    office.save(tmp_path / "office.png", "-tone", "falsecolor")
    assert np.array_equal(luxpipe.read(tmp_path / "office.exr"), office.picture)
    assert luxpipe.read(hdr) == pytest.approx(office.picture, rel=0.02, abs=0.02)
    assert luxpipe.read(hdr.read_bytes()).shape == (64, 64, 3)
    assert (tmp_path / "office.png").read_bytes().startswith(b"\x89PNG")


def test_a_notebook_shows_the_picture_and_no_folder_of_this_machine(office):
    html = office._repr_html_()
    png = base64.b64decode(re.search("data:image/png;base64,([^\"]*)", html)[1])
    assert png.startswith(b"\x89PNG") and png.endswith(b"IEND\xaeB`\x82") and "DGP" in html
    assert b"VIEW" not in png and os.fsencode(SCENE[0].parent) not in png
    pil = pytest.importorskip("PIL.Image")
    assert pil.open(io.BytesIO(png)).convert("RGB").size[1] >= 64


def test_actions_stand_beside_the_ordinary_numbers(tmp_path):
    scene = tmp_path / "grey.rad"
    scene.write_text("void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 180\n"
                     "void plastic p 0 0 5 .5 .5 .5 0 0\np ring floor 0 0 8 0 0 0 0 0 1 0 9\n")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the glow has no spectrum: D65
        grey = luxpipe.render(scene, FISHEYE.replace("-vp 0 0 0", "-vp 0 0 1"), None, size=16, max_frames=18,
                              metrics="Ev,mEDI,mDER", actions=["mel", "V"])
    assert math.isclose(grey["mEDI"].value, grey["Ev"].value, rel_tol=1e-3)
    assert abs(grey["mDER"].value - 1) < 1e-4 and grey["mDER"].hi - grey["mDER"].lo < 1e-4
    assert math.isclose(grey["EvV"].value, grey["Ev"].value, rel_tol=1e-3)
    with pytest.raises(ValueError):
        luxpipe.render(scene, FISHEYE, "Ev 1%", size=16, max_frames=None, actions=["mel"])


def test_table(office):
    table = pytest.importorskip("pandas") and office.metrics
    assert list(table.columns) == ["value", "lo", "hi"] and table.loc["DGP", "lo"] == office["DGP"].lo


def test_measure(hdr):
    by_path, by_bytes = luxpipe.measure(hdr, "Ev,DGP,class"), luxpipe.measure(hdr.read_bytes())
    assert by_path["Ev"] .value == by_bytes["Ev"].value and math.isnan(by_path["Ev"].lo)
    assert by_path.row["class"] in ("imperceptible", "perceptible")
    assert by_path.picture.shape == (64, 64, 3)
    assert luxpipe.measure(hdr, ["Ev", "DGP"]).values == luxpipe.measure(hdr, "Ev,DGP").values


def test_measure_regions(tmp_path):
    regions = luxpipe.examples.parent / "office.regions"
    regions = regions if regions.exists() else luxpipe.examples / "office" / "office.regions"
    desk = luxpipe.render(SCENE, VIEW, None, size=64, max_frames=2, metrics="TAL", regions=regions)["desk.TAL"]
    assert 300 < desk.value < 1500


def test_arrays_need_a_view():
    white = np.ones((32, 32))
    with pytest.raises(ValueError, match="view"):
        luxpipe.measure(white)
    with pytest.raises(ValueError, match="height x width"):
        luxpipe.measure(np.ones((3, 32, 32)), view=FISHEYE)
    grey = luxpipe.measure(white * 500, view=FISHEYE)
    colour = luxpipe.measure(np.full((32, 32, 3), 500 / 179), view=FISHEYE.split())
    assert grey["Ev"].value == pytest.approx(colour["Ev"].value, rel=1e-5)


def test_frames_end_with_the_loop():
    for step in luxpipe.frames(SCENE, VIEW, size=32):
        if step.frames >= 3:
            break
    del step
    assert children() == []


def test_frames_keep_memory_flat():
    sizes = []
    for step in luxpipe.frames(SCENE, VIEW, size=128, max_frames=25, every="1"):
        sizes.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
        assert step.picture.shape == (128, 128, 3)
    assert sizes[-1] - sizes[6] < 2000  # kB; a picture has 196


def test_not_converged():
    result = luxpipe.render(SCENE, VIEW, "DGP 1e-9", size=32, max_frames=4)
    assert not result.converged and result.frames == 3 and "-max-frames" in result.reason


@pytest.mark.parametrize("call, message", [
    (lambda: luxpipe.render([SCENE[1]], VIEW), r'^ptrace: .*: modifier "carpet" is not defined$'),
    (lambda: luxpipe.render(SCENE, VIEW, "DPG 0.01"), r"^vcmetrics: -until: "),
    (lambda: luxpipe.render(SCENE, VIEW, options=["-abb", "3"]), r"^ptrace: -abb: "),
    (lambda: luxpipe.render(SCENE, "no.vf"), r"^ptrace: no.vf: "),
    (lambda: luxpipe.measure("no.hdr"), r"^vcmetrics: no.hdr: "),
    (lambda: luxpipe.evalglare(b"no picture"), r"^vcmetrics: stdin: is not a RADIANCE picture"),
    (lambda: luxpipe.rpict(["-vf", str(VIEW)], "no.oct"), r"^ptrace: no.oct: ")])
def test_errors_are_the_programs_lines(call, message):
    with pytest.raises(luxpipe.Error, match=message) as error:
        call()
    assert "\n" not in str(error.value) and error.value.status in (1, 2)
    assert children() == []


def test_other_errors(monkeypatch):
    with pytest.raises(ValueError, match="max_frames"):
        luxpipe.render(SCENE, VIEW, None, max_frames=None)
    with pytest.raises(FileNotFoundError, match="no_such.rad"):
        luxpipe.render("no_such.rad", VIEW)
    monkeypatch.setenv("LUXPIPE_BIN", "/nowhere")
    with pytest.raises(luxpipe.Error, match="ptrace: no such program in /nowhere"):
        luxpipe.render(SCENE, VIEW)


def test_warnings_are_python_warnings(tmp_path):
    strange = tmp_path / "strange.rad"
    strange.write_text("void plastic strange 0 0 5 1.5 .5 .5 0 0\nstrange sphere s 0 0 4 0 0 50 .1\n")
    with pytest.warns(luxpipe.Warning, match="^ptrace: .*strange"):
        luxpipe.render([*SCENE, strange], VIEW, None, size=16, max_frames=1)


def test_plots():
    pytest.importorskip("matplotlib").use("Agg")
    found = doctest.testmod(importlib.import_module("luxpipe.plot"), extraglobs={"luxpipe": luxpipe})
    assert found.attempted and not found.failed


def test_sources(office):
    found = office.sources()
    assert sum(source["DGPshare"] for source in found) == pytest.approx(1, abs=1e-4)
    assert len(office.sources("-b", "1e6")) == 0


def test_sources_are_drawn_where_they_are(office):
    pytest.importorskip("matplotlib").use("Agg")
    plot = importlib.import_module("luxpipe.plot")
    axes = plot.sources(office)
    found = office.sources()
    shares = {text.get_text(): text.xy for text in axes.texts}
    assert len(axes.texts) == sum(source["DGPshare"] >= 0.005 for source in found)
    window = max(found, key=lambda source: source["DGPshare"])
    (x, y), inside = shares[f"{window['DGPshare']:.0%}"], [patch.get_path() for patch in axes.patches]
    assert any(path.get_extents().contains(x, y) for path in inside)
    assert all(0 <= v <= 64 for path in inside for v in path.vertices.ravel() + .5)


def test_intervals_are_drawn(office):
    pytest.importorskip("matplotlib").use("Agg")
    steps = [step for step in luxpipe.frames(SCENE, VIEW, size=16, max_frames=9)]
    axes = importlib.import_module("luxpipe.plot").intervals(steps, "Ev")
    frames, values = axes.lines[0].get_data()
    assert list(frames) == list(range(1, 9)) and values[-1] == steps[-1]["Ev"].value
    assert axes.get_xscale() == "log" and axes.get_ylabel() == "Ev"


def test_progress_on_a_terminal():
    pytest.importorskip("tqdm")
    terminal, end = os.openpty()
    code = "import luxpipe; from conftest import *; luxpipe.render(SCENE, VIEW, None, size=16, max_frames=4)"
    here = os.path.dirname(__file__)
    done = subprocess.run([sys.executable, "-c", code], stderr=end, cwd=here)
    said = os.read(terminal, 100000)
    assert done.returncode == 0 and b" frames" in said and b"DGPf 0." in said
    done = subprocess.run([sys.executable, "-c", code], stderr=subprocess.PIPE, cwd=here)
    assert done.returncode == 0 and done.stderr == b""


def test_interrupt_keeps_what_there_is(monkeypatch):
    class Bar(luxpipe._render._NoBar):
        def update(self, frames):
            if frames >= 2:
                os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr("luxpipe._render._progress", Bar)
    result = luxpipe.render(SCENE, VIEW, "Ev 1e-9", size=32)
    assert not result.converged and result.reason == f"interrupted after {result.frames} frames"
    assert result.frames >= 2 and result.picture.shape == (32, 32, 3) and children() == []


def test_pyradiance_names(hdr):
    said = luxpipe.evalglare(hdr, detailed=True, threshold=2000, task_area=None, smooth=True, search_radius=0.3)
    words = ["-like", "evalglare", "-d", "-s", "-b", "2000", "-r", "0.3", str(hdr)]
    alone = subprocess.run([program("vcmetrics"), *words], capture_output=True).stdout
    assert said.split()[-7:] == alone.split()[-7:] and b"Eglare" in said
    assert float(luxpipe.evalglare(hdr.read_bytes(), ev_only=True)) == pytest.approx(2830, rel=0.03)
    with pytest.raises(TypeError):
        luxpipe.evalglare(3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        picture = luxpipe.rpict(["-vf", str(VIEW)], SCENE[0], 16, 16, params=["-ad", "64", "-ab", "2"], frames=2)
    assert luxpipe.read(picture).shape == (16, 16, 3)


def test_pyradiance_takes_the_same_words():
    pyradiance = pytest.importorskip("pyradiance")
    import inspect
    for name in ("evalglare", "rpict"):
        theirs, ours = (inspect.signature(getattr(m, name)).parameters for m in (pyradiance, luxpipe))
        assert [p for p in ours if p in theirs] == list(theirs)
        assert all(ours[p].default == theirs[p].default for p in theirs)


def test_types():
    pytest.importorskip("mypy")
    top = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    done = subprocess.run([sys.executable, "-m", "mypy", "--no-incremental"], cwd=top, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("size", ["256", (1, 2, 3), 3.5])
def test_a_size_is_pixels_or_two_numbers_of_them(size):
    with pytest.raises(ValueError, match=r"^size: .* is neither a number of pixels nor \(width, height\)$"):
        luxpipe.render(SCENE, VIEW, size=size)


def test_the_library_of_materials_is_there() -> None:
    assert {f.name for f in luxpipe.materials.iterdir()} == {"blinds.rad", "fabrics.rad", "glazings.rad", "paints.rad"}
