# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of one section across a scanned edge: what was touched, and what came of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..scanning import ScannedEdge, SectionOutline, section_outline
from ..scanning.section_outline import circle_points
from .figures import new_figure, save_figure

__all__ = ["draw_section"]

_INSET = 5.0  # sigmas shown to each side of the edge point in the inset


def draw_section(edge: ScannedEdge, at: int | ArrayLike, path: str | Path) -> None:
    """Draw points, removed points, fitted sides, and the edge point with its sigma.

    Where the cloud holds probe centres, the sides moved by the probe radius are drawn too: they
    are the part's surface, and meet in the edge point.

    Parameters
    ----------
    edge : ScannedEdge
    at : number of the edge point, or a place (3,), mm, to draw the section nearest to it
    path : picture file; its ending (.png, .svg, .pdf) chooses the format

    Raises
    ------
    ValueError: matplotlib is missing, or does not know the ending.
    """
    number = _number(edge, at)
    outline = section_outline(edge, number)
    line = outline.line
    figure = new_figure(path, 10.0, 7.0)
    axes = figure.add_subplot()
    removed = np.asarray(line.removed, dtype=bool)
    axes.plot(*line.points[removed].T, "x", ms=5, color="0.55", label="points of no side")
    for side in (0, 1):
        used = line.points[(line.side == side) & ~removed]
        axes.plot(*used.T, ".", ms=5, color=f"C{side}", label=f"points on side {side + 1}")
        axes.plot(*line.curves[side].T, "-", lw=1.2, color=f"C{side}", label=f"side {side + 1}")
    if outline.probe_radius:
        _draw_surface(axes, outline)
    if outline.fillet is not None:
        centre, radius = outline.fillet
        ring = circle_points(centre, radius)
        axes.plot(*ring.T, "-.", lw=0.9, color="0.4", label=f"rounding, radius {radius:.3g} mm")
    axes.plot(*line.edge_point, "k+", ms=12, mew=1.5, label="edge point")
    axes.set(
        xlabel="across the edge, mm",
        ylabel="out of the wedge, mm",
        title=f"Section {number + 1} of {len(edge)}, "
        f"angle {np.degrees(edge.angle[number]):.1f} degrees",
        aspect="equal",
    )
    axes.margins(0.04)
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), fontsize="small", frameon=False)
    _draw_sigma(axes.inset_axes([1.08, 0.0, 0.26, 0.36]), outline, float(edge.sigma[number]))
    save_figure(figure, path)


def _draw_sigma(axes: Any, outline: SectionOutline, sigma: float) -> None:
    """The edge point alone, with the ellipses of one and two sigma, in µm."""
    for times, style in ((1, "-"), (2, "--")):
        ring = 1e3 * (outline.ellipse(times) - outline.line.edge_point)
        axes.plot(*ring.T, "k" + style, lw=0.8)
    axes.plot(0.0, 0.0, "k+", ms=12, mew=1.5)
    size = 1e3 * _INSET / 2.0 * sigma
    axes.set(xlim=(-size, size), ylim=(-size, size), aspect="equal")
    axes.set_title("edge point, 1 and 2 sigma, µm", fontsize="small")
    axes.tick_params(labelsize="small")


def _number(edge: ScannedEdge, at: int | ArrayLike) -> int:
    place = np.asarray(at, dtype=np.float64)
    if place.ndim == 0:
        return int(place)
    return int(np.argmin(np.linalg.norm(edge.points - place, axis=1)))


def _draw_surface(axes: Any, outline: SectionOutline) -> None:
    """The part's surface, a probe radius beside the fitted sides, and balls that touch it."""
    probe = outline.probe_radius
    labels = ("true surface: sides moved by the probe radius", None)
    for surface, label in zip(outline.surfaces, labels, strict=True):
        axes.plot(*surface.T, "--", lw=0.9, color="k", label=label)
    for number, centre in enumerate(outline.balls):
        label = f"probe ball, radius {probe:g} mm" if number == 0 else None
        axes.plot(*circle_points(centre, probe).T, "-", lw=0.7, color="C2", label=label)
        axes.plot(*centre, "o", ms=3, color="C2")
