# SPDX-License-Identifier: BSD-3-Clause
"""rtrace by ptrace -points | ptaccum | vcmetrics -like rtrace: its options, its formats of rays and values."""

from __future__ import annotations

import math
import os
import re
import shlex
import sys
import tempfile
import warnings
from array import array
from typing import Sequence

from ._programs import Error, chain, program, until_or_frames
from ._render import Warning

UNTIL = "2%"  # of a point's value: half of its 95 % interval, for 95 of 100 points of each run
MOST_FRAMES = 1025  # frame 0 and whole blocks of 64; where points in deep shade would need more, a warning says so


class Request:
    """rtrace's command line: what is ptrace's, and the formats.

    >>> request = Request(["-h", "-I", "-ab", "2", "-faf", "-x", "3", "-y", "2", "-u+", "room.oct"])
    >>> request.words, request.header, request.irradiance, request.formats, request.size
    (['-ab', '2', 'room.oct'], False, True, 'af', [3, 2])
    """

    def __init__(self, words: Sequence[str]):
        self.header, self.irradiance, self.formats, self.size = True, False, "aa", [0, 0]
        self.words: list[str] = []
        self.given = list(words)
        rest = iter(words)
        for word in rest:
            switch = re.fullmatch(r"-(h|I|i|u|ld|co)([+1tTyY]|[-0fFnN]|)", word)
            formats = re.fullmatch(r"-f([afd]?)([afdc]?)\d*", word)
            if switch:
                self._switch(*switch.groups())
            elif formats:
                self.formats = (formats[1] or "a") + (formats[2] or formats[1] or "a")
            elif word in ("-x", "-y"):
                value = next(rest, "")
                if not re.fullmatch(r"\d+", value):
                    raise Error(f"rtrace: {word}: \"{value}\" is not a number of rays")
                self.size["-x -y".split().index(word)] = int(value)
            elif re.fullmatch(r"-o[a-zA-Z~]*", word):
                if word not in ("-o", "-ov"):
                    raise Error(f"rtrace: {word}: values only are printed here: -ov")
            elif word in ("-te", "-ti", "-tE", "-tI"):  # of -ot, which is refused
                next(rest, "")
            else:
                self.words.append(word)
        if not self.words or self.words[-1].startswith("-"):
            raise Error("rtrace: an octree or scene file is missing")

    def _switch(self, name: str, to: str) -> None:
        if name == "h":
            self.header = not self.header if to == "" else to in "+1tTyY"
        elif name == "I":
            self.irradiance = not self.irradiance if to == "" else to in "+1tTyY"
        elif name in ("i", "ld", "co") and to in "+1tTyY":  # "": on
            why = {"i": "measures the surface that a ray meets", "ld": "ends rays", "co": "is spectral"}[name]
            raise Error(f"rtrace: -{name}: {why}, which is not done here")


def read_rays(data: bytes, form: str) -> list[float]:
    """Return the numbers of rays, six each, of text (a), floats (f) or doubles (d)."""
    numbers: list[float]
    if form == "a":
        try:
            numbers = [float(word) for word in re.sub(rb"#.*", b"", data).split()]
        except ValueError as error:
            raise Error(f"rtrace: rays: {error}") from None
    else:
        one: array[float] = array(form)
        if len(data) % (6 * one.itemsize):
            raise Error(f"rtrace: rays: {len(data)} bytes are not whole rays of -f{form}")
        one.frombytes(data)
        numbers = one.tolist()
    if len(numbers) % 6:
        raise Error(f"rtrace: rays: the last one has {len(numbers) % 6} of six numbers")
    return numbers


def rgbe(red: float, green: float, blue: float) -> bytes:
    """Return a pixel of a RADIANCE picture: three mantissas and their exponent (Ward, Graphics Gems II, 1991).

    >>> list(rgbe(1, .5, .25)), list(rgbe(0, 0, 0))
    ([128, 64, 32, 129], [0, 0, 0, 0])
    """
    exponent = math.frexp(max(red, green, blue))[1]
    if max(red, green, blue) <= 0 or exponent < -127:
        return bytes(4)
    return bytes([*(int(math.ldexp(max(x, 0), 8 - exponent)) for x in (red, green, blue)), exponent + 128])


