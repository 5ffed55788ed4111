# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of scanned edges over their cloud, by matplotlib, which comes with FreeCAD."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud
from ..scanning import ScannedEdge

__all__ = ["draw_edges"]

MOST_DOTS = 40_000  # more only makes the picture slower


def draw_edges(cloud: PointCloud, edges: Sequence[ScannedEdge], path: str | Path) -> None:
    """Draw the cloud in grey and each edge in its colour, seen along the cloud's least extent.

    Two views side by side: the whole cloud, and the surroundings of the edges.

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
    for number, region in enumerate((cloud.bounds, _surroundings(cloud, edges))):
        axes = figure.add_subplot(1, 2, number + 1, projection="3d")
        _draw_region(axes, cloud, edges, region)
    figure.axes[0].legend(loc="upper left")
    figure.savefig(path)


def _surroundings(
    cloud: PointCloud, edges: Sequence[ScannedEdge]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Box round all edge points with a margin."""
    found = np.vstack([edge.points for edge in edges] or [cloud.points])
    margin = max(5 * cloud.pitch, 0.05 * float(np.ptp(found, axis=0).max()))
    return found.min(axis=0) - margin, found.max(axis=0) + margin


def _draw_region(
    axes: Any,
    cloud: PointCloud,
    edges: Sequence[ScannedEdge],
    region: tuple[NDArray[np.float64], NDArray[np.float64]],
) -> None:
    lowest, highest = region
    inside = np.flatnonzero(((cloud.points >= lowest) & (cloud.points <= highest)).all(axis=1))
    step = max(1, len(inside) // MOST_DOTS)
    dots = cloud.points[inside[::step]]
    axes.scatter(*dots.T, s=0.4, c="0.6", linewidths=0, depthshade=False)
    for number, edge in enumerate(edges, 1):
        points = np.vstack([edge.points, edge.points[:1]]) if edge.closed else edge.points
        axes.plot(*points.T, lw=2, label=f"edge {number}", zorder=10)
    axes.set_box_aspect(np.maximum(highest - lowest, 1e-9))
    axes.set(xlabel="x, mm", ylabel="y, mm", zlabel="z, mm")
