# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of one section across a scanned edge: what was touched, and what came of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..scanning import ScannedEdge
from ..scanning.corner import across_axes
from .figures import new_figure, save_figure

__all__ = ["draw_section"]

Array = NDArray[np.float64]

_INSET = 5.0  # sigmas shown to each side of the edge point in the inset
_BALL_AT = 0.45  # of a side's length, where a ball is drawn on it


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
    line = edge.scan_lines[number]
    figure = new_figure(path, 10.0, 7.0)
    axes = figure.add_subplot()
    removed = np.asarray(line.removed, dtype=bool)
    axes.plot(*line.points[removed].T, "x", ms=5, color="0.55", label="points left out")
    for side in (0, 1):
        used = line.points[(line.side == side) & ~removed]
        axes.plot(*used.T, ".", ms=5, color=f"C{side}", label=f"points on side {side + 1}")
        axes.plot(*line.curves[side].T, "-", lw=1.2, color=f"C{side}", label=f"side {side + 1}")
    probe = edge.parameters.probe_radius
    if probe:
        _draw_surface(axes, line, removed, probe)
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
    _draw_sigma(axes.inset_axes([1.08, 0.0, 0.26, 0.36]), edge, number)
    save_figure(figure, path)


def _draw_sigma(axes: Any, edge: ScannedEdge, number: int) -> None:
    """The edge point alone, with the ellipses of one and two sigma, in µm."""
    line = edge.scan_lines[number]
    turn = line.axes @ across_axes(edge.normals[number]).T
    values, vectors = np.linalg.eigh(turn @ edge.covariance[number] @ turn.T)
    half = np.sqrt(np.maximum(values, 0.0))
    unit = _circle(np.zeros(2), 1.0)
    for times, style in ((1, "-"), (2, "--")):
        axes.plot(*(1e3 * times * vectors @ (half[:, None] * unit)), "k" + style, lw=0.8)
    axes.plot(0.0, 0.0, "k+", ms=12, mew=1.5)
    size = 1e3 * _INSET / 2.0 * float(edge.sigma[number])
    axes.set(xlim=(-size, size), ylim=(-size, size), aspect="equal")
    axes.set_title("edge point, 1 and 2 sigma, µm", fontsize="small")
    axes.tick_params(labelsize="small")


def _number(edge: ScannedEdge, at: int | ArrayLike) -> int:
    place = np.asarray(at, dtype=np.float64)
    if place.ndim == 0:
        return int(place)
    return int(np.argmin(np.linalg.norm(edge.points - place, axis=1)))


def _draw_surface(axes: Any, line: Any, removed: NDArray[np.bool_], probe: float) -> None:
    """The part's surface, a probe radius beside the fitted sides, and balls that touch it."""
    centres = []
    for side, label in ((0, "true surface: sides moved by the probe radius"), (1, None)):
        moved = _moved_towards(line.curves[side], line.edge_point, probe)
        axes.plot(*moved.T, "--", lw=0.9, color="k", label=label)
        centres.append(line.curves[side][int(_BALL_AT * len(line.curves[side]))])
    rolling = line.points[
        removed & (np.linalg.norm(line.points - line.edge_point, axis=1) < 2.0 * probe)
    ]
    if len(rolling):
        aside = np.abs(np.linalg.norm(rolling - line.edge_point, axis=1) - probe)
        centres.append(rolling[np.argmin(aside + np.abs(rolling[:, 0] - line.edge_point[0]))])
    for number, centre in enumerate(centres):
        label = f"probe ball, radius {probe:g} mm" if number == 0 else None
        axes.plot(*_circle(centre, probe), "-", lw=0.7, color="C2", label=label)
        axes.plot(*centre, "o", ms=3, color="C2")


def _moved_towards(curve: Array, edge_point: Array, distance: float) -> Array:
    """The parallel of a curve that passes through the edge point, from there on."""
    along = np.gradient(curve, axis=0)
    normal = np.column_stack([-along[:, 1], along[:, 0]])
    normal *= distance / np.linalg.norm(along, axis=1)[:, None]
    ways = [curve + normal, curve - normal]
    gaps = [np.linalg.norm(way - edge_point, axis=1) for way in ways]
    best = int(gaps[1].min() < gaps[0].min())
    return np.vstack([edge_point, ways[best][int(np.argmin(gaps[best])) + 1 :]])


def _circle(centre: Array, radius: float) -> Array:
    turn = np.linspace(0.0, 2.0 * np.pi, 121)
    return np.asarray(centre[:, None] + radius * np.array([np.cos(turn), np.sin(turn)]))
