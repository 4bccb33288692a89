# SPDX-License-Identifier: BSD-3-Clause
"""bits_frames.py BIN TOP DEVICE ...: do an installed ptrace's frames have the bits of tests/golden/bits.tsv?

bits_test.cpp calls the renderer; this reads the frames that the program writes, for the rows that are frames.
TOP is the source tree.  A device that this machine lacks is named and skipped.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

SIZE, RANGES = 40, ("0:6", "32:34")


def hash_of(stream):
    """Fowler, Noll and Vo's hash, 64 bits, of the pixels of all frames."""
    value, at = 0xcbf29ce484222325, 0
    while at < len(stream):
        head = re.compile(rb"(?s).*?\n\n-Y (\d+) \+X (\d+)\n").match(stream, at)
        at = head.end() + 12 * int(head[1]) * int(head[2])
        for byte in stream[head.end():at]:
            value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return f"{value:016x}"


def moved(ptrace, top, device, rows):
    """Return the names of the rows whose frames have other bits, or None where the machine lacks the device."""
    size = ["-x", str(SIZE), "-y", str(SIZE)]
    environment = {**os.environ, "RAYPATH": f".:{top}/tests/golden/vectors"}
    found = []
    for name, folder, arguments, wanted in rows:
        stream = b""
        for frames in RANGES:
            words = [ptrace, "-w-", "-device", device, "-moments-", "-frames", frames, *size, *arguments.split()]
            done = subprocess.run(words, cwd=top / folder, env=environment, capture_output=True)
            if b": this machine has no " in done.stderr:
                return None
            if done.returncode:
                sys.stderr.buffer.write(done.stderr)
            stream += done.stdout
        if hash_of(stream) != wanted:
            found.append(name)
    return found


def main():
    ptrace, top = os.path.abspath(os.path.join(sys.argv[1], "ptrace")), Path(sys.argv[2]).absolute()
    table = (top / "tests" / "golden" / "bits.tsv").read_text().splitlines()
    rows = [row for row in (line.split("\t") for line in table) if len(row) == 4 and row[2]]
    bad = 0
    for device in sys.argv[3:]:
        names = moved(ptrace, top, device, rows)
        bad += len(names or [])
        said = f"{len(rows)} rows, {len(names)} moved" if names is not None else "skipped, this machine has none"
        print(f"{device}: {said}", *(names or []))
    sys.exit(bool(bad))


main()
