# SPDX-License-Identifier: BSD-3-Clause
"""evalglare and rpict with the arguments that pyradiance's functions of these names take; rtrace, which is missing."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import NoReturn, Sequence

from ._programs import Error, last_line, program, run


def evalglare(inp: str | bytes | Path, view: None | list[str] = None, detailed: bool = False, ev_only: bool = False,
              ev: None | float | Sequence[float] = None, smooth: bool = False, threshold: None | float = None,
              task_area: None | tuple[float, ...] = None, masking_file: None | str | Path = None,
              band_lum_angle: None | float = None, check_file: None | str | Path = None,
              correction_mode: None | str = None, peak_extraction: bool = True,
              peak_extraction_value: float = 50000, bg_lum_mode: int = 0, search_radius: float = 0.2,
              version: bool = False, source_color: None | tuple[float, float, float] = None,
              fast: None | int = None) -> bytes:
    """Return evalglare's lines for a picture, by ``vcmetrics -like evalglare``; arguments as pyradiance's evalglare."""
    if not isinstance(inp, (str, bytes, Path)):
        raise TypeError(f"a picture's path or bytes are needed, not {type(inp).__name__}")
    if version:
        return run("vcmetrics", ["-like", "evalglare", "-v"])
    args: list[str] = []

    def add(option: str, *values: object) -> None:
        args.extend([option, *map(str, values)])

    if ev_only:
        add("-V")
    else:
        if detailed:
            add("-d")
        if isinstance(ev, (int, float)):
            add("-i", ev)
        elif ev is not None:
            add("-I", *ev)
        if fast is not None:
            add(f"-{fast}")
        args.extend(view or [])
        if check_file is not None:
            add("-c", check_file)
            if source_color is not None:
                add("-u", *source_color)
        if smooth:
            add("-s")
        if task_area:
            add("-T" if check_file is not None else "-t", *task_area)
        if not peak_extraction:
            add("-x")
        elif peak_extraction_value:
            add("-Y", peak_extraction_value)
        for option, value in (("-b", threshold), ("-q", bg_lum_mode or None), ("-A", masking_file),
                              ("-B", band_lum_angle), ("-C", correction_mode),
                              ("-r", None if search_radius == 0.2 else search_radius)):
            if value is not None:
                add(option, value)
    picture = [] if isinstance(inp, bytes) else [os.fspath(inp)]
    stdin = inp if isinstance(inp, bytes) else None
    # evalglare gives status 1 with -V, when all is well, too
    return run("vcmetrics", ["-like", "evalglare", *args, *picture], stdin, (1,) if ev_only else ())


def rpict(view: Sequence[str], octree: Path | str, xres: None | int = None, yres: None | int = None,
          report: float = 0, report_file: None | Path = None, params: None | Sequence[str] = None, *,
          frames: int = 64) -> bytes:
    """Return a RADIANCE picture (RGBE) of an octree or scene file, by ``ptrace | ptaccum``.

    Arguments are those of pyradiance's rpict, and no -ab is -ab 0, as there.  Options that a path tracer does not need
    (-ad, -aa ...) are accepted.
    frames: number of diffuse samples a pixel.
    """
    args = ["-ab", "0", *view, *(params or [])]
    for option, value in (("-t", report or None), ("-e", report_file), ("-x", xres), ("-y", yres)):
        if value is not None:
            args += [option, str(value)]
    trace = subprocess.Popen(["ptrace", "-moments-", *args, "-frames", str(frames + 1), str(octree)],
                             executable=program("ptrace"), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert trace.stdout and trace.stderr
    with trace:
        total = subprocess.run(["ptaccum", "-last"], executable=program("ptaccum"), stdin=trace.stdout,
                               capture_output=True)
        trace.stdout.close()
        said = trace.stderr.read()
    if trace.returncode:
        raise Error(last_line(said, "ptrace", trace.returncode), trace.returncode)
    if total.returncode:
        raise Error(last_line(total.stderr, "ptaccum", total.returncode), total.returncode)
    return total.stdout


def rtrace(*args: object, **kwargs: object) -> NoReturn:
    """Raise Error: luxpipe does not measure single points yet.  A script can import the name all the same."""
    raise Error("luxpipe: rtrace: does not exist yet; pyradiance.rtrace or RADIANCE's own rtrace measures points")
