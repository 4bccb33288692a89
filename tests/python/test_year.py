# SPDX-License-Identifier: BSD-3-Clause
"""A few hours of a year from Python: the numbers of the pipe, a table, a map, errors."""

import sys

import luxpipe
import pytest
from conftest import SCENE, VIEW

WEATHER = """place Here
latitude 39.74
longitude 105.18
time_zone 105
site_elevation 1829
weather_data_file_units 1
3 21 5.5 0 0
3 21 9.5 700 90
3 21 12.5 800 100
"""


@pytest.fixture(scope="module")
def weather(tmp_path_factory):
    path = tmp_path_factory.mktemp("year") / "site.wea"
    path.write_text(WEATHER)
    return path


@pytest.fixture(scope="module")
def year(weather):
    return luxpipe.year(SCENE[:2], VIEW, weather, hours="all", size=24, frames=4)


def test_a_year_has_lines_summary_and_text(year):
    assert [line["sky"] for line in year.lines] == ["0321_0530", "0321_0930", "0321_1230"]
    assert year.lines[0]["Ev"] == 0 and year.lines[2]["Ev"] > 500
    assert year.lines[2]["DGPf.lo"] < year.lines[2]["DGPf.hi"]
    (summary,) = year.summary
    assert summary["hours"] == 3 and summary["dark"] == 1
    assert summary["DGPe5.lo"] <= summary["DGPe5"] <= summary["DGPe5.hi"]
    assert str(year).startswith("hours     3, 1 dark")


def test_its_map_is_shown_and_saved(year, tmp_path):
    assert year._repr_svg_().startswith("<svg")
    shown = year._repr_html_()
    assert all(line in shown for line in str(year).splitlines()) and "<svg" in shown
    year.plot(tmp_path / "year.png")
    assert (tmp_path / "year.png").read_bytes()[1:4] == b"PNG"


def test_states_of_blinds_and_the_rules_that_move_them(weather, tmp_path):
    shut = tmp_path / "shut.rad"
    shut.write_text("void plastic p 0 0 5 .2 .2 .2 0 0\n"
                    "p polygon shut 0 0 12 .1 .06 .5  3.9 .06 .5  3.9 .06 2.7  .1 .06 2.7\n")
    states = ["open", f"shut={shut}"]
    options = dict(hours="all", size=24, frames=4, states=states)
    still = luxpipe.year(SCENE[:2], VIEW, weather, **options)
    assert [line["state"] for line in still.lines] == ["open"] * 3 + ["shut"] * 3
    assert "shades" not in str(still) and still.summary[0]["hours"] == 3
    moved = luxpipe.year(SCENE[:2], VIEW, weather, shades="glare .2", **options)
    assert "why       glare .2 in 2 hours" in str(moved) and moved.summary[0]["shut"] == 2
    assert moved.summary[0]["DGPe5"] < still.summary[0]["DGPe5"]
    assert "shades shut: glare .2" in moved._repr_svg_()


def test_its_table(year):
    pytest.importorskip("pandas")
    hours = year.hours
    assert list(hours.index.hour) == [5, 9, 12] and hours["frame"].tolist() == [0, 3, 3]


def test_a_scene_with_a_sky_is_an_error(weather):
    with pytest.raises(luxpipe.Error, match="sky_1400.rad:.* beside that of the weather file; -second-sky allows it"):
        luxpipe.year([*SCENE[:2], luxpipe.examples / "office" / "sky_1400.rad"], VIEW, weather, size=24)


def test_errors_are_ptraces_line(weather):
    with pytest.raises(luxpipe.Error, match="ptrace: -hours: .* means no hour"):
        luxpipe.year(SCENE[:2], VIEW, weather, hours="Dec", size=24)


def test_without_pandas_a_sentence_says_what_needs_none(year, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match="Year.lines needs none"):
        year.hours
