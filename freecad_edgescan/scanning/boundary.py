# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges round one face: from corner to corner until the boundary closes.

At a vertex the third surface is known, and with the face's own normal there the direction in which
the next edge leaves. It is scanned like any other edge, from a click beside the vertex, and taken
when it begins there and has the face on the same hand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..cloud.point_cloud import PointCloud, require_surface
from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from .automatic import MIN_ANGLE
from .errors import ScanError
from .face_beside import side_of
from .parameters import ScanParameters
from .progress import Progress
from .scan import scan_edge
from .scanned_edge import ScannedEdge, Vertex
from .start import numbers

__all__ = ["scan_boundary"]

Point = Sequence[float] | np.ndarray
_Scan = Callable[[Point], ScannedEdge | None]
_MOST_EDGES = 200
_FARTHEST = 10.0  # pitches from the cloud, of the place that tells the face
_CLICKS = (10.0, 6.0, 3.5)  # pitches from the vertex, besides a rounding
_AT_THE_VERTEX = 3.0  # pitches, besides a rounding, that an edge may begin off its vertex
_SAME_EDGE = 2.0  # pitches, of the middle of an edge from one that was found before
_SAME_WAY = np.cos(np.radians(30.0))
_SAME_FACE = np.cos(np.radians(25.0))


def scan_boundary(
    cloud: PointCloud,
    at: Point,
    inside: Point,
    parameters: ScanParameters | None = None,
    min_angle: float = MIN_ANGLE,
    progress: Progress | None = None,
) -> list[ScannedEdge]:
    """Scan all edges round one face.

    Parameters
    ----------
    cloud : the scanned points
    at : a point near one of the edges, mm
    inside : a point on the face, mm; of the two sides of that edge it tells the face
    parameters, min_angle : of each scan; see `scan_edge`
    progress : told about the edges as they are found; may cancel, and keeps those found so far

    Returns
    -------
    The edges in order, each beginning in the vertex in which the one before ends. Where the
    boundary could not be followed the list begins and ends; `stops` and `message` of the first and
    the last edge say why.

    Raises
    ------
    ScanError: there is no edge near `at`, or `inside` is no place on the cloud or on a face beside
        that edge.
    ValueError: a cloud without a surface.
    """
    require_surface(cloud)
    place = _on_the_cloud(cloud, inside)
    told = _Told(progress)

    def scan(click: Point) -> ScannedEdge | None:
        """The edge there; None where there is none, and nothing new once it is cancelled."""
        if told.cancelled:
            return None
        try:
            return scan_edge(cloud, click, None, parameters, None, min_angle, told)
        except ScanError:
            return None

    first = scan_edge(cloud, at, None, parameters, None, min_angle, told)
    side = side_of(cloud, first, place)
    if side is None:
        raise ScanError(
            f"The place inside, ({place_text(place)}), is on a face that the edge near the click "
            "does not bound; give a place on one of the two faces beside that edge, or click on an "
            "edge of the face that the place is on."
        )
    onward = _round_the_face(cloud, [_Bound.of(first, place, side)], scan)
    if not _closes(onward, cloud.pitch):
        # From the other end, walked backwards, the face lies on the other hand.
        backward = _round_the_face(cloud, [bound.reversed() for bound in onward[::-1]], scan)
        onward = [bound.reversed() for bound in backward[::-1]]
    edges = [bound.edge for bound in onward]
    return _sharing_vertices(edges, _closes(onward, cloud.pitch))


def _on_the_cloud(cloud: PointCloud, inside: Point) -> np.ndarray:
    """The place that tells the face, (3,) mm.

    Raises
    ------
    ScanError: it is none, or far from the cloud.
    """
    place = numbers(inside)
    if place is None:
        raise ScanError(f"The place inside is {inside!r}; give three finite coordinates in mm.")
    distance = float(cloud.tree.query(place)[0])
    if distance > _FARTHEST * cloud.pitch:
        raise ScanError(
            f"The place inside, ({place_text(place)}), is {plain(distance, 3)} mm away from the "
            "nearest point of the cloud; choose one on the face."
        )
    return place


class _Told:
    """Passes on how far a scan is, and remembers that it was cancelled."""

    def __init__(self, progress: Progress | None) -> None:
        self.progress, self.cancelled = progress, False

    def update(self, fraction: float, so_far: object) -> bool:
        if self.progress is not None and not self.progress.update(fraction, so_far):
            self.cancelled = True
        return not self.cancelled


@dataclass(frozen=True)
class _Bound:
    """One edge of a face.

    Attributes
    ----------
    edge : in the order of the walk
    side : which of its two surfaces is the face
    sign : 1, or -1 where its normals are those of the first edge turned round
    hand : 1 when the face lies to the left of the walk, seen along its normal, else -1
    """

    edge: ScannedEdge
    side: int
    sign: float
    hand: float

    @classmethod
    def of(cls, edge: ScannedEdge, inside: np.ndarray, side: int) -> _Bound:
        j = int(np.linalg.norm(edge.points - inside, axis=1).argmin())
        return cls(edge, side, 1.0, _hand(edge, side, 1.0, j))

    def reversed(self) -> _Bound:
        return replace(self, edge=self.edge.reversed(), hand=-self.hand)

    @property
    def end_normal(self) -> np.ndarray:
        """Of the face at the edge's end."""
        return self.sign * self.edge.normals[-1, self.side]

    def next_to(self, edge: ScannedEdge) -> _Bound | None:
        """An edge that begins in this one's end, as the next one round the face, if it is that."""
        alike = edge.normals[0] @ self.end_normal
        side = int(np.abs(alike).argmax())
        if abs(alike[side]) < _SAME_FACE:
            return None
        sign = float(np.sign(alike[side]))
        hand = _hand(edge, side, sign, 0)
        return _Bound(edge, side, sign, hand) if hand == self.hand else None


