# SPDX-License-Identifier: BSD-3-Clause
"""Glare metrics with intervals, of RADIANCE scenes, by luxpipe's programs.

Examples:
    >>> import luxpipe
    >>> office = luxpipe.examples / "office"
    >>> scene = [office / "materials.rad", office / "layout.rad", office / "sky_1400.rad"]
    >>> result = luxpipe.render(scene, office / "view.vf", until="Ev 2%", size=64)
    >>> 2750 < result["Ev"].lo < result["Ev"].hi < 2950
    True
    >>> result.converged
    True
    >>> result.picture.shape
    (64, 64, 3)

A scene is files of RADIANCE (text, octrees) or the folder of a Honeybee model; a view is a view file or view options.
`frames` gives the same step by step, `measure` measures pictures and arrays, `difference` compares two runs, `sensors`
gives illuminances of points, `year` renders the hours of a weather file, `evalglare`, `rpict` and `rtrace` take
pyradiance's arguments.  Under all of them run ptrace,
ptaccum and vcmetrics; the line that these print when they fail is the text of `luxpipe.Error`.
"""

from . import plot
from ._difference import difference
from ._programs import Error, HERE as _HERE
from ._radiance import evalglare, rpict, rtrace
from ._render import Warning, frames, measure, read, render
from ._result import Interval, Result
from ._sensors import sensors
from ._year import Year, year

#: The folder of the example scenes: office, classroom, gallery.
examples = _HERE / "examples"
if not examples.is_dir():  # a clone
    examples = _HERE.parents[1] / "examples" / "scenes"

#: The folder of the library of materials: paints.rad, glazings.rad, fabrics.rad, blinds.rad.
materials = _HERE / "share" / "luxpipe" / "library"
if not materials.is_dir():
    materials = _HERE.parents[1] / "library"

__all__ = ["Error", "Interval", "Result", "Warning", "Year", "difference", "evalglare", "examples", "frames",
           "materials", "measure", "plot", "read", "render", "rpict", "rtrace", "sensors", "year"]


def __getattr__(name: str) -> object:
    if name == "__version__":
        from importlib.metadata import version
        return version("luxpipe")
    raise AttributeError(f"module 'luxpipe' has no attribute '{name}'")
