# SPDX-License-Identifier: BSD-3-Clause
"""evalglare, rpict and rtrace with the arguments that pyradiance's functions of these names take."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Sequence

from . import _rtrace
from ._programs import chain, run


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
          frames: int = 65) -> bytes:
    """Return a RADIANCE picture (RGBE) of an octree or scene file, by ``ptrace | ptaccum``.

    Arguments are those of pyradiance's rpict, and no -ab is -ab 0, as there.  Options that a path tracer does not need
    (-ad, -aa ...) are accepted.
    frames: as of ptrace -frames: frame 0 and, in each other one, a diffuse sample a pixel.
    """
    args = ["-ab", "0", *view, *(params or [])]
    for option, value in (("-t", report or None), ("-e", report_file), ("-x", xres), ("-y", yres)):
        if value is not None:
            args += [option, str(value)]
    return chain([["ptrace", "-moments-", *args, "-frames", str(frames), str(octree)], ["ptaccum", "-last"]])[0]


def rtrace(rays: bytes, octree: Path | str, header: bool = True, inform: str = "a", outform: str = "a",
           irradiance: bool = False, irradiance_lambertian: bool = False, outspec: None | str = None,
           trace_exclude: str = "", trace_include: str = "", trace_exclude_file: None | str | Path = None,
           trace_include_file: None | str | Path = None, uncorrelated: bool = False, xres: None | int = None,
           yres: None | int = None, nproc: None | int = None, params: None | Sequence[str] = None,
           report: bool = False, version: bool = False, *, until: str = _rtrace.UNTIL,
           frames: None | int = None) -> bytes:
    """Return what rtrace writes for rays (x y z dx dy dz): radiance, or irradiance of sensors.

    Arguments are those of pyradiance's rtrace; what is not done here (irradiance_lambertian, outspec but "v") raises
    Error, and what chooses modifiers for outspec "t" is of no effect.
    until: half of the 95 % interval of 95 of 100 points, in percent of their value; or frames: their number.

    Examples:
        >>> office = luxpipe.examples / "office"
        >>> done = luxpipe.rtrace(b"2 2 .8 0 0 1", office / "sky_1400.rad", header=False, irradiance=True, frames=2)
        >>> len(done.split())
        3
    """
    if version:
        return run("ptrace", ["-version"])
    if not isinstance(rays, bytes):
        raise TypeError(f"rays must be bytes, not {type(rays).__name__}")
    words = [] if header else ["-h"]
    words += ["-I"] if irradiance else ["-i"] if irradiance_lambertian else []
    words += [f"-f{inform}{outform}"] + ([f"-o{outspec}"] if outspec else [])
    for option, value in (("-x", xres), ("-y", yres), ("-n", nproc or None)):
        words += [] if value is None else [option, str(value)]
    return _rtrace.trace([*words, *(params or []), str(octree)], rays, until, frames)
