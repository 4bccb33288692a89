# SPDX-License-Identifier: BSD-3-Clause
"""The cells of examples/notebooks and the examples of python/README.md run, in small pictures."""

import base64
import json
import os
import pathlib
import re

import luxpipe
import pytest
from conftest import SCENE, VIEW
from luxpipe._programs import program, run
from test_year import WEATHER

pytest.importorskip("pandas")
NOTEBOOKS = sorted((pathlib.Path(__file__).parents[2] / "examples" / "notebooks").glob("*.ipynb"))


def test_there_are_notebooks():
    assert len(NOTEBOOKS) == 5


@pytest.mark.parametrize("path", NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
def test_notebook(path, capsys, monkeypatch):
    monkeypatch.setenv("PATH", str(pathlib.Path(program("vcmetrics")).parent), prepend=os.pathsep)
    cells = json.loads(path.read_text())["cells"]
    names = {}
    for cell in cells:
        if cell["cell_type"] == "code":
            source = "".join(cell["source"]).replace("size=256", "size=48").replace("(6, 8, 10, 12)", "(6, 12)")
            source = source.replace("size=64", "size=16").replace("range(1, 13)", "(6, 12)")
            exec(compile(source, path.name, "exec"), names)
            assert cell["outputs"] or "=" in source, f"{path.name}: a cell that shows something keeps what it shows"
    assert path.stat().st_size < 200_000


@pytest.mark.parametrize("path", NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
def test_stored_outputs_name_no_folder_of_a_machine(path):
    outputs = json.dumps([cell.get("outputs") for cell in json.loads(path.read_text())["cells"]])
    images = re.findall(r"[A-Za-z0-9+/=]{1000,}", outputs.replace("\\n", ""))
    assert all(b"VIEW=" not in base64.b64decode(image) for image in images)  # of a header, with commands
    assert not re.search(r"/(work|home|root|tmp|opt|usr)/", re.sub(r"[A-Za-z0-9+/=]{1000,}", "", outputs))


@pytest.mark.parametrize("path", NOTEBOOKS[:1])
def test_notebook_in_jupyter(path):
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    notebook = nbformat.reads(path.read_text().replace("size=256", "size=48"), 4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    assert "image/png;base64" in json.dumps(notebook.cells[1].outputs)


def test_examples_of_the_page(hdr, tmp_path, monkeypatch):
    """The Python of python/README.md runs as it stands, in small pictures."""
    page = pathlib.Path(__file__).parents[2] / "python" / "README.md"
    blocks = re.findall(r"(?s)```python\n(.*?)```", page.read_text())
    assert len(blocks) >= 5
    monkeypatch.chdir(tmp_path)
    for function in (luxpipe.render, luxpipe.frames, luxpipe.year):
        monkeypatch.setitem(function.__kwdefaults__, "size", 24)
    (tmp_path / "site.wea").write_text(WEATHER)
    (tmp_path / "blind.rad").write_text("wall_paint ring blind 0 0 8 2 .1 1.5 0 1 0 0 .5\n")
    (tmp_path / "desk.pts").write_text("2 2 .8 0 0 1\n")
    (tmp_path / "photo.hdr").write_bytes(hdr.read_bytes())
    scene = [str(file) for file in SCENE]
    for name, seed in (("a", "1"), ("b", "2")):
        words = ["-x", "8", "-y", "8", "-vf", str(VIEW), "-frames", "17", "-seed", seed, *scene]
        run("ptaccum", ["-batches", "16", "-o", f"{name}.exr"], run("ptrace", words))
    names = {"array": luxpipe.read(hdr), "view": VIEW, "first": SCENE, "second": SCENE}
    for block in blocks:
        exec(compile(block, "python/README.md", "exec"), names)


def test_python_of_the_front_page(monkeypatch):
    """README.md's lines run as they stand, in a small picture."""
    page = pathlib.Path(__file__).parents[2] / "README.md"
    monkeypatch.setitem(luxpipe.render.__kwdefaults__, "size", 24)
    (block,) = re.findall(r"(?s)```python\n(.*?)```", page.read_text())
    names = {}
    exec(compile(block, "README.md", "exec"), names)
    assert names["result"]["DGPf"].lo > 0.16
