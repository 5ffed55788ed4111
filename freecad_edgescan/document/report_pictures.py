# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of a document's report, as PNG data; none where matplotlib is missing."""

from __future__ import annotations

import base64
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud
from ..experiments.cloud_picture import draw_cloud
from ..experiments.edge_picture import draw_edges
from ..experiments.figures import can_draw, new_figure, save_figure
from .bridge import document_points_of
from .deviation_map import save_deviation_map

__all__ = ["along_picture", "cloud_picture", "map_picture"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class _Drawn:
    """What a picture needs of an edge."""

    points: Array
    closed: bool
    normals: Array


def cloud_picture(cloud: PointCloud, edges: Sequence[Any]) -> str:
    """A cloud with the edges scanned in it, as the source of an <img>; "" without matplotlib."""
    drawn: list[Any] = [
        _Drawn(_rows(edge.Points), bool(getattr(edge, "Closed", False)), _normals(edge))
        for edge in edges
    ]
    if not drawn:
        return _as_source(lambda path: draw_cloud(cloud, path))
    names = [edge.Label for edge in edges]
    return _as_source(lambda path: draw_edges(cloud, drawn, path, names=names))


def along_picture(edge: Any) -> str:
    """Sigma, angle and fillet radius along an edge, as the source of an <img>."""
    points = _rows(edge.Points)
    along = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    curves = [("sigma, µm", 1000.0 * np.array(edge.Sigma, dtype=float))]
    if len(getattr(edge, "Angles", [])) == len(along):
        curves.append(("angle, °", np.degrees(np.array(edge.Angles, dtype=float))))
    radii = np.array(getattr(edge, "FilletRadii", []), dtype=float)
    if len(radii) == len(along) and np.isfinite(radii).any():
        curves.append(("rounding, mm", radii))

    def draw(path: Path) -> None:
        figure = new_figure(path, 7.0, 1.3 * len(curves) + 0.4)
        every = figure.subplots(len(curves), sharex=True, squeeze=False)[:, 0]
        for axes, (title, values) in zip(every, curves, strict=True):
            axes.plot(along, values, color="C0", lw=1.2)
            axes.set_ylabel(title)
            axes.grid(alpha=0.4)
        every[-1].set_xlabel("along the edge, mm")
        save_figure(figure, path)

    return _as_source(draw)


def map_picture(deviation_map: Any) -> str:
    """A deviation map in its colours and its histogram, as the source of an <img>."""
    points = document_points_of(deviation_map)
    flattest = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][2]
    view = flattest * (1.0 if flattest[2] >= 0.0 else -1.0)
    return _as_source(lambda path: save_deviation_map(deviation_map, path, view))


def _rows(vectors: Sequence[Any]) -> Array:
    return np.array([tuple(own) for own in vectors], dtype=float).reshape(-1, 3)


def _normals(edge: Any) -> Array:
    """Normals (m, 2, 3) of both sides, from where the edge is looked at."""
    sides = [_rows(getattr(edge, name, [])) for name in ("FirstNormals", "SecondNormals")]
    if any(len(side) != len(edge.Points) for side in sides):
        return np.tile([0.0, 0.0, 1.0], (len(edge.Points), 2, 1))
    return np.stack(sides, axis=1)


def _as_source(draw: Callable[[Path], None]) -> str:
    if not can_draw():
        return ""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "picture.png"
        draw(path)
        return "data:image/png;base64," + base64.b64encode(path.read_bytes()).decode()
