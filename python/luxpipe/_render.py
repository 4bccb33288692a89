# SPDX-License-Identifier: BSD-3-Clause
"""render, frames, measure: ptrace | ptaccum | vcmetrics, with Python between the last two to keep the pictures."""

from __future__ import annotations

import json
import os
import select
import shlex
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator, Sequence, Union

from . import _stream
from ._programs import Error, last_line, program, run, width_and_height
from ._result import Result

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

PathLike = Union[str, "os.PathLike[str]"]


class Warning(UserWarning):
    """A warning of one of luxpipe's programs."""


def view_options(view: PathLike | Sequence[str]) -> list[str]:
    """Return a view as options: of a view file (or picture), of "-vta -vp 0 0 1 ...", or of such words in a list."""
    if isinstance(view, os.PathLike):
        return ["-vf", os.fspath(view)]
    if isinstance(view, str):
        return shlex.split(view) if view.lstrip().startswith("-") else ["-vf", view]
    return [str(word) for word in view]


def _files(scene: PathLike | Sequence[PathLike]) -> list[str]:
    if isinstance(scene, (str, os.PathLike)):
        scene = [scene]
    files = [os.fspath(file) for file in scene]
    for file in files:
        if not os.path.exists(file):
            raise FileNotFoundError(f"{file}: no such scene file or folder")
    return files


def _measure_options(metrics: str | Sequence[str], ci: float, regions: PathLike | None) -> list[str]:
    names = metrics if isinstance(metrics, str) else ",".join(metrics)
    options = ["-format", "jsonl", "-ci", str(ci), "-metrics", names]
    return options + (["-regions", os.fspath(regions)] if regions is not None else [])


def _illuminance(action: str) -> str:
    """The column of an action's picture, of which each has a line."""
    alpha_opic = {"mel": "mEDI", "rh": "rhEDI", "sc": "scEDI", "mc": "mcEDI", "lc": "lcEDI", "V": "EvV"}
    return alpha_opic.get(action, "E_" + Path(action).stem)


class _Pipeline:
    """ptrace | ptaccum | this process | vcmetrics, out of reach of the terminal's Ctrl-C, which Python gets alone."""

    def __init__(self, trace: list[str], sums: list[str], measure: list[str]):
        self.said = {name: tempfile.TemporaryFile() for name in ("ptrace", "ptaccum", "vcmetrics")}
        self.ptrace = self._start("ptrace", trace, None)
        self.ptaccum = self._start("ptaccum", sums, self.ptrace.stdout)
        self.ptrace.stdout.close()  # type: ignore[union-attr]  # or ptrace would not see ptaccum end
        self.vcmetrics = self._start("vcmetrics", measure, subprocess.PIPE)

    def _start(self, name: str, args: list[str], stdin: Any) -> subprocess.Popen[bytes]:
        return subprocess.Popen([name, *args], executable=program(name),  # pictures' headers do not hold its folder
                                stdin=subprocess.DEVNULL if stdin is None else stdin, stdout=subprocess.PIPE,
                                stderr=self.said[name], bufsize=0, start_new_session=True)

    def steps(self) -> Iterator[tuple[bytearray, bytes]]:
        """Yield each picture with vcmetrics' line, until vcmetrics has seen enough or the pictures end."""
        pictures, lines, feed = self.ptaccum.stdout, self.vcmetrics.stdout, self.vcmetrics.stdin
        assert pictures and lines and feed
        while lines not in select.select([pictures, lines], [], [])[0]:  # else vcmetrics has ended
            try:
                picture = _stream.read_picture(pictures)  # type: ignore[arg-type]
                if picture is None:
                    return
                rest = memoryview(picture)
                while rest:
                    rest = rest[feed.write(rest):]
            except (BrokenPipeError, Error):
                return  # finish() says which program ended
            line = lines.readline()
            if not line:
                return
            yield picture, line

    def finish(self) -> tuple[int, str]:
        """Close the pipes, wait, pass warnings on; return vcmetrics' status and last words, or raise Error."""
        for pipe in (self.vcmetrics.stdin, self.ptaccum.stdout, self.vcmetrics.stdout):
            pipe.close()  # type: ignore[union-attr]
        last = ""
        failed = None
        for name, said in self.said.items():
            status = getattr(self, name).wait()
            said.seek(0)
            text = said.read()
            for line in text.decode(errors="replace").splitlines():
                if ": warning: " in line:
                    warnings.warn(line, Warning, stacklevel=4)
                last = line
            if status not in (0, 4) and failed is None:
                failed = Error(last_line(text, name, status), status)
        if failed:
            raise failed
        return status, last

    def stop(self) -> None:
        """End all programs that still run."""
        for process in (self.vcmetrics, self.ptaccum, self.ptrace):
            process.kill()
            for pipe in (process.stdin, process.stdout):
                if pipe:
                    pipe.close()
            process.wait()
        for said in self.said.values():
            said.close()