def pass_on(said: str, more: str = "") -> None:
    """Give programs' warnings, and one more, as Python's."""
    lines = [line for line in said.splitlines() if ": warning: " in line]
    for line in lines + ([f"luxpipe: warning: {more}"] if more else []):
        warnings.warn(line, Warning, stacklevel=5)


def _values(rays: list[float], request: Request, until: str, frames: int | None) -> list[bytes]:
    """Return a line of three numbers for each ray; 0 where its direction has no length, as rtrace has it."""
    lines = [" ".join(map(repr, rays[i:i + 6])) for i in range(0, len(rays), 6)]
    live = [any(rays[i + 3:i + 6]) for i in range(0, len(rays), 6)]
    if not any(live):
        return [b"0.000000e+00\t0.000000e+00\t0.000000e+00\t"] * len(lines)
    trace = ["-ab", "0", *shlex.split(os.environ.get("LUXPIPE_OPTIONS", "")), "-moments-",
             "-I+" if request.irradiance else "-I-", "-points", "-"]
    rule = ["-until", f"each {until}", "-max-frames", str(MOST_FRAMES)] if frames is None else []
    count = [] if frames is None else ["-frames", str(frames)]
    with tempfile.TemporaryFile() as points:
        points.write("\n".join(line for line, lit in zip(lines, live) if lit).encode() + b"\n")
        points.seek(0)
        values, said, status = chain([["ptrace", *trace, *count, *request.words],
                                      ["ptaccum", "-last"] if frames else ["ptaccum", "-every", "x2/4"],
                                      ["vcmetrics", "-like", "rtrace", *rule]], points)
    pass_on(said, f"after {MOST_FRAMES} frames fewer than 95 of 100 points are within {until}" if status else "")
    found = iter(values.splitlines())
    return [next(found) if lit else b"0.000000e+00\t0.000000e+00\t0.000000e+00\t" for lit in live]


def trace(words: Sequence[str], data: bytes, until: str = UNTIL, frames: int | None = None) -> bytes:
    """Return what rtrace with these words writes for rays; defaults are ptrace's, but -ab 0."""
    request = Request(words)
    rays = read_rays(data, request.formats[0])
    across, down = request.size
    if across and down:
        del rays[6 * across * down:]
    lines = _values(rays, request, until, frames)
    form = request.formats[1]
    head = b""
    if request.header:
        kind = {"a": "ascii", "f": "float", "d": "double", "c": "32-bit_rle_rgbe"}[form]
        order = f"BigEndian={int(sys.byteorder == 'big')}\n" if form in "fd" else ""
        head = f"#?RADIANCE\nrtrace {shlex.join(request.given)}\nNCOMP=3\n{order}FORMAT={kind}\n\n".encode()
    if across and down:
        head += f"-Y {down:8d} +X {across:8d}\n".encode()
    if form == "a":
        return head + b"".join(line + b"\n" for line in lines)
    values = [float(word) for line in lines for word in line.split()]
    if form == "c":
        return head + b"".join(rgbe(*values[i:i + 3]) for i in range(0, len(values), 3))
    return head + array(form, values).tobytes()


def main() -> None:
    """Be rtrace: rays from the standard input, values to the standard output.

    LUXPIPE_UNTIL is the accuracy ("2%"), or a number of frames; LUXPIPE_OPTIONS has further options of ptrace.
    """
    words = sys.argv[1:]
    if any(word in ("-version", "-defaults", "-help") for word in words):
        os.execv(program("ptrace"), ["rtrace", *words])
    warnings.showwarning = lambda message, *_: print(message, file=sys.stderr)
    try:
        sys.stdout.buffer.write(trace(words, sys.stdin.buffer.read(), *until_or_frames(UNTIL)))
    except Error as error:
        print(error, file=sys.stderr)
        sys.exit(error.status)
