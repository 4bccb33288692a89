# SPDX-License-Identifier: BSD-3-Clause
"""The office, small, and one rendering of it for all tests."""

import luxpipe
import pytest

OFFICE = luxpipe.examples / "office"
SCENE = [OFFICE / name for name in ("materials.rad", "layout.rad", "sky_1400.rad")]
VIEW = OFFICE / "view.vf"


@pytest.fixture(scope="session")
def office():
    return luxpipe.render(SCENE, VIEW, "Ev 2%", size=64)


@pytest.fixture(scope="session")
def hdr(office, tmp_path_factory):
    path = tmp_path_factory.mktemp("office") / "office.hdr"
    office.save(path)
    return path
