# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles: what a cloud looks like where it is cut across an edge.

The points of a thin slab round the plane are moved into the plane along the edge and followed from
the edge onwards, as far as they hang together.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import PointCloud
from ..geometry import BSplineCurve, Circle, Line, Plane
from ..geometry.frames import orthonormalise
from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from ..scanning import ScannedEdge
from .base_surface import curve_of
from .deviation import points_of
from .deviation_figures import DeviationFigures
from .point_chain import chain_order
from .section_profile import ProfileKind, section_profile

__all__ = ["CrossSection", "cross_section"]

Array = NDArray[np.float64]

_THICKNESS = 3.0  # pitches
_WIDER = 2.0
_THICKEST = 12.0  # pitches
_ENOUGH = 60  # points
_FEWEST = 8
_REACH = 40.0  # pitches
_SPACING = 0.7  # pitches
_GAP = 15.0  # pitches


@dataclass(frozen=True, eq=False)
class CrossSection(DeviationFigures):
    """A section of a cloud.

    Attributes
    ----------
    plane : the section's plane; its point is the place on the edge, its normal runs along the edge
    axes : (2, 3) unit vectors of the plane, the first one from the edge into the section
    points : (m, 3) mm, in the plane, in order along the profile
    rows : (m,) int, rows of these points in the cloud
    kind : line, arc or spline
    curve : BSplineCurve, the profile, from the edge onwards
    primitive : Line, Circle, or None for a spline
    deviation : (m,) mm, positive to the left of the profile seen against the plane's normal
    outside : (m,) bool, strays that the profile does not follow
    message : what a person should know
    """

    plane: Plane
    axes: Array
    points: Array
    rows: NDArray[np.intp] = field(repr=False)
    kind: ProfileKind
    curve: BSplineCurve
    primitive: Line | Circle | None
    deviation: Array
    outside: NDArray[np.bool_]
    message: str = ""

    @property
    def local(self) -> Array:
        """The points in the plane's own axes, (m, 2) mm, from the place on the edge."""
        return np.asarray((self.points - self.plane.point) @ self.axes.T)


def cross_section(
    cloud: PointCloud,
    edge: ScannedEdge | BSplineCurve,
    at: ArrayLike | float,
    towards: ScannedEdge | BSplineCurve | ArrayLike | None = None,
    reach: float | None = None,
    thickness: float | None = None,
    kind: ProfileKind | str | None = None,
) -> CrossSection:
    """The profile of a cloud across an edge or rail.

    Parameters
    ----------
    cloud : PointCloud
        Points of the surface; compensate a cloud of probe centres first.
    edge : ScannedEdge or BSplineCurve
    at : (3,) point in mm, or float
        The place: the edge's point nearest to this one, or a share of its length from 0 to 1.
    towards : ScannedEdge, BSplineCurve or (3,) point in mm, optional
        Another rail: the profile runs from the edge to the point of it that is nearest to the
        place, and the plane holds both. A point: only the side of the edge on which it lies.
        None: both sides.
    reach : float, optional
        How far from the edge the section goes, mm; by default 40 pitches, or the other rail.
    thickness : float, optional
        Of the slab whose points are taken, mm; by default 3 pitches, or more where that holds few
        points.
    kind : "line", "arc" or "spline", optional
        What is fitted; by default the simplest that explains the points.

    Returns
    -------
    CrossSection

    Raises
    ------
    ValueError: a place that is not on the edge, or no cloud there.
    """
    if kind is not None and kind not in list(ProfileKind):
        raise ValueError(f"There is no profile of the kind {kind!r}; choose line, arc or spline.")
    for name, value in (("reach", reach), ("thickness", thickness)):
        if value is not None and not 0.0 < value < np.inf:
            raise ValueError(f"The {name} is {value} mm; give a positive length.")
    points_of(cloud)  # refuses probe centres
    cut = _cut(curve_of(edge), at, edge, towards)
    pitch = cloud.pitch
    if not (len(cloud) >= _FEWEST and pitch > 0.0):  # nan is not
        raise ValueError(
            f"The {len(cloud)} points of the cloud are too few, or too much alike, for a profile; "
            f"give a cloud of {_FEWEST} or more points on a surface."
        )
    wanted = reach if reach is not None else (cut.span or _REACH * pitch)
    slab = thickness if thickness is not None else _THICKNESS * pitch
    while True:
        rows = _rows(cloud, cut, wanted, slab)
        if thickness is not None or len(rows) >= _ENOUGH or slab * _WIDER > _THICKEST * pitch:
            break
        slab *= _WIDER
    if len(rows) >= _FEWEST:
        flat = cloud.points[rows] - cut.plane.residuals(cloud.points[rows])
        gap = np.inf if cut.end is not None else max(_GAP * pitch, slab)
        order = chain_order(flat, cut.plane.point, _SPACING * pitch, gap, cut.end)
        rows, flat = rows[order], flat[order]
    if len(rows) < _FEWEST:
        where = place_text(cut.plane.point)
        raise ValueError(
            f"The section at ({where}) holds {len(rows)} points within {plain(wanted, 3)} mm in a "
            f"slab of {plain(slab, 3)} mm; a profile needs {_FEWEST}. Choose a place where the "
            "cloud is, or give a larger reach or thickness."
        )
    start = None if towards is None else cut.plane.point
    profile = section_profile(
        flat, cloud.noise, (start, cut.end), None if kind is None else ProfileKind(kind)
    )
    u, off = profile.curve.closest(flat)
    left = np.cross(cut.plane.normal, profile.curve.tangent(u))
    side = np.einsum("mi,mi->m", flat - profile.curve.evaluate(u), left)
    strays = int(np.count_nonzero(~profile.followed))
    return CrossSection(
        cut.plane,
        cut.axes,
        flat,
        rows,
        profile.kind,
        profile.curve,
        profile.primitive,
        np.where(side < 0.0, -off, off),
        ~profile.followed,
        f"{strays} of {len(rows)} points are off the profile and were left out." if strays else "",
    )


