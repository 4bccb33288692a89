# SPDX-License-Identifier: BSD-3-Clause
"""What a measurement gives: numbers with intervals, and the picture they are of."""

from __future__ import annotations

import base64
import html
import json
import math
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _stream
from ._programs import run

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas


class Interval(NamedTuple):
    """A metric: its value in the picture, and the interval of the value that the picture converges to.

    lo and hi are nan where no interval is known: in single pictures, and before the second frame.

    Examples:
        >>> print(Interval(0.3508, 0.3506, 0.3510))
        0.3508 (0.3506 to 0.351)
    """

    value: float
    lo: float = math.nan
    hi: float = math.nan

    def __str__(self) -> str:
        known = "" if math.isnan(self.lo) else f" ({self.lo:.4g} to {self.hi:.4g})"
        return f"{self.value:.4g}{known}"


class Result:
    """Metrics of a picture, and the picture.  ``result["DGP"]`` is an `Interval`.

    Attributes:
        row: the line of vcmetrics, names and values as they came (also `class`, `tails`, `errors`, `view`)
        frames: number of diffuse frames in the picture; 0 for pictures that luxpipe did not render
        seconds: since the start of the programs
        converged: whether the rule of `until` held; of the last result of a run
        reason: why the run stopped, in words; of the last result of a run
    """

    def __init__(self, row: dict[str, Any], source: bytes | bytearray | Path):
        self.row = row
        self.frames = int(row.get("frame") or 0)
        self.seconds = float(row.get("seconds") or 0.0)
        self.converged = False
        self.reason = ""
        self._source = source

    @property
    def values(self) -> dict[str, Interval]:
        """All metrics by name, each an `Interval`."""
        def number(name: str) -> float:
            found = self.row.get(name)
            return math.nan if found is None else float(found)
        return {name: Interval(number(name), number(name + ".lo"), number(name + ".hi"))
                for name, value in self.row.items()
                if name not in ("frame", "seconds") and not name.endswith((".lo", ".hi"))
                and not isinstance(value, str)}

    def __getitem__(self, name: str) -> Interval:
        try:
            return self.values[name]
        except KeyError:
            raise KeyError(f"{name}: not measured; metrics= names what is: {', '.join(self.values)}") from None

    @property
    def metrics(self) -> pandas.DataFrame:
        """All metrics as a table: a row for each, with the columns value, lo and hi (needs pandas)."""
        try:
            import pandas
        except ImportError:
            raise ImportError("Result.metrics is a table of pandas, which is not installed; Result.values needs none") \
                from None
        return pandas.DataFrame.from_dict(self.values, orient="index", columns=list(Interval._fields))

    @property
    def picture(self) -> npt.NDArray[np.float32]:
        """Radiance in W/(sr m2): height x width x 3 (red, green, blue), rows from the top; read only."""
        return _stream.pixels(self._float_bytes())

    @property
    def luminance(self) -> npt.NDArray[np.float32]:
        """Luminance in cd/m2: an array of height x width, rows from the top."""
        import numpy as np
        return self.picture @ (179 * np.array([0.265074, 0.670115, 0.064811], dtype=np.float32))

    def sources(self, *options: str) -> list[dict[str, Any]]:
        """Return the glare sources, a dict each, as `vcmetrics -sources` lists them; options are further ones (-b 5).

        x and y count pixels from the lower left corner.  outline has closed lines x, y, x, y ... in pixels from the
        upper left corner.
        """
        words = ["-sources", "-outlines", "-format", "jsonl", *options, "-"]
        said = run("vcmetrics", words, _stream.alone(self._float_bytes()))
        return [json.loads(line) for line in said.splitlines()]

    def _float_bytes(self) -> bytes | bytearray:
        if isinstance(self._source, Path):
            self._source = run("ptaccum", [str(self._source), "-ff", "-o", "-"])
        elif b"\nFORMAT=float\n" not in self._source[:4096]:
            self._source = run("ptaccum", ["-", "-ff", "-o", "-"], self._source)
        return self._source

    def save(self, path: str | os.PathLike[str], *options: str) -> None:
        """Write the picture to a file: .hdr (RADIANCE's), .exr or .png; options are those of ptaccum.

        ``result.save("colors.png", "-tone", "falsecolor", "-max", "5000")``
        """
        run("ptaccum", ["-", "-o", os.fspath(path), *options], _stream.alone(self._float_bytes()))

    def __repr__(self) -> str:
        numbers = ", ".join(f"{name} {value}" for name, value in self.values.items())
        return f"<luxpipe.Result: {numbers}; {self.frames} frames>"

    def _repr_html_(self) -> str:
        with tempfile.TemporaryDirectory() as folder:
            png = Path(folder) / "picture.png"
            self.save(png, "-tone", "falsecolor")
            image = base64.b64encode(_without_text(png.read_bytes())).decode()
        rows = "".join(f"<tr><th>{html.escape(name)}</th>" + "".join(
            f"<td>{'' if math.isnan(x) else format(x, '.4g')}</td>" for x in value) + "</tr>"
            for name, value in self.values.items())
        caption = html.escape(self.reason or f"{self.frames} frames")
        return (f'<div style="display:flex;gap:1em;align-items:flex-start">'
                f'<img src="data:image/png;base64,{image}" style="max-height:400px" alt="luminance in false colours">'
                f"<div><table><tr><th></th><th>value</th><th>lo</th><th>hi</th></tr>{rows}</table>"
                f"{caption}</div></div>")


def _without_text(png: bytes) -> bytes:
    """Return a PNG file without its comment: the command lines in it name this machine's folders."""
    kept, at = [png[:8]], 8
    while at < len(png):
        end = at + 12 + int.from_bytes(png[at:at + 4], "big")
        if png[at + 4:at + 8] != b"tEXt":
            kept.append(png[at:end])
        at = end
    return b"".join(kept)
