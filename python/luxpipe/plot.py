# SPDX-License-Identifier: BSD-3-Clause
"""Plots of results, by matplotlib: how intervals narrow, luminance in false colours, glare sources.

Examples:
    >>> import luxpipe
    >>> office = luxpipe.examples / "office"
    >>> scene = [office / "materials.rad", office / "layout.rad", office / "sky_1400.rad"]
    >>> steps = list(luxpipe.frames(scene, office / "view.vf", size=32, max_frames=8))
    >>> axes = luxpipe.plot.intervals(steps, "DGP")
    >>> axes = luxpipe.plot.sources(steps[-1])
"""

from __future__ import annotations

from typing import Any, Iterable

from ._result import Result


def _axes(axes: Any) -> Any:
    if axes is None:
        from matplotlib import pyplot
        axes = pyplot.subplots()[1]
    return axes


def intervals(results: Iterable[Result], name: str, axes: Any = None) -> Any:
    """Draw a metric and its interval against the number of frames (`frames` gives the results); return the axes."""
    rows = [(result.frames, *result[name]) for result in results if result.frames > 0]
    axes = _axes(axes)
    frames, value, lo, hi = zip(*rows)
    axes.fill_between(frames, lo, hi, alpha=0.3, label="interval")
    axes.plot(frames, value, label="picture so far")
    axes.set(xscale="log", xlabel="frames", ylabel=name)
    axes.legend()
    return axes


def falsecolor(result: Result, axes: Any = None, decades: float = 3) -> Any:
    """Show luminance on a logarithmic scale of so many decades, with its bar in cd/m2; return the axes."""
    import numpy as np
    from matplotlib.colors import LogNorm
    axes = _axes(axes)
    luminance = result.luminance
    top = max(float(np.percentile(luminance, 99.9)), 1e-6)
    shown = axes.imshow(np.maximum(luminance, top / 10**decades), norm=LogNorm(top / 10**decades, top), cmap="turbo")
    axes.set_axis_off()
    axes.figure.colorbar(shown, ax=axes, label="cd/m2")
    return axes


def sources(result: Result, axes: Any = None, *options: str) -> Any:
    """Show glare sources: their outlines over the false colours, with shares of DGP (from 0.5 %); return the axes.

    options are those of `Result.sources`.
    """
    axes = falsecolor(result, axes)
    height = len(result.luminance)
    for source in result.sources(*options):
        for line in source["outline"]:
            x, y = ([corner - 0.5 for corner in line[start::2]] for start in (0, 1))
            axes.fill(x, y, fill=False, edgecolor="white")
        if source["DGPshare"] >= 0.005:
            axes.annotate(f"{source['DGPshare']:.0%}", (source["x"], height - 1 - source["y"]), color="white",
                          ha="center", va="center")
    return axes
