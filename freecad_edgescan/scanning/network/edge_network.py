# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of looking for all edges: a network of edges, corners, and the faces between them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ...cloud.point_cloud import PointCloud
from ...geometry.plain_number import plain
from ..report import describe
from ..scanned_edge import ScannedEdge, Vertex
from ..stop import Stop
from .corners import Corners, joined_corners
from .regions import Region, regions_between

__all__ = ["EdgeNetwork", "network_of"]


@dataclass(frozen=True, repr=False, eq=False)
class EdgeNetwork:
    """All edges of a cloud, and how they are connected.

    Attributes
    ----------
    cloud : the cloud they were found in
    edges : ScannedEdges; where they end in a corner their vertex is that corner
    corners : (k, 3) mm
    corner_covariance : (k, 3, 3) mm²
    corner_misclosure : (k,) mm, how far the vertices that the edges found by themselves are from
        their corner, at most
    ends : of each edge, at its start and end: the number of the corner it ends in, or the Stop
        that says why it ends elsewhere
    passing : (k,) number of an edge that goes on past a corner in which others end (a
        T-junction), −1 where there is none
    message : what happened, for a person
    cancelled : whether the search was ended before its time
    """

    cloud: PointCloud
    edges: tuple[ScannedEdge, ...]
    corners: np.ndarray
    corner_covariance: np.ndarray
    corner_misclosure: np.ndarray
    ends: tuple[tuple[int | Stop, int | Stop], ...]
    passing: np.ndarray
    message: str = ""
    cancelled: bool = False

    def __len__(self) -> int:
        return len(self.edges)

    def __repr__(self) -> str:
        return (
            f"EdgeNetwork({len(self.edges)} edges, {plain(self.length, 6)} mm, "
            f"{len(self.corners)} corners)"
        )

    @property
    def length(self) -> float:
        """Length of all edges, mm."""
        return float(sum(edge.length for edge in self.edges))

    @cached_property
    def regions(self) -> tuple[Region, ...]:
        """The faces between the edges as parts of the cloud, the largest first."""
        return regions_between(self.cloud, self.edges)

    def edges_at(self, corner: int) -> tuple[int, ...]:
        """Numbers of the edges that end in a corner, or pass it."""
        ending = [number for number, ends in enumerate(self.ends) if corner in _numbers(ends)]
        passing = [int(self.passing[corner])] if self.passing[corner] >= 0 else []
        return tuple(dict.fromkeys([*ending, *passing]))

    def chains(self) -> tuple[tuple[int, ...], ...]:
        """Edges that follow each other through corners where just two of them meet.

        Returns
        -------
        Numbers of edges in order, each chain as long as it goes; every edge is in one chain.
        """
        meeting: dict[int, list[int]] = {}
        for number, ends in enumerate(self.ends):
            for met in _numbers(ends):
                meeting.setdefault(met, []).append(number)
        chains, seen = [], set()
        for number in range(len(self.edges)):
            if number in seen:
                continue
            seen.add(number)
            chain = [number]
            for k in (1, 0):
                corner: int | Stop = self.ends[number][k]
                while not isinstance(corner, Stop) and len(meeting[corner]) == 2:
                    here = chain[-1] if k else chain[0]
                    others = [other for other in meeting[corner] if other != here]
                    if not others or others[0] in seen:
                        break
                    other = others[0]
                    seen.add(other)
                    chain = [*chain, other] if k else [other, *chain]
                    ends = self.ends[other]
                    corner = ends[1] if ends[0] == corner else ends[0]
            chains.append(tuple(chain))
        return tuple(chains)

    def filtered(
        self,
        min_length: float = 0.0,
        min_angle: float = 0.0,
        max_sigma: float = np.inf,
        keep: Callable[[ScannedEdge], bool] | None = None,
    ) -> EdgeNetwork:
        """The part of the network whose edges are long, sharp and well known, as it is.

        Parameters
        ----------
        min_length : mm
        min_angle : rad, of the turn between the two sides, the median along an edge
        max_sigma : mm, the median along an edge
        keep : answers for an edge whether it is kept
        """
        return self.part(
            [
                edge.length >= min_length
                and np.pi - float(np.median(edge.angle)) >= min_angle
                and float(np.median(edge.sigma)) <= max_sigma
                and (keep is None or keep(edge))
                for edge in self.edges
            ]
        )

    def part(self, mask: ArrayLike) -> EdgeNetwork:
        """Some of the edges, as they are: they end in the corners that all edges told.

        Parameters
        ----------
        mask : (m,) bool, for each edge whether it is kept
        """
        wanted = np.asarray(mask, dtype=bool)
        if wanted.all():
            return self
        rows = np.flatnonzero(wanted).tolist()
        ends = [self.ends[row] for row in rows]
        corners = sorted({end for pair in ends for end in _numbers(pair)})
        corner_of = {old: new for new, old in enumerate(corners)}
        edge_of = {old: new for new, old in enumerate(rows)}
        return replace(
            self,
            edges=tuple(self.edges[row] for row in rows),
            corners=self.corners[corners],
            corner_covariance=self.corner_covariance[corners],
            corner_misclosure=self.corner_misclosure[corners],
            ends=tuple(
                (_renumbered(start, corner_of), _renumbered(end, corner_of)) for start, end in ends
            ),
            passing=np.array(
                [edge_of.get(int(self.passing[corner]), -1) for corner in corners], dtype=np.int64
            ),
            message=f"{len(rows)} of {len(self)} edges are kept. {self.message}",
        )


def network_of(
    cloud: PointCloud, edges: list[ScannedEdge], message: str = "", cancelled: bool = False
) -> EdgeNetwork:
    """The network of finished edges."""
    corners = joined_corners(edges, cloud)
    joined = tuple(_ending_in(edge, corners, number) for number, edge in enumerate(edges))
    ends = tuple(
        (_end(corners, edge, number, 0), _end(corners, edge, number, 1))
        for number, edge in enumerate(edges)
    )
    return EdgeNetwork(
        cloud,
        joined,
        corners.points,
        corners.covariance,
        corners.misclosure,
        ends,
        corners.passing,
        message,
        cancelled,
    )


def _numbers(ends: tuple[int | Stop, int | Stop]) -> list[int]:
    return [end for end in ends if not isinstance(end, Stop)]


def _renumbered(end: int | Stop, corner_of: dict[int, int]) -> int | Stop:
    return end if isinstance(end, Stop) else corner_of[end]


def _end(corners: Corners, edge: ScannedEdge, number: int, k: int) -> int | Stop:
    corner = int(corners.of_ends[number, k])
    return _stop(corners, edge, number, k) if corner < 0 else corner


def _stop(corners: Corners, edge: ScannedEdge, number: int, k: int) -> Stop:
    """Why an edge ends: where it bends with its wall, and has no corner, it was lost."""
    return Stop.LOST if corners.bending[number, k] else edge.stops[k]


def _ending_in(edge: ScannedEdge, corners: Corners, number: int) -> ScannedEdge:
    """The edge with its corners for vertices; a vertex that is no corner is none."""
    start, end = corners.of_ends[number].tolist()
    edge = replace(
        edge,
        vertices=(_vertex(corners, start), _vertex(corners, end)),
        stops=(
            _stop(corners, edge, number, 0) if start < 0 else Stop.CORNER,
            _stop(corners, edge, number, 1) if end < 0 else Stop.CORNER,
        ),
    )
    return replace(edge, message=describe(edge, None))


def _vertex(corners: Corners, number: int) -> Vertex | None:
    return None if number < 0 else (corners.points[number], corners.covariance[number])
