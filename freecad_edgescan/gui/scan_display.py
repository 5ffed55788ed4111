# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything the scan panel shows in the 3D view, and takes away again."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import numpy as np
from pivy import coin

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import ScannedEdge

from .edge_preview import EdgePreview
from .live_edge import LiveEdge
from .picking import Array
from .thinned_clouds import ThinnedClouds
from .view_clicks import is_open
from .view_form import ViewForm
from .view_ray import view_ray

__all__ = ["ScanDisplay"]

_AROUND = 1.2  # amplitudes that are seen when looking along the edge
_NEAR = 12  # logical pixels within which the mouse is over an edge point


class ScanDisplay:
    """Thinned clouds, clicks, the edge with its scan lines, and the section that is looked at.

    Parameters
    ----------
    view : the 3D view to show it in, until ``close``
    """

    def __init__(self, view: Any) -> None:
        self._view = view
        self._edge: ScannedEdge | None = None
        self._number = 0
        self._slab_only = False
        self.preview = EdgePreview(view)
        self.clouds = ThinnedClouds(view)

    def show_clouds(self, clouds: Sequence[tuple[Any, PointCloud]]) -> None:
        """Show these clouds, with fewer points where they are large."""
        self.clouds.show(clouds)

    def show_growing(self, edge: LiveEdge) -> None:
        """Show an edge as far as it is known."""
        self.preview.show_edge(edge)

    def show_found(self, edge: ScannedEdge, drawn: LiveEdge) -> None:
        """Show a finished edge."""
        self._edge = edge
        self.preview.show_edge(drawn)

    def show_no_edge(self) -> None:
        """Show no edge any more."""
        self._edge = None
        self.preview.clear_edge()
        self.clouds.clip(None)

    def show_section(self, number: int) -> None:
        """Mark the section of an edge point; show its slab of points only, when that is wanted."""
        if self._edge is None:
            return
        self._number = number
        line = self._edge.scan_lines[number]
        self.preview.show_section(line.in_space(np.vstack([line.curves[0][::-1], line.curves[1]])))
        self._clip()

    def choose(self, wanted: ViewForm) -> None:
        """Follow the choices about the view."""
        self.preview.colour_by_sigma(wanted.by_sigma)
        # Scan lines before and behind the section would cover it.
        self.preview.show_scan_lines(wanted.scan_lines and not wanted.slab_only)
        self.clouds.resize(wanted.point_size)
        self._slab_only = wanted.slab_only
        self._clip()

    def edge_point_at(self, position: tuple[int, int]) -> int | None:
        """Number of the finished edge's point under the mouse, or None."""
        if self._edge is None or not is_open(self._view):
            return None
        ray = view_ray(self._view, position, _NEAR)
        away = self._edge.points - ray.origin
        depth = away @ ray.direction
        distance = np.linalg.norm(away - depth[:, None] * ray.direction, axis=1)
        share = distance / np.maximum(ray.radius + ray.slope * depth, 1e-12)
        best = int(np.argmin(share))
        return best if share[best] <= 1.0 else None

    def look_along(self) -> None:
        """Turn the camera so that the section is seen as the panel draws it."""
        if self._edge is None:
            return
        line = self._edge.scan_lines[self._number]
        right, up = line.axes
        towards = np.cross(right, up)
        turn = np.column_stack([right, up, towards])
        matrix = FreeCAD.Matrix(*(value for row in turn for value in (*row.tolist(), 0.0)))
        self._view.setCameraOrientation(FreeCAD.Placement(matrix).Rotation.Q)
        amplitude = float(self._edge.parameters.amplitude or 0.0)
        self._frame(self._edge.points[self._number], _AROUND * amplitude)

    def close(self, restore: bool = True) -> None:
        """Leave the view as it was; without restoring, when the document is going."""
        self.clouds.close(restore)
        self.preview.close()
        self._edge = None

    def _clip(self) -> None:
        slab = None
        if self._slab_only and self._edge is not None:
            pitch = float(self._edge.parameters.edge_pitch or 0.0)
            least = float(self._edge.parameters.cloud_pitch or 0.0)
            tangent = self._edge.tangents[self._number]
            slab = (self._edge.points[self._number], tangent, max(pitch, 1.5 * least))
        self.clouds.clip(slab)

    def _frame(self, place: Array, size: float) -> None:
        """Move the camera so that it sees a place with some mm round it, from where it looks."""
        camera = self._view.getCameraNode()
        ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0.0, 0.0, -1.0))
        away = camera.focalDistance.getValue()
        if size > 0.0 and hasattr(camera, "heightAngle"):
            away = 0.5 * size / np.tan(0.5 * camera.heightAngle.getValue())
            camera.focalDistance.setValue(away)
        elif size > 0.0:
            camera.height.setValue(size)
        position = place - away * np.array(ahead.getValue(), dtype=float)
        camera.position.setValue(*position.tolist())
