# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well one known edge of a simulated cloud is found from one click at its middle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud, TrueEdge
from ..scanning import ScanError, ScannedEdge, ScanParameters, scan_edge
from .honesty import mahalanobis

__all__ = ["WANDERING", "EdgeReport", "middle_of", "report_edge", "root_mean_square"]

Array = NDArray[np.float64]

WANDERING = 3.0  # pitches from every true edge


@dataclass(frozen=True)
class EdgeReport:
    """What a scan made of one known edge; lengths mm.

    Attributes
    ----------
    truth : the true edge that was clicked
    edge : what the scan found, or None
    refusal : why it found nothing, else empty
    traced : share of the true edge within one pitch of the edge found
    errors : (k,) distances from the true edge, of the edge points that belong to it
    in_sigmas : (k,) their Mahalanobis distances
    unsmoothed, unsmoothed_in_sigmas : (j,) the same of the sections by themselves, before they were
        smoothed along the edge
    wandering : number of edge points farther than three pitches from every true edge
    """

    truth: TrueEdge
    edge: ScannedEdge | None
    refusal: str
    traced: float
    errors: Array
    in_sigmas: Array
    unsmoothed: Array
    unsmoothed_in_sigmas: Array
    wandering: int

    @property
    def rms(self) -> float:
        """Root mean square of the errors, nan without any."""
        return root_mean_square(self.errors)


def report_edge(
    cloud: PointCloud,
    truth: TrueEdge,
    pitch: float,
    others: Sequence[TrueEdge] = (),
    edge_pitch: float | None = None,
) -> EdgeReport:
    """Click at the middle of an edge, and compare what is found with the truth.

    Parameters
    ----------
    cloud : PointCloud
    truth : the edge that is clicked
    pitch : of the cloud, mm
    others : all true edges of the part; an edge point is judged by the nearest one
    edge_pitch : of the scan, mm; None: automatic
    """
    chosen = None if edge_pitch is None else ScanParameters(edge_pitch=edge_pitch)
    try:
        edge = scan_edge(cloud, at=truth.points[middle_of(truth)], parameters=chosen)
    except ScanError as error:
        none = np.zeros(0)
        return EdgeReport(truth, None, str(error), 0.0, none, none, none, none, 0)
    errors, in_sigmas, nearest = _judged(edge, truth, others)
    unsmoothed, unsmoothed_in_sigmas, _ = _judged(edge.unsmoothed, truth, others)
    return EdgeReport(
        truth,
        edge,
        "",
        truth.traced_share(edge.points, pitch, edge.closed),
        errors,
        in_sigmas,
        unsmoothed,
        unsmoothed_in_sigmas,
        int(np.sum(nearest > WANDERING * pitch)),
    )


def _judged(
    edge: ScannedEdge, truth: TrueEdge, others: Sequence[TrueEdge]
) -> tuple[Array, Array, Array]:
    """Errors of the points that belong to the edge, and in sigmas; distances of all from any."""
    own = truth.distance(edge.points)
    nearest = np.min([own, *(other.distance(edge.points) for other in others)], axis=0)
    # Smooth chains of edges are followed as one; what lies on a neighbour is judged there.
    mine = own <= nearest + 1e-9
    return own[mine], mahalanobis(edge, truth.residuals)[mine], nearest


def middle_of(truth: TrueEdge) -> int:
    """Number of the sample at half the edge's length."""
    length = np.cumsum(np.linalg.norm(np.diff(truth.points, axis=0), axis=1))
    return int(np.searchsorted(length, 0.5 * length[-1]))


def root_mean_square(values: Array) -> float:
    """Root mean square, nan of nothing."""
    return float(np.sqrt(np.mean(values**2))) if len(values) else float("nan")
