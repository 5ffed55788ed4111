# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of scanned edges on their cloud."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import PointCloud
from ..scanning import ScannedEdge
from .figures import new_figure, save_figure
from .relief import Relief, relief

__all__ = ["draw_edges", "draw_on"]

Array = NDArray[np.float64]

FROM_THE_CORNER = np.array([1.0, -1.2, 0.9])  # the view when the edges do not suggest one
# Told apart from each other and from the grey relief.
COLOURS = (
    *("C0", "C1", "C2", "C3", "C4", "C5", "C6", "black", "C8", "C9"),
    *("lime", "magenta", "navy", "gold"),
)
_HEIGHT = 7.0  # inches, of both drawings
_MOST_ROWS = 28  # of a column of the legend
_WIDEST = 15.0  # inches, of both together


def draw_edges(
    cloud: PointCloud,
    edges: Sequence[ScannedEdge],
    path: str | Path,
    view: ArrayLike | None = None,
    names: Sequence[str] | None = None,
    numbered: bool = False,
) -> None:
    """Draw the cloud as a shaded relief and each edge in its colour, fainter where hidden.

    Left the whole cloud, right the surroundings of the edges, where these are only a part of it.

    Parameters
    ----------
    cloud : PointCloud
    edges : sequence of ScannedEdge
    path : str or Path
        Picture file; its ending (.png, .svg, .pdf) chooses the format.
    view : (3,) or None
        Direction from the part towards the viewer; None: from the air side of the edges.
    names : of the edges; None: "edge 1", "edge 2" and so on
    numbered : write each edge's number, from 1, beside it: for more edges than there are colours

    Raises
    ------
    ValueError: matplotlib is missing, or does not know the ending; a view without a direction.
    """
    direction = _view(edges) if view is None else np.asarray(view, dtype=np.float64)
    if not np.linalg.norm(direction) > 0.0:
        raise ValueError("The view is (0, 0, 0); give a direction from the part to the viewer.")
    whole = relief(cloud.points, cloud.pitch, direction)
    drawings = [whole]
    if edges:
        near = relief(_surroundings(cloud, edges), cloud.pitch, direction)
        if _area(near) < 0.7 * _area(whole):
            drawings.append(near)
    widths = [max(0.25, drawing.depth.shape[1] / drawing.depth.shape[0]) for drawing in drawings]
    height = min(_HEIGHT, _WIDEST / (sum(widths) + 0.3))
    figure = new_figure(path, height * sum(widths) + 1.4 * len(widths), height + 0.6)
    for axes, drawing in zip(_columns(figure, widths), drawings, strict=True):
        draw_on(axes, drawing, edges, names)
        if numbered:
            _write_numbers(axes, drawing, edges)
    if edges:
        figure.axes[-1].legend(
            loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False,
            ncols=-(-len(edges) // _MOST_ROWS),
        )  # fmt: skip
    save_figure(figure, path)


def draw_on(
    axes: Any, seen: Relief, edges: Sequence[ScannedEdge], names: Sequence[str] | None = None
) -> None:
    """Draw a relief and edges into matplotlib axes."""
    axes.imshow(seen.shading(), origin="lower", extent=seen.extent, cmap="gray", vmin=0.0, vmax=1.0)
    for number, edge in enumerate(edges):
        points = np.vstack([edge.points, edge.points[:1]]) if edge.closed else edge.points
        right, up, _ = seen.project(points).T
        shown = seen.visible(points)
        colour = COLOURS[number % len(COLOURS)]
        axes.plot(right, up, color=colour, lw=1, alpha=0.35)
        name = f"edge {number + 1}" if names is None else names[number]
        axes.plot(np.where(shown, right, np.nan), up, color=colour, lw=2.2, label=name)
    axes.set(xlabel="to the right in this view, mm", ylabel="upwards in this view, mm")


def _write_numbers(axes: Any, seen: Relief, edges: Sequence[ScannedEdge]) -> None:
    """Each edge's number half-way along what is seen of it, or along all of it."""
    for number, edge in enumerate(edges):
        shown = np.flatnonzero(seen.visible(edge.points))
        middle = shown[len(shown) // 2] if len(shown) else len(edge) // 2
        right, up, _ = seen.project(edge.points[middle][None])[0]
        axes.text(
            right, up, str(number + 1), ha="center", va="center", fontsize=8, clip_on=True,
            color=COLOURS[number % len(COLOURS)], alpha=1.0 if len(shown) else 0.5,
            bbox={"boxstyle": "round,pad=0.15", "fc": "white", "ec": "none", "alpha": 0.7},
        )  # fmt: skip


def _columns(figure: Any, widths: Sequence[float]) -> list[Any]:
    grid = figure.add_gridspec(1, len(widths), width_ratios=widths)
    return [figure.add_subplot(grid[0, k]) for k in range(len(widths))]


def _area(drawing: Relief) -> float:
    rows, columns = drawing.depth.shape
    return float(rows * columns * drawing.cell**2)


def _view(edges: Sequence[ScannedEdge]) -> Array:
    """Direction to look from: the air side of the edges, where they agree on one."""
    normals = [edge.normals.reshape(-1, 3) for edge in edges]
    mean: Array = np.vstack(normals).mean(axis=0) if normals else np.zeros(3)
    if np.linalg.norm(mean) < 0.4:
        return FROM_THE_CORNER
    return np.asarray(mean / np.linalg.norm(mean) + 0.25 * FROM_THE_CORNER)


def _surroundings(cloud: PointCloud, edges: Sequence[ScannedEdge]) -> Array:
    """Points of the cloud near the edges."""
    found = np.vstack([edge.points for edge in edges])
    lowest, highest = found.min(axis=0), found.max(axis=0)
    margin = max(8 * cloud.pitch, 0.12 * float((highest - lowest).max()))
    points = cloud.points
    inside = ((points >= lowest - margin) & (points <= highest + margin)).all(axis=1)
    return points[inside] if inside.any() else points