@dataclass(frozen=True, eq=False)
class _Cut:
    """The plane, its axes, where the profile ends (or None), and what belongs to the section."""

    plane: Plane
    axes: Array
    end: Array | None
    span: float | None
    away_from: Array | None  # direction (3,) of the edge's other side


def _cut(
    curve: BSplineCurve,
    at: ArrayLike | float,
    edge: ScannedEdge | BSplineCurve,
    towards: ScannedEdge | BSplineCurve | ArrayLike | None,
) -> _Cut:
    u = _parameter(curve, at)
    place, tangent = curve.evaluate(u), curve.tangent(u)
    if isinstance(towards, ScannedEdge | BSplineCurve):
        other = curve_of(towards)
        v, gap = other.closest(place[None])
        if gap[0] <= 1e-9 * curve.length():
            where = place_text(place)
            raise ValueError(
                f"The two rails meet at ({where}), which leaves no profile between them; choose "
                "another place."
            )
        end, beside = other.evaluate(v)[0], other.tangent(v)[0]
        first = (end - place) / gap[0]
        mean = tangent + (beside if beside @ tangent >= 0.0 else -beside)
        normal = orthonormalise(first, mean)
        return _Cut(
            Plane(place, normal), np.stack([first, np.cross(normal, first)]), end, gap[0], None
        )
    sides = _sides(edge, place)
    if towards is None:
        first = orthonormalise(tangent, np.zeros(3) if sides is None else sides[0])
        return _Cut(
            Plane(place, tangent), np.stack([first, np.cross(tangent, first)]), None, None, None
        )
    target = np.asarray(towards, dtype=float)
    if target.shape != (3,) or not np.isfinite(target).all():
        raise ValueError(
            f"The section leads towards {towards!r}; give a point of three numbers in mm, or "
            "another rail."
        )
    way = target - place
    across = way - (way @ tangent) * tangent
    if np.linalg.norm(across) <= 1e-6 * np.linalg.norm(way) or not np.any(way):
        raise ValueError(
            f"The point {target.tolist()} lies along the edge, not to a side of it; give one "
            "beside the edge."
        )
    first, behind = across / np.linalg.norm(across), -across
    if sides is not None:
        own = int(np.argmax(sides @ first))
        first, behind = orthonormalise(tangent, sides[own]), sides[1 - own]
    return _Cut(
        Plane(place, tangent), np.stack([first, np.cross(tangent, first)]), None, None, behind
    )


def _sides(edge: ScannedEdge | BSplineCurve, place: Array) -> Array | None:
    """Directions (2, 3) of the two surfaces at the edge."""
    if not isinstance(edge, ScannedEdge):
        return None
    return np.asarray(edge.sides[int(np.argmin(np.linalg.norm(edge.points - place, axis=1)))])


def _parameter(curve: BSplineCurve, at: ArrayLike | float) -> float:
    place = np.asarray(at, dtype=float)
    if place.shape == () and 0.0 <= place <= 1.0:
        return float(curve.parameters_at_length(np.array([float(place) * curve.length()]))[0])
    if place.shape == (3,) and np.isfinite(place).all():
        return float(curve.closest(place[None])[0][0])
    raise ValueError(
        f"The place of a section is {at!r}; give a point of three numbers in mm, or a share of the "
        "edge's length from 0 to 1."
    )


def _rows(cloud: PointCloud, cut: _Cut, reach: float, thickness: float) -> NDArray[np.intp]:
    """Rows of the points of the slab that belong to the section."""
    middle = cut.plane.point
    if cut.end is not None:
        middle = (middle + cut.end) / 2
    rows = np.array(cloud.tree.query_ball_point(middle, np.hypot(reach, thickness)), dtype=np.intp)
    away = cloud.points[rows] - cut.plane.point
    inside = np.abs(away @ cut.plane.normal) <= thickness / 2
    along = away @ cut.axes[0]
    if cut.end is not None and cut.span is not None:
        inside &= (along >= 0.0) & (along <= cut.span)
    elif cut.away_from is not None:
        other = cut.away_from / np.linalg.norm(cut.away_from)
        inside &= along > away @ other
    return np.sort(rows[inside])
