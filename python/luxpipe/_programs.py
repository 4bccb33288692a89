# SPDX-License-Identifier: BSD-3-Clause
"""Where luxpipe's programs are, how they are run, and their errors as exceptions.

The programs are those beside this package (a wheel), in the folder that LUXPIPE_BIN names, or in PATH.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from numbers import Integral
from pathlib import Path
from typing import IO, Sequence

HERE = Path(__file__).resolve().parent


class Error(RuntimeError):
    """A program of luxpipe failed: its line ``tool: place: fact``, and its status (1 input, 2 system)."""

    def __init__(self, message: str, status: int = 1):
        super().__init__(message)
        self.status = status


def width_and_height(size: int | tuple[int, int]) -> tuple[int, int]:
    """Pixels of a picture: a square of so many, or both."""
    both = (size, size) if isinstance(size, Integral) else size
    if isinstance(both, (tuple, list)) and len(both) == 2 and all(isinstance(n, Integral) for n in both):
        return int(both[0]), int(both[1])
    raise ValueError(f"size: {size!r} is neither a number of pixels nor (width, height)")


def program(name: str) -> str:
    """Return the path of a program: "ptrace", "ptaccum", "vcmetrics", "vcregion", "vcyear", "vcview" ..."""
    folder = os.environ.get("LUXPIPE_BIN")
    inside = Path(folder) if folder else HERE / "bin"
    if os.access(inside / name, os.X_OK):
        return str(inside / name)
    found = None if folder else shutil.which(name)
    if not found:
        raise Error(f"luxpipe: {name}: no such program in {inside}" + ("" if folder else " or PATH"), 2)
    return found


def until_or_frames(default: str) -> tuple[str, int | None]:
    """Return LUXPIPE_UNTIL: an accuracy as "3%", or a number of frames, which counts as ptrace -frames does."""
    until = os.environ.get("LUXPIPE_UNTIL") or default
    for old in ("LUXPIPE_ERROR", "LUXPIPE_FRAMES"):  # of version 0.1; the second one did not count frame 0
        value = os.environ.get(old)
        if value:
            until = f"{value}%" if old == "LUXPIPE_ERROR" else str(int(value) + 1)
            print(f"luxpipe: warning: {old}={value}: is called LUXPIPE_UNTIL={until} now", file=sys.stderr)
    return (until, None) if "%" in until else (default, int(until))


def last_line(stderr: bytes, name: str, status: int) -> str:
    """Return the line of a failed program that says why: the last one of its name."""
    lines = stderr.decode(errors="replace").splitlines()
    mine = [line for line in lines if line.startswith(f"{name}: ") and " warning: " not in line]
    return (mine or lines or [f"{name}: ended with status {status}"])[-1]


def run(name: str, args: Sequence[str], stdin: bytes | bytearray | None = None, good: Sequence[int] = ()) -> bytes:
    """Run a program and return its standard output; raise Error where it fails.

    It has failed if its status is not 0, unless that is one of `good` and there is output.
    """
    done = subprocess.run([name, *args], executable=program(name), input=b"" if stdin is None else stdin,
                          capture_output=True)
    if done.returncode and not (done.returncode in good and done.stdout):
        raise Error(last_line(done.stderr, name, done.returncode), done.returncode)
    return done.stdout


def chain(steps: Sequence[Sequence[str]], stdin: int | IO[bytes] = subprocess.DEVNULL) -> tuple[bytes, str, int]:
    """Run programs as a pipe; return the output of the last one, all that was said, and its status, 0 or 4.

    Raise Error where one fails.  4: vcmetrics' rule was not met.
    """
    with tempfile.TemporaryFile() as said:
        running: list[subprocess.Popen[bytes]] = []
        for words in steps:
            before = running[-1].stdout if running else stdin
            running.append(subprocess.Popen(words, executable=program(words[0]), stdin=before, stdout=subprocess.PIPE,
                                            stderr=said))
            if not isinstance(before, int) and before is not None and len(running) > 1:
                before.close()  # or the program would not see the next one end
        output = running[-1].communicate()[0]
        statuses = [one.wait() for one in running]
        said.seek(0)
        text = said.read()
    for words, status in zip(steps, statuses):
        if status and (words[0], status) != ("vcmetrics", 4):
            raise Error(last_line(text, words[0], status), status)
    return output, text.decode(errors="replace"), statuses[-1]


def main() -> None:
    """Become the program of this command's name; what the wheel's commands ptrace, vcmetrics ... do."""
    name = Path(sys.argv[0]).name
    os.execv(program(name), [name, *sys.argv[1:]])