def _hand(edge: ScannedEdge, side: int, sign: float, j: int) -> float:
    left = np.cross(sign * edge.normals[j, side], edge.tangents[j])
    return 1.0 if left @ edge.sides[j, side] > 0.0 else -1.0


def _round_the_face(cloud: PointCloud, bounds: list[_Bound], scan: _Scan) -> list[_Bound]:
    """Go on from the last edge until the boundary closes or cannot be followed."""
    while len(bounds) < _MOST_EDGES and not _closes(bounds, cloud.pitch):
        following = _following(cloud, bounds[-1], scan)
        if following is None or _known(following.edge, bounds, cloud.pitch):
            break
        bounds = [*bounds, following]
    return bounds


def _following(cloud: PointCloud, bound: _Bound, scan: _Scan) -> _Bound | None:
    """The edge that goes on round the face from the end of another one."""
    vertex, third = bound.edge.vertices[1], bound.edge.third_normals[1]
    if vertex is None or third is None:
        return None
    rounded = _rounding(bound.edge)
    tolerance = _AT_THE_VERTEX * cloud.pitch + 2.0 * rounded
    for way in _ways(bound, third):
        for pitches in _CLICKS:
            click = vertex[0] + (pitches * cloud.pitch + 2.0 * rounded) * way
            found = scan(click)
            for edge in () if found is None else (found, found.reversed()):
                off = min(np.linalg.norm(place - vertex[0]) for place in _starts(edge))
                if off < tolerance and edge.tangents[0] @ way > _SAME_WAY:
                    following = bound.next_to(edge)
                    if following is not None:
                        return following
    return None


def _ways(bound: _Bound, third: np.ndarray) -> Iterator[np.ndarray]:
    """Along the cut of the face with the third surface, towards the face's inside first."""
    way = np.cross(bound.end_normal, third)
    size = float(np.linalg.norm(way))
    if size < 1e-3:
        return
    way = way / size
    inwards = 1.0 if way @ bound.edge.sides[-1, bound.side] > 0.0 else -1.0
    yield inwards * way
    yield -inwards * way


def _starts(edge: ScannedEdge) -> list[np.ndarray]:
    vertex = edge.vertices[0]
    return [edge.points[0]] if vertex is None else [edge.points[0], vertex[0]]


def _rounding(edge: ScannedEdge) -> float:
    known = edge.fillet_radius[np.isfinite(edge.fillet_radius)]
    return float(np.median(known)) if len(known) else 0.0


def _closes(bounds: list[_Bound], pitch: float) -> bool:
    """Whether the last edge ends where the first one begins."""
    first, last = bounds[0].edge, bounds[-1].edge
    if first.closed:
        return True
    if len(bounds) < 2 or last.vertices[1] is None:
        return False
    off = min(np.linalg.norm(place - last.vertices[1][0]) for place in _starts(first))
    return bool(off < _AT_THE_VERTEX * pitch + 2.0 * _rounding(first))


def _known(edge: ScannedEdge, bounds: list[_Bound], pitch: float) -> bool:
    """Whether an edge is one of those found before."""
    middle = edge.points[len(edge) // 2]
    return any(
        np.linalg.norm(bound.edge.points - middle, axis=1).min() < _SAME_EDGE * pitch
        for bound in bounds
    )


def _sharing_vertices(edges: list[ScannedEdge], closed: bool) -> list[ScannedEdge]:
    """Each vertex as both of its edges know it together."""
    shared = list(edges)
    for j, edge in enumerate(edges):
        k = (j + 1) % len(edges)
        end, begin = edge.vertices[1], edges[k].vertices[0]
        if end is None or (k == 0 and not closed) or len(edges) < 2:
            continue
        vertex = end if begin is None else _together(end, begin)
        shared[j] = replace(shared[j], vertices=(shared[j].vertices[0], vertex))
        shared[k] = replace(shared[k], vertices=(vertex, shared[k].vertices[1]))
    return shared


def _together(one: Vertex, other: Vertex) -> Vertex:
    """The weighted mean of two estimates from the same three surfaces.

    They share the surfaces' points. How much they depend on each other is not known; twice the
    covariance of independent ones holds however much that is.
    """
    (a, covariance_a), (b, covariance_b) = one, other
    share = covariance_b @ np.linalg.pinv(covariance_a + covariance_b)
    rest = np.eye(3) - share
    mean = share @ a + rest @ b
    covariance = share @ covariance_a @ share.T + rest @ covariance_b @ rest.T
    return mean, 2.0 * covariance
