# SPDX-License-Identifier: BSD-3-Clause
"""difference: what two runs differ by, with intervals (vcmetrics -difference)."""

from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Sequence, Union

from . import _stream
from ._programs import run
from ._render import _measure_options
from ._result import Interval, Result

if TYPE_CHECKING:
    from ._render import PathLike

Run = Union[str, "os.PathLike[str]", Sequence[Result]]


def difference(a: Run, b: Run, metrics: str | Sequence[str] = "Ev,DGP,DGPf", *, ci: float = 95,
               regions: PathLike | None = None, options: Sequence[str] = ()) -> dict[str, Interval]:
    """Return what b is above a, an `Interval` for each metric; one that does not hold 0 tells the two apart.

    A run is an OpenEXR file of ``ptaccum -o a.exr``, or the list of results of `frames`.  Two runs of the same seed,
    size and frames share noise, so that their difference is known better than of independent runs.  Of pictures by
    themselves there is a difference without an interval.  options are further options of vcmetrics.

    Examples:
        >>> office = luxpipe.examples / "office"
        >>> room = [office / "materials.rad", office / "layout.rad"]
        >>> a, b = [list(luxpipe.frames([*room, office / sky], office / "view.vf", size=32, max_frames=8))
        ...         for sky in ("sky_overcast.rad", "sky_1400.rad")]
        >>> luxpipe.difference(a, b)["Ev"].lo > 0
        True
    """
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for name, source in (("a", a), ("b", b)):
            if isinstance(source, (str, os.PathLike)):
                files.append(os.fspath(source))
                continue
            path = Path(folder) / name
            with path.open("wb") as stream:
                for result in source:
                    stream.write(_stream.alone(result._float_bytes()))
            files.append(str(path))
        said = run("vcmetrics", ["-difference", *_measure_options(metrics, ci, regions), *options, *files])
    rows = [json.loads(line) for line in said.splitlines()]
    nan = float("nan")
    return {row["metric"]: Interval(*(nan if row[name] is None else row[name] for name in ("difference", "lo", "hi")))
            for row in rows}
