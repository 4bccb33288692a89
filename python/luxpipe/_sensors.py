# SPDX-License-Identifier: BSD-3-Clause
"""sensors: the illuminance of points with intervals, by ptrace -points | ptaccum | vcmetrics -each."""

from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Sequence

from ._programs import chain
from ._render import PathLike, _files
from ._rtrace import MOST_FRAMES, UNTIL, pass_on

if TYPE_CHECKING:
    import pandas


def sensors(scene: PathLike | Sequence[PathLike], points: PathLike | Sequence[PathLike] | Sequence[Sequence[float]],
            until: str = f"each {UNTIL}", *, ci: float = 95, max_frames: int = MOST_FRAMES, seed: int = 1,
            options: Sequence[str] = ()) -> pandas.DataFrame | list[dict[str, Any]]:
    """Return a row for each point: grid, x y z dx dy dz, its illuminance E in lx, lo and hi of its interval, and
    errors: its standard error and degrees of freedom, as "E=12.3/23".

    The rows are a pandas table where pandas is installed, else a list of dictionaries.  A rule that was not met is a
    `Warning`.

    Args:
        scene: RADIANCE's files, one or several, or the folder of a Honeybee model
        points: a file of rtrace's lines, several (grids), a folder of .pts files, or rows of x y z dx dy dz
        until: half widths of 95 % intervals at which to stop (vcmetrics -until): "each 2%" holds where 95 of 100 points
            of each grid are within 2 %; "desk.mean 1%, desk.share300 .02" are numbers of a grid
        ci: certainty of the intervals in percent
        max_frames: number of frames, frame 0 among them, at which to stop in any case
        seed: of the random numbers; the same seed gives the same values
        options: further options of ptrace, as ["-ab", "7"]

    Examples:
        >>> office = luxpipe.examples / "office"
        >>> scene = [office / "materials.rad", office / "layout.rad", office / "sky_overcast.rad"]
        >>> table = luxpipe.sensors(scene, [(2, 2, .8, 0, 0, 1), (2, 1, .8, 0, 0, 1)], "each 5%")
        >>> len(table), list(table)[-3:] if hasattr(table, "columns") else list(table[0])[-3:]
        (2, ['lo', 'hi', 'errors'])
    """
    with tempfile.TemporaryDirectory() as folder:
        given: list[Any] = [points] if isinstance(points, (str, os.PathLike)) else list(points)
        if not given:
            raise ValueError("no points are given")
        if not isinstance(given[0], (str, os.PathLike)):
            for k, point in enumerate(given, 1):
                if len(point) != 6:
                    raise ValueError(f"points: row {k} has {len(point)} numbers, not six: x y z dx dy dz")
            rows_of_points = "".join(" ".join(repr(float(x)) for x in point) + "\n" for point in given)
            given = [Path(folder, "points")]
            given[0].write_text(rows_of_points)
        files = [os.fspath(file) for file in given]
        grids = [word for file in files for word in ("-points", file)]
        lines, said, status = chain([
            ["ptrace", "-moments-", "-seed", str(seed), *options, *grids, *_files(scene)],
            ["ptaccum", "-every", "x2/4"],
            ["vcmetrics", "-each", *grids, "-ci", str(ci), "-until", until, "-max-frames", str(max_frames), "-format",
             "jsonl"]])
    pass_on(said, f"sensors: after {max_frames} frames the rule \"{until}\" does not hold" if status else "")
    rows = [json.loads(line) for line in lines.splitlines()]
    try:
        import pandas
    except ImportError:
        return rows
    return pandas.DataFrame(rows)
