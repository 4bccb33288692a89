# SPDX-License-Identifier: BSD-3-Clause
"""year: the hours of a weather file (ptrace -wea), measured, and what they come to (vcyear)."""

from __future__ import annotations

import html
import json
import os
import subprocess
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Sequence

from ._programs import Error, last_line, program, run, width_and_height
from ._render import PathLike, _files, view_options

if TYPE_CHECKING:
    import pandas


WORDS = ("view", "sky", "state", "tails", "errors", "paths", "hour")  # columns that are no numbers


class Year:
    """What `year` returns: the hours as a table, and their summary.

    Attributes:
        text: vcyear's five lines
        summary: its numbers by name ("DGPe5", "DGPe5.lo", "class" ...), a dictionary for each view
        lines: the last line of each hour and state, a dictionary of columns
    """

    def __init__(self, table: str, options: Sequence[str] = ()):
        self._table = table
        self._options = list(options)
        self.text = self._counted([]).decode()
        self.summary = [json.loads(line) for line in self._counted(["-format", "jsonl"]).splitlines()]
        names, *rows = (line.split("\t") for line in table.splitlines())
        last = {}
        for row in rows:
            line = {name: cell if name in WORDS else float(cell) for name, cell in zip(names, row)}
            last[line.get("view", ""), line.get("state", ""), line["sky"]] = line
        self.lines: list[dict[str, Any]] = list(last.values())

    def _counted(self, options: Sequence[str]) -> bytes:
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder, "hours.tsv")
            table.write_text(self._table)
            return run("vcyear", [*self._options, *options, str(table)])

    def __str__(self) -> str:
        return self.text

    @property
    def hours(self) -> pandas.DataFrame:
        """A pandas table, a row for each hour, view and state, by date (of 2001) and hour."""
        try:
            import pandas
        except ImportError:
            raise ImportError("Year.hours is a table of pandas, which is not installed; Year.lines needs none") \
                from None
        table = pandas.DataFrame(self.lines)
        table["time"] = pandas.to_datetime("2001" + table["sky"].str.replace("0229", "0301"), format="%Y%m%d_%H%M")
        return table.set_index("time")

    def plot(self, path: PathLike) -> None:
        """Write the heat map of days by hours, .svg or .png."""
        self._counted(["-plot", os.fspath(path)])

    def _repr_svg_(self) -> str:
        with tempfile.TemporaryDirectory() as folder:
            self.plot(Path(folder, "year.svg"))
            return Path(folder, "year.svg").read_text()

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.text)}</pre>{self._repr_svg_()}"


def year(scene: PathLike | Sequence[PathLike], view: PathLike | Sequence[str], weather: PathLike, *,
         hours: str = "Mo-Fr 8-18", size: int | tuple[int, int] = 64, frames: int = 33, seed: int = 1,
         states: Sequence[str] = (), shades: str = "", options: Sequence[str] = ()) -> Year:
    """Render the hours of a weather file, all from one set of paths, and return a `Year`.

    Args:
        scene: RADIANCE's files without a sky, one or several, or the folder of a Honeybee model
        view: a view file (path), or view options; with options=["-views", "desks.vf"] several, which begin with it
        weather: an EPW or WEA file
        hours: which hours, as "Mo-Fr 8-18" (ptrace -hours)
        size: pixels, of a square or (width, height)
        frames: of each hour, frame 0 among them
        seed: of the random numbers
        states: of blinds, as "half=half.rad", from the most open one on (ptrace -state)
        shades: by which rules they move, as "glare .40" (vcyear -shades); without rules the first state is counted, and
            all are in the lines
        options: further options of ptrace

    Examples:
        >>> office = luxpipe.examples / "office"
        >>> scene = [office / "materials.rad", office / "layout.rad"]
        >>> y = luxpipe.year(scene, office / "view.vf", "site.epw", hours="0321 9-15", size=32)  # doctest: +SKIP
        >>> print(y)                                                                            # doctest: +SKIP
    """
    width, height = width_and_height(size)
    trace = [*view_options(view), "-x", str(width), "-y", str(height), "-seed", str(seed), "-frames", str(frames),
             "-wea", os.fspath(weather), "-hours", hours, *(word for state in states for word in ("-state", state)),
             *options, *_files(scene)]
    said = {name: tempfile.TemporaryFile() for name in ("ptrace", "ptaccum", "vcmetrics")}
    words = {"ptrace": trace, "ptaccum": ["-every", "x2/8"],
             "vcmetrics": ["-metrics", "Ev,DGPf,DGP.px,DGPf.px,pixels", "-ci", "95", "-last"]}
    pipe: Any = subprocess.DEVNULL
    programs = []
    for name, args in words.items():
        programs.append(subprocess.Popen([name, *args], executable=program(name), stdin=pipe, stdout=subprocess.PIPE,
                                         stderr=said[name]))
        if pipe is not subprocess.DEVNULL:
            pipe.close()  # or the program before would not see this one end
        pipe = programs[-1].stdout
    try:
        table = pipe.read().decode()
        for process, (name, text) in zip(programs, said.items()):
            if status := process.wait():
                text.seek(0)
                raise Error(last_line(text.read(), name, status), status)
    finally:
        for process in programs:
            process.kill()
            process.wait()
        pipe.close()
        for text in said.values():
            text.close()
    if states and not shades:
        return Year(table, ["-state", states[0].partition("=")[0]])
    return Year(table, ["-shades", shades] if shades else [])
