# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of scanned edges on their cloud, by matplotlib, which comes with FreeCAD."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud
from ..scanning import ScannedEdge
from .relief import Relief, relief

__all__ = ["draw_edges"]

Array = NDArray[np.float64]

FROM_THE_CORNER = np.array([1.0, -1.2, 0.9])  # the view when the edges do not suggest one


def draw_edges(cloud: PointCloud, edges: Sequence[ScannedEdge], path: str | Path) -> None:
    """Draw the cloud as a shaded relief and each edge in its colour, fainter where hidden.

    Left the whole cloud, right the surroundings of the edges, both seen from the air side.

    Parameters
    ----------
    cloud : PointCloud
    edges : sequence of ScannedEdge
    path : str or Path
        Picture file; its ending (.png, .svg, .pdf) chooses the format.

    Raises
    ------
    ValueError: matplotlib is missing, or does not know the ending.
    """
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        raise ValueError(
            f"The picture {path} needs matplotlib (Debian: python3-matplotlib); "
            "install it or leave the picture out."
        ) from None
    figure = Figure(figsize=(14, 7), dpi=110, layout="constrained")
    FigureCanvasAgg(figure)
    direction = _view(edges)
    for axes, points in zip(
        figure.subplots(1, 2), (cloud.points, _surroundings(cloud, edges)), strict=True
    ):
        _draw(axes, relief(points, cloud.pitch, direction), edges)
    figure.axes[0].legend(loc="upper left")
    figure.savefig(path)


def _view(edges: Sequence[ScannedEdge]) -> Array:
    """Direction to look from: the air side of the edges, where they agree on one."""
    normals = [edge.normals.reshape(-1, 3) for edge in edges]
    mean: Array = np.vstack(normals).mean(axis=0) if normals else np.zeros(3)
    if np.linalg.norm(mean) < 0.4:
        return FROM_THE_CORNER
    return np.asarray(mean / np.linalg.norm(mean) + 0.25 * FROM_THE_CORNER)


def _surroundings(cloud: PointCloud, edges: Sequence[ScannedEdge]) -> Array:
    """Points of the cloud near the edges."""
    found = np.vstack([edge.points for edge in edges]) if edges else cloud.points
    lowest, highest = found.min(axis=0), found.max(axis=0)
    margin = max(8 * cloud.pitch, 0.12 * float((highest - lowest).max()))
    points = cloud.points
    inside = ((points >= lowest - margin) & (points <= highest + margin)).all(axis=1)
    return points[inside] if inside.any() else points


def _draw(axes: Any, seen: Relief, edges: Sequence[ScannedEdge]) -> None:
    axes.imshow(seen.shading(), origin="lower", extent=seen.extent, cmap="gray", vmin=0.0, vmax=1.0)
    for number, edge in enumerate(edges):
        points = np.vstack([edge.points, edge.points[:1]]) if edge.closed else edge.points
        right, up, _ = seen.project(points).T
        hidden = ~seen.visible(points)
        colour = f"C{number % 10}"
        axes.plot(right, up, color=colour, lw=1, alpha=0.35)
        axes.plot(
            np.where(hidden, np.nan, right), up, color=colour, lw=2, label=f"edge {number + 1}"
        )
    axes.set(xlabel="mm", ylabel="mm")