def frames(scene: PathLike | Sequence[PathLike], view: PathLike | Sequence[str], until: str | None = None, *,
           size: int | tuple[int, int] = 512, metrics: str | Sequence[str] = "Ev,DGP,DGPf", ci: float = 95,
           regions: PathLike | None = None, every: str = "x2/16", max_frames: int | None = None,
           max_seconds: float | None = None, seed: int = 1, actions: Sequence[str] = (),
           options: Sequence[str] = (), measure_options: Sequence[str] = ()) -> Iterator[Result]:
    """Render a scene and yield a `Result` for each picture of the growing sum; arguments as of `render`.

    Ends when the rule of `until` holds, at `max_frames` or `max_seconds`, or when the loop is left; without any of
    these never.  One picture is held at a time, unless the caller keeps results.

    Examples:
        >>> office = luxpipe.examples / "office"
        >>> scene = [office / "materials.rad", office / "layout.rad", office / "sky_1400.rad"]
        >>> [step.frames for step in luxpipe.frames(scene, office / "view.vf", size=32, max_frames=4)]
        [0, 1, 2, 3]
    """
    width, height = width_and_height(size)
    trace = [*view_options(view), "-x", str(width), "-y", str(height), "-seed", str(seed)]
    if actions and max_frames is None:
        raise ValueError("actions need max_frames: their pictures come after all frames of the ordinary one")
    for action in actions:
        trace += ["-action", action]
    names = metrics.split(",") if isinstance(metrics, str) else list(metrics)
    names += [name for name in map(_illuminance, actions) if name not in names]
    measure = [*_measure_options(names, ci, regions), *measure_options]
    for option, value in (("-until", until), ("-max-frames", max_frames), ("-max-seconds", max_seconds)):
        if value is not None and not (actions and option == "-max-frames"):
            measure += [option, str(value)]
    if max_frames is not None:
        trace += ["-frames", str(max_frames)]
    pipeline = _Pipeline([*trace, *options, *_files(scene)], ["-every", every], measure)
    try:
        result = None
        ordinary = None
        for picture, line in pipeline.steps():
            if ordinary is None or b"\nACTION=" not in picture[:picture.find(b"\n\n")]:
                ordinary = picture
            result = Result(json.loads(line), ordinary)
            yield result
        status, reason = pipeline.finish()
        if result is None:
            raise Error("luxpipe: no picture came")
        result.converged = until is not None and status == 0
        result.reason = reason
    finally:
        pipeline.stop()


