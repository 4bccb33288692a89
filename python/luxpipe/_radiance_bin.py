# SPDX-License-Identifier: BSD-3-Clause
"""luxpipe-radiance DIR: a folder that Honeybee, rad and Makefiles take for an installed RADIANCE.

DIR/bin holds rpict, rtrace and evalglare, which are luxpipe's, and links to all other programs of a RADIANCE that is
there; DIR/lib is a link to its lib.
"""

from __future__ import annotations

import argparse
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Optional

from ._programs import HERE, Error, program, until_or_frames

NEEDED = ("cnt dctimestep gendaylit gendaymtx gensky getinfo oconv pcomb pcompos pcond pfilt pvalue ra_tiff ra_xyze "
          "rad rcalc rcontrib rfluxmtx rtrace vwrays xform").split()

MOST_FRAMES = 1025  # of a picture whose error stays above what is asked


def find_radiance() -> Optional[Path]:
    """Return RADIANCE's bin folder: that of oconv in PATH, else pyradiance's."""
    oconv = shutil.which("oconv")
    if oconv:
        return Path(oconv).resolve().parent
    try:
        import pyradiance
        return Path(pyradiance.BINPATH)
    except ImportError:
        return None


def make(folder: Path, radiance: Optional[Path]) -> list[str]:
    """Fill the folder; return the names that Honeybee and rad may ask for and that are missing."""
    (folder / "bin").mkdir(parents=True, exist_ok=True)
    here = f"import sys; sys.path.insert(0, {str(HERE.parent)!r}); from luxpipe."
    ours = {"rpict": [sys.executable, "-c", here + "_radiance_bin import rpict; rpict()"],
            "rtrace": [sys.executable, "-c", here + "_rtrace import main; main()"],
            "evalglare": [program("vcmetrics"), "-like", "evalglare"]}
    for name in [] if radiance is None else sorted(os.listdir(radiance)):
        link(folder / "bin" / name, Path(radiance or "", name))
    if radiance is not None and (radiance.parent / "lib").is_dir():
        link(folder / "lib", radiance.parent / "lib")
    programs = shlex.quote(str(Path(program("ptrace")).resolve().parent))
    for name, words in ours.items():
        script = folder / "bin" / name
        script.unlink(missing_ok=True)
        script.write_text(f'#!/bin/sh\nLUXPIPE_BIN={programs} exec {shlex.join(words)} "$@"\n')
        script.chmod(0o755)
    return [name for name in NEEDED if not (folder / "bin" / name).exists()]


def link(name: Path, target: Path) -> None:
    """Make a symbolic link, in place of one that is there."""
    if name.is_symlink():
        name.unlink()
    if not name.exists():
        name.symlink_to(target)


def rpict() -> None:
    """Be rpict: the sum of frames of ptrace as an RGBE picture, to the standard output or -o; -ab is 0, as rpict's.

    Frames end when the standard error of blocks of 8 x 8 pixels, which ptaccum estimates, is LUXPIPE_UNTIL (3%, rms),
    which may be a number of frames instead.
    LUXPIPE_OPTIONS has further options of ptrace, which recipes would refuse: "-seed 2 -device cpu".
    """
    args = ["-ab", "0", *shlex.split(os.environ.get("LUXPIPE_OPTIONS", "")), *sys.argv[1:]]
    if any(word in ("-version", "-defaults", "-help") for word in args):
        os.execv(program("ptrace"), ["rpict", *args])
    output = None
    if "-o" in args:
        at = args.index("-o")
        output = open(args[at + 1], "wb")
        del args[at:at + 2]
    until, frames = until_or_frames("3%")
    rule = [] if frames else ["-until", until.rstrip("%")]
    trace = subprocess.Popen(["ptrace", "-moments-", "-frames", str(frames or MOST_FRAMES), *args],
                             executable=program("ptrace"), stdout=subprocess.PIPE)  # RGBE pictures hold no moments
    total = subprocess.run(["ptaccum", "-last", *rule], executable=program("ptaccum"), stdin=trace.stdout,
                           stdout=output, stderr=subprocess.PIPE)
    assert trace.stdout
    trace.stdout.close()
    if trace.wait() == 0:  # else ptrace has said why
        sys.stderr.buffer.write(total.stderr)
    sys.exit(trace.returncode or total.returncode)


def main() -> None:
    """The command luxpipe-radiance."""
    options = argparse.ArgumentParser(prog="luxpipe-radiance", description=(__doc__ or "").partition("\n")[2].strip())
    options.add_argument("folder", type=Path, metavar="DIR", help="folder to make")
    options.add_argument("-radiance", type=Path, metavar="BIN", default=find_radiance(),
                         help="RADIANCE's bin (where oconv is, or pyradiance's)")
    said = options.parse_args()
    if said.radiance is not None and not said.radiance.is_dir():
        sys.exit(f"luxpipe-radiance: {said.radiance}: is no folder")
    try:
        missing = make(said.folder, said.radiance)
    except (Error, OSError) as error:
        sys.exit(f"luxpipe-radiance: {error}")
    print(f"export PATH={shlex.quote(str((said.folder / 'bin').absolute()))}:$PATH")
    if (said.folder / "lib").exists():
        print(f"export RAYPATH=.:{shlex.quote(str((said.folder / 'lib').absolute()))}")
    if missing:
        print(f"luxpipe-radiance: missing, as no RADIANCE has them here: {' '.join(missing)}", file=sys.stderr)
