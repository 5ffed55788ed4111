# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a scan: edge points with everything that is known about them."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..geometry.plain_number import plain
from .corner import across_axes, largest_sigma
from .edge_point_table import COLUMNS, edge_point_rows
from .parameters import ScanParameters
from .stop import Stop

if TYPE_CHECKING:
    from ..geometry import BSplineCurve, Circle, Line
    from .probed_lines import ProbedLines
    from .scan_lines import ScanLines

Vertex = tuple[np.ndarray, np.ndarray]


@dataclass(frozen=True, repr=False, eq=False)
class ScannedEdge:
    """Edge points in walking order.

    Attributes
    ----------
    points : (m, 3) array, mm
    tangents : (m, 3) unit vectors along the walk
    normals : (m, 2, 3) unit vectors of the two surfaces at the edge: into the air; when that is
        unknown (convex is None) out of the smaller wedge, alike along the whole edge
    angle : (m,) intersection angle θ, rad, in (0, π)
    convex : True when material fills the smaller wedge, False when air does, None when unknown
    covariance : (m, 2, 2) mm², in the two axes across the edge (n1 + n2 and n1 − n2, normalised)
    fillet_radius, fillet_sigma : (m,) mm, nan where no rounding is measurable
    supported : (m,) False where a side has no points of its own, in a gap of the cloud or because
        too little of it looks smooth, and the point rests on its neighbours
    compensation : (m,) how the probe radius was taken off each point
    closed : whether the last point leads back to the first
    stops : why the edge ends, at its start and at its end
    message : what happened and what to try, for a person
    overhang : (m,) mm, how far from the nearest cloud point the two sides meet: little at a sharp
        edge, much where a rounding or wear took the edge away
    vertices : at start and end, the point where surfaces meet with its covariance, or None
    third_normals : at start and end, the unit normal there of the third surface, or None
    single : points (m, 3) and covariance (m, 2, 2) of the sections by themselves, before they were
        smoothed along the edge; curves are fitted to these. None where nothing was smoothed
    reserve : factor in the covariance's standard deviations, above 1 where all points of a short
        edge err together (`whole_edge`); those of ``unsmoothed`` have none
    parameters : the parameters with every automatic value filled in
    reasons : why each automatic value was chosen, by parameter name
    scan_lines : what was touched, for pictures
    method : "patch" or "probe"
    """

    points: np.ndarray
    tangents: np.ndarray
    normals: np.ndarray
    angle: np.ndarray
    convex: bool | None
    covariance: np.ndarray
    fillet_radius: np.ndarray
    fillet_sigma: np.ndarray
    supported: np.ndarray
    compensation: np.ndarray
    closed: bool
    stops: tuple[Stop, Stop]
    message: str
    scan_lines: ScanLines | ProbedLines
    overhang: np.ndarray = field(default_factory=lambda: np.zeros(0))
    vertices: tuple[Vertex | None, Vertex | None] = (None, None)
    third_normals: tuple[np.ndarray | None, np.ndarray | None] = (None, None)
    single: tuple[np.ndarray, np.ndarray] | None = None
    reserve: float = 1.0
    parameters: ScanParameters = field(default_factory=ScanParameters)
    reasons: Mapping[str, str] = field(default_factory=dict)
    method: str = "patch"

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        ends = " to ".join(stop.name for stop in self.stops)
        return f"ScannedEdge({len(self)} points, {plain(self.length, 6)} mm, {ends})"

    @cached_property
    def sigma(self) -> np.ndarray:
        """Standard deviation across the edge in its worst direction, (m,) mm."""
        return largest_sigma(self.covariance)

    @cached_property
    def own_sigma(self) -> np.ndarray:
        """The same of each point alone, without what a short edge adds (`reserve`), (m,) mm."""
        return self.sigma / self.reserve

    @cached_property
    def length(self) -> float:
        """Length of the polyline of edge points, mm."""
        points = np.vstack([self.points, self.points[:1]]) if self.closed else self.points
        return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())

    @cached_property
    def covariance_3d(self) -> np.ndarray:
        """Covariance of the points in space, (m, 3, 3) mm²; nothing is known along the edge."""
        axes = across_axes(self.normals)
        return np.einsum("mai,mab,mbj->mij", axes, self.covariance, axes)

    @cached_property
    def unsmoothed(self) -> ScannedEdge:
        """The edge with the points of its sections by themselves.

        Their errors are nearly independent, so that curves are fitted to these; what is smoothed
        already looks better than it is when it is taken for independent.
        """
        if self.single is None:
            return self
        points, covariance = self.single
        return replace(self, points=points, covariance=covariance, single=None, reserve=1.0)

    @cached_property
    def sides(self) -> np.ndarray:
        """Unit vectors along the two surfaces at the edge, away from it, (m, 2, 3)."""
        sides = np.cross(self.normals, self.tangents[:, None])
        # A side lies behind the other one's surface, seen out of the smaller wedge.
        behind = np.einsum("mki,mki->mk", sides, self.normals[:, ::-1])
        wanted = 1.0 if self.convex is False else -1.0
        return np.where((behind * wanted < 0.0)[..., None], -sides, sides)

    def reversed(self) -> ScannedEdge:
        """The same edge, walked the other way."""
        backward = {
            name: getattr(self, name)[::-1]
            for name in (
                *("points", "normals", "angle", "covariance", "fillet_radius", "fillet_sigma"),
                *("supported", "compensation", "overhang"),
                *("stops", "vertices", "third_normals"),
            )
        }
        if self.single is not None:
            points, covariance = self.single
            backward["single"] = (points[::-1], covariance[::-1])
        return replace(
            self, tangents=-self.tangents[::-1], scan_lines=self.scan_lines.reversed(), **backward
        )

    def curve(self, tolerance: float | None = None) -> BSplineCurve:
        """Weighted cubic B-spline in as few poles as explain the points, from vertex to vertex.

        It lies in a plane when one explains the points as well: most edges bound a plane face, and
        what leaves the plane is noise, in which sweeps would turn.

        Parameters
        ----------
        tolerance : largest distance of an edge point, mm; None: poles are added until the rms of
            residual/sigma is at most 1
        """
        from ..geometry import common_plane, fit_curve

        edge = self.unsmoothed if tolerance is None else self
        points, covariance = edge._with_vertices()
        sigma = largest_sigma(covariance)
        curve = fit_curve(points, sigma, covariance, None, self.closed, tolerance)
        if tolerance is not None:
            return curve
        plane = common_plane(points, covariance, self.closed)
        return curve if plane is None else curve.flattened(plane)

    @property
    def vertex_to_vertex(self) -> np.ndarray:
        """The edge points, with the vertices before and behind them that are known, (k, 3) mm."""
        return self._with_vertices()[0]

    def _with_vertices(self) -> tuple[np.ndarray, np.ndarray]:
        """Points and their covariance in space, from vertex to vertex where these are known.

        A vertex that noise puts before the outermost edge point adds nothing.
        """
        first, last = (
            []
            if vertex is None or way * (vertex[0] - self.points[k]) @ self.tangents[k] <= 0.0
            else [vertex]
            for vertex, k, way in zip(self.vertices, (0, -1), (-1.0, 1.0), strict=True)
        )
        parts = [*first, (self.points, self.covariance_3d), *last]
        return (
            np.vstack([point for point, _ in parts]),
            np.concatenate([spread.reshape(-1, 3, 3) for _, spread in parts]),
        )

    @cached_property
    def primitive(self) -> Line | Circle | None:
        """The line or circle that explains the points as well as a spline would, or None."""
        from ..geometry import simplest_curve

        single = self.unsmoothed
        return simplest_curve(single.points, single.sigma, closed=self.closed)

    @property
    def line(self) -> Line | None:
        """The straight line that explains the points, or None."""
        from ..geometry import Line

        return self.primitive if isinstance(self.primitive, Line) else None

    @property
    def circle(self) -> Circle | None:
        """The circle that explains the points, or None."""
        from ..geometry import Circle

        return self.primitive if isinstance(self.primitive, Circle) else None

    def to_csv(self, path: str | Path) -> None:
        """Write one row for each edge point: position, sigma, tangent, angle, fillet radius."""
        with Path(path).open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(COLUMNS)
            writer.writerows(edge_point_rows(self))
