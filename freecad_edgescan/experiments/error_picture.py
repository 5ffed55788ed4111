# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of scanned edges and how far each is from its true edge, beside its own sigma."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import PointCloud, TrueEdge
from ..scanning import ScannedEdge
from ..scanning.corner import across_axes
from .edge_picture import draw_on
from .figures import new_figure, save_figure
from .relief import relief

__all__ = ["draw_errors", "signed_errors"]

Array = NDArray[np.float64]


def signed_errors(edge: ScannedEdge, truth: TrueEdge) -> Array:
    """Error of each edge point in the direction across the edge that is known worst, (m,) mm.

    The sigma of an edge point is its standard deviation in that direction.
    """
    worst = np.linalg.eigh(edge.covariance)[1][:, :, -1]
    worst *= np.where(worst @ np.array([1.0, 0.1]) < 0.0, -1.0, 1.0)[:, None]
    direction = np.einsum("ma,mai->mi", worst, across_axes(edge.normals))
    off = truth.residuals(edge.points)
    return np.asarray(np.einsum("mi,mi->m", off, direction), dtype=np.float64)


def draw_errors(
    cloud: PointCloud,
    edges: Sequence[ScannedEdge],
    truths: Sequence[TrueEdge],
    path: str | Path,
    view: ArrayLike = (0.0, -0.5, 1.0),
) -> None:
    """Draw the edges on their cloud, and below along each edge its error and its ±2 sigma band.

    Parameters
    ----------
    cloud : PointCloud
    edges : sequence of ScannedEdge
    truths : the true edge of each
    path : picture file; its ending (.png, .svg, .pdf) chooses the format
    view : (3,) direction from the part towards the viewer

    Raises
    ------
    ValueError: matplotlib is missing, or does not know the ending.
    """
    rows = (len(edges) + 1) // 2
    seen = relief(cloud.points, cloud.pitch, view)
    tall = 11.0 * seen.depth.shape[0] / seen.depth.shape[1]
    figure = new_figure(path, 11.0, tall + 1.9 * rows)
    grid = figure.add_gridspec(1 + rows, 2, height_ratios=[tall, *[1.9] * rows])
    names = [truth.name for truth in truths]
    axes = figure.add_subplot(grid[0, :])
    draw_on(axes, seen, edges, names)
    axes.legend(loc="center left", bbox_to_anchor=(1.005, 0.5), frameon=False)
    largest = 1.15e3 * max(
        float(np.abs(signed_errors(*pair)).max()) for pair in zip(edges, truths, strict=True)
    )
    for number, (edge, truth) in enumerate(zip(edges, truths, strict=True)):
        panel = figure.add_subplot(grid[1 + number // 2, number % 2])
        _draw_error(panel, edge, truth, f"C{number % 10}")
        panel.set_ylim(-largest, largest)
        if number >= len(edges) - 2:
            panel.set_xlabel("distance along the edge, mm")
        if number % 2 == 0:
            panel.set_ylabel("error, µm")
    save_figure(figure, path)


def _draw_error(axes: Any, edge: ScannedEdge, truth: TrueEdge, colour: str) -> None:
    steps = np.linalg.norm(np.diff(edge.points, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    error, band = signed_errors(edge, truth), 2.0 * edge.sigma
    axes.fill_between(along, -1e3 * band, 1e3 * band, color="0.85", lw=0, label="±2 sigma")
    axes.axhline(0.0, color="0.5", lw=0.6)
    axes.plot(along, 1e3 * error, ".", ms=3, color=colour)
    inside = 100.0 * np.mean(np.abs(error) <= band)
    axes.set_title(
        f"{truth.name}: {inside:.0f} % within ±2 sigma (grey)", fontsize="medium", loc="left"
    )
    axes.set_xlim(0.0, along[-1])
