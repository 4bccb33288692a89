# SPDX-License-Identifier: BSD-3-Clause
"""RADIANCE pictures with 32-bit float pixels, as luxpipe's programs pass them on (man 5 luxpipe-stream), and arrays."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, BinaryIO

from ._programs import Error

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt


def read_picture(stream: BinaryIO) -> bytearray | None:
    """Read one float picture with its moments (a second one, LAYERS=); return None at the end of the stream.

    The stream must not be buffered: no byte beyond the picture is read.
    """
    picture = _read_one(stream)
    if picture is not None and b"\nLAYERS=moments\n" in picture[:picture.find(b"\n\n") + 1]:
        layer = _read_one(stream)
        if layer is None:
            raise Error("luxpipe: stream: ends before the moments of a picture")
        picture += layer
    return picture


def _read_one(stream: BinaryIO) -> bytearray | None:
    lines: list[bytes] = []
    while True:
        line = stream.readline()
        if not line:
            if lines:
                raise Error("luxpipe: stream: ends inside a header")
            return None
        lines.append(line)
        if line == b"\n":
            break
    if any(line.startswith(b"FAILED=") for line in lines):  # the program that wrote it says why
        return None
    resolution = stream.readline()
    size = re.fullmatch(rb"-Y (\d+) \+X (\d+)\n", resolution)
    if not size or b"FORMAT=float\n" not in lines:
        raise Error(f"luxpipe: stream: not a float picture: {resolution[:60]!r}")
    head = b"".join(lines) + resolution
    numbers = 4 if b"NCOMP=4\n" in lines else 3
    picture = bytearray(len(head) + 4 * numbers * int(size[1]) * int(size[2]))
    picture[:len(head)] = head
    rest = memoryview(picture)[len(head):]
    while rest:
        got = stream.readinto(rest)  # type: ignore[attr-defined]
        if not got:
            raise Error("luxpipe: stream: ends inside a picture")
        rest = rest[got:]
    return picture


def pixels(picture: bytes | bytearray) -> npt.NDArray[np.float32]:
    """Return the pixels of a float picture, height x width x 3, without a copy."""
    import numpy as np
    head = re.match(rb"(?s).*?\n\n-Y (\d+) \+X (\d+)\n", picture)
    if not head:
        raise Error("luxpipe: picture: no float picture with rows from the top")
    height, width = int(head[1]), int(head[2])
    array = np.frombuffer(picture, "<f4", 3 * height * width, head.end()).reshape(height, width, 3)
    array.flags.writeable = False
    return array


def alone(picture: bytes | bytearray) -> bytes:
    """Return a picture without the number of the last frame of the stream (LASTFRAME=) that it was a part of."""
    end = picture.index(b"\n\n")
    return re.sub(rb"\nLASTFRAME=\d+", b"", picture[:end]) + bytes(memoryview(picture)[end:])


def from_array(array: npt.NDArray[Any], view: str) -> bytes:
    """Return an array as a float picture: height x width x 3 in W/(sr m2), or height x width in cd/m2 (grey)."""
    import numpy as np
    radiance = np.asarray(array, dtype="<f4")
    if radiance.ndim == 2:
        radiance = np.repeat(radiance[:, :, None] / np.float32(179), 3, axis=2)
    if radiance.ndim != 3 or radiance.shape[2] != 3:
        raise ValueError(f"height x width x 3 (radiance) or height x width (cd/m2) are needed, not {radiance.shape}")
    height, width = radiance.shape[:2]
    head = f"#?RADIANCE\nVIEW= {view}\nNCOMP=3\nBigEndian=0\nFORMAT=float\n\n-Y {height} +X {width}\n"
    return head.encode() + radiance.tobytes()