def render(scene: PathLike | Sequence[PathLike], view: PathLike | Sequence[str], until: str | None = "DGPf 0.01", *,
           size: int | tuple[int, int] = 512, metrics: str | Sequence[str] = "Ev,DGP,DGPf", ci: float = 95,
           regions: PathLike | None = None, every: str = "x2/16", max_frames: int | None = 1000,
           max_seconds: float | None = None, seed: int = 1, actions: Sequence[str] = (),
           options: Sequence[str] = (), measure_options: Sequence[str] = ()) -> Result:
    """Render a scene until its numbers are certain enough, and return the last `Result`.

    Ctrl-C ends the run and returns what there is (converged is False then); before the first picture it is raised.
    Where tqdm is installed a line on the terminal, or in the notebook, shows how far it is.

    Args:
        scene: RADIANCE's files, one or several, or the folder of a Honeybee model
        view: a view file (path), or view options: "-vta -vp 2 1 1.2 -vd 0 1 0 -vh 180 -vv 180"
        until: half widths of 95 % intervals at which to stop, as "DGPf 0.01, Ev 1%" (vcmetrics -until); None for none
        size: pixels, of a square or (width, height)
        metrics: names of what is measured, "Ev,DGP" or a list; all are in vcmetrics(1)
        ci: certainty of the intervals in percent
        regions: a file of regions (vcregion), for their TAL, mean ... and contrast
        every: after which frames to measure; "x2/16": 16 times while the number of frames doubles
        max_frames: number of frames, frame 0 among them, at which to stop in any case; None for no limit
        max_seconds: time after which to stop in any case
        seed: of the random numbers; the same seed gives the same pixels
        actions: pictures by other weights than luminance, ["mel", "V"] (ptrace -action), each of max_frames frames
            behind the ordinary one; result["mEDI"], and with metrics "Ev,mEDI,mDER" the melanopic ratio
        options: further options of ptrace, as ["-ab", "7"]
        measure_options: further options of vcmetrics, as ["-task", "desk"]
    """
    result = None
    if until is None and max_frames is None and max_seconds is None:
        raise ValueError("one of until, max_frames and max_seconds is needed: nothing else would end the run")
    steps = frames(scene, view, until, size=size, metrics=metrics, ci=ci, regions=regions, every=every,
                   max_frames=max_frames, max_seconds=max_seconds, seed=seed, actions=actions,
                   options=options, measure_options=measure_options)
    with _progress() as bar:
        try:
            for result in steps:
                bar.update(result.frames - bar.n)
                bar.set_postfix_str(", ".join(f"{name} {value}" for name, value in result.values.items()))
        except KeyboardInterrupt:
            if result is None:
                raise
            result.reason = f"interrupted after {result.frames} frames"
        finally:
            steps.close()  # type: ignore[attr-defined]
    assert result
    return result


class _NoBar:
    n = 0

    def __enter__(self) -> _NoBar:
        return self

    def __exit__(self, *ignored: object) -> None:
        pass

    def update(self, frames: int) -> None:
        pass

    def set_postfix_str(self, text: str) -> None:
        pass


def _progress() -> Any:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # tqdm's, where a notebook has no widgets
            from tqdm.auto import tqdm
        return tqdm(unit=" frames", disable=False if "ipykernel" in sys.modules else None, leave=False)
    except ImportError:
        return _NoBar()


def read(picture: PathLike | bytes) -> npt.NDArray[np.float32]:
    """Read a picture (RADIANCE's, OpenEXR): height x width x 3 radiances in W/(sr m2), rows from the top."""
    return Result({}, picture if isinstance(picture, bytes) else Path(picture)).picture


def measure(picture: PathLike | bytes | npt.NDArray[Any], metrics: str | Sequence[str] = "Ev,DGP", *,
            view: PathLike | Sequence[str] | None = None, ci: float = 95, regions: PathLike | None = None,
            options: Sequence[str] = ()) -> Result:
    """Measure a picture: a file (RADIANCE's, OpenEXR), its bytes, or an array.

    An array holds radiance (height x width x 3, W/(sr m2)) or luminance (height x width, cd/m2), rows from the top, and
    needs its view.  options are further options of vcmetrics.

    Examples:
        >>> import numpy
        >>> grey = numpy.full((64, 64), 1000.0)
        >>> ev = luxpipe.measure(grey, view="-vta -vh 180 -vv 180")["Ev"].value
        >>> abs(ev / (3.14159 * 1000) - 1) < 0.01
        True
    """
    args = _measure_options(metrics, ci, regions)
    source: bytes | bytearray | Path
    if isinstance(picture, (str, os.PathLike)):
        source = Path(picture)
        args += view_options(view) if view is not None else []
        said = run("vcmetrics", [*args, *options, str(source)])
    else:
        if isinstance(picture, (bytes, bytearray)):
            source = picture
            args += view_options(view) if view is not None else []
        elif view is None:
            raise ValueError("an array needs its view, as view=\"-vta -vh 180 -vv 180\"")
        else:
            words = view_options(view)
            if words[0] == "-vf":
                raise ValueError("of an array the view must be options, as view=\"-vta -vh 180 -vv 180\"")
            source = _stream.from_array(picture, " ".join(words))
        said = run("vcmetrics", [*args, *options, "-"], source)
    return Result(json.loads(said.splitlines()[0]), source)
