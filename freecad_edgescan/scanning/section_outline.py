# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a picture of one section shows besides its points, as curves in the section's own plane.

The part's surface on both sides, the probe's balls that touch it, the ellipses of the edge point
and the circle of the rounding; all of it in the coordinates of a `ScanLine`, mm.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from .corner import across_axes
from .scan_lines import ScanLine
from .scanned_edge import ScannedEdge

__all__ = ["SectionOutline", "circle_points", "section_outline"]

Array = NDArray[np.float64]

_BALL_AT = 0.45  # of a side's length, where a ball is drawn on it
_LONG = 100.0  # fillet radii, by which a side is drawn out to find the circle that touches it


@dataclass(frozen=True)
class SectionOutline:
    """One section with everything that is drawn of it.

    Attributes
    ----------
    line : points, removed points and fitted sides
    surfaces : two (k, 2) polylines, the part's surface from the edge point on: the fitted sides,
        moved by the probe radius where the cloud holds probe centres
    probe_radius : mm; 0 when the points lie on the surface
    balls : (b, 2) centres of probe balls that touch the surface
    covariance : (2, 2) mm², of the edge point, in the plane's axes
    fillet : centre (2,) and radius of the rounding, mm; None where none is measurable
    """

    line: ScanLine
    surfaces: tuple[Array, Array]
    probe_radius: float
    balls: Array
    covariance: Array
    fillet: tuple[Array, float] | None

    def ellipse(self, sigmas: float) -> Array:
        """Outline of the edge point's ellipse of so many sigma, (121, 2) mm."""
        values, vectors = np.linalg.eigh(self.covariance)
        half = np.sqrt(np.maximum(values, 0.0))
        ring = vectors @ (half[:, None] * circle_points(np.zeros(2), sigmas).T)
        return np.asarray(ring.T + self.line.edge_point)


def section_outline(edge: ScannedEdge, number: int) -> SectionOutline:
    """Outline of the section of one edge point.

    Parameters
    ----------
    number : of the edge point
    """
    line = edge.scan_lines[number]
    turn = line.axes @ across_axes(edge.normals[number]).T
    probe = float(edge.parameters.probe_radius or 0.0)
    surfaces = line.curves
    balls = np.zeros((0, 2))
    if probe:
        first, second = (_moved_to(curve, line.edge_point, probe) for curve in line.curves)
        surfaces, balls = (first, second), _balls(line, probe)
    return SectionOutline(
        line,
        surfaces,
        probe,
        balls,
        turn @ edge.covariance[number] @ turn.T,
        _fillet(surfaces, line.edge_point, float(edge.fillet_radius[number])),
    )


def circle_points(centre: Array, radius: float) -> Array:
    """A circle as a closed polyline, (121, 2)."""
    turn = np.linspace(0.0, 2.0 * np.pi, 121)
    return np.asarray(centre + radius * np.column_stack([np.cos(turn), np.sin(turn)]))


def _moved_to(curve: Array, edge_point: Array, distance: float) -> Array:
    """The parallel of a curve that passes through the edge point, from there on."""
    along = np.gradient(curve, axis=0)
    normal = np.column_stack([-along[:, 1], along[:, 0]])
    normal *= distance / np.linalg.norm(along, axis=1)[:, None]
    ways = [curve + normal, curve - normal]
    gaps = [np.linalg.norm(way - edge_point, axis=1) for way in ways]
    best = int(gaps[1].min() < gaps[0].min())
    return np.vstack([edge_point, ways[best][int(np.argmin(gaps[best])) + 1 :]])


def _balls(line: ScanLine, probe: float) -> Array:
    """One on each side, and one that rolled round the edge when there is any."""
    centres = [curve[int(_BALL_AT * len(curve))] for curve in line.curves]
    removed = line.points[np.asarray(line.removed, dtype=bool)]
    rolling = removed[np.linalg.norm(removed - line.edge_point, axis=1) < 2.0 * probe]
    if len(rolling):
        aside = np.abs(np.linalg.norm(rolling - line.edge_point, axis=1) - probe)
        centres.append(rolling[np.argmin(aside + np.abs(rolling[:, 0] - line.edge_point[0]))])
    return np.array(centres)


def _fillet(
    surfaces: tuple[Array, Array], edge_point: Array, radius: float
) -> tuple[Array, float] | None:
    """The circle of the rounding: it touches both sides, on the bisector inside of their wedge."""
    if not np.isfinite(radius) or min(len(side) for side in surfaces) < 2:
        return None
    drawn_out = [_drawn_out(side, _LONG * radius) for side in surfaces]

    def clearance(depth: float) -> float:
        # The plane's second axis points out of the wedge.
        centre = edge_point - np.array([0.0, depth])
        return float(np.mean([_distance(centre, side) for side in drawn_out])) - radius

    deepest = 0.5 * _LONG * radius
    if clearance(0.0) >= 0.0 or clearance(deepest) <= 0.0:
        return None
    depth = float(brentq(clearance, 0.0, deepest))
    return edge_point - np.array([0.0, depth]), radius


def _drawn_out(curve: Array, length: float) -> Array:
    """A curve with a straight piece at its far end."""
    last = curve[-1] - curve[-2]
    return np.vstack([curve, curve[-1] + length * last / max(float(np.linalg.norm(last)), 1e-300)])


def _distance(point: Array, curve: Array) -> float:
    """Distance of a point from a polyline."""
    begin, along = curve[:-1], np.diff(curve, axis=0)
    size = np.maximum(np.einsum("ki,ki->k", along, along), 1e-300)
    share = np.clip(np.einsum("ki,ki->k", point - begin, along) / size, 0.0, 1.0)
    return float(np.linalg.norm(point - begin - share[:, None] * along, axis=1).min())
