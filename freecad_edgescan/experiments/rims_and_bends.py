# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges that exact objects have and blocks have not: rims of a core box, and tight bends.

The core box is that of the published case study: touched line by line by a ball, with gaps of 4 mm
in its steep walls and a land of 3 mm between two rims. The bends are those of torus objects, round
which an edge turns on a radius of three amplitudes, between sides of which one is nearly flat or
both are bent so strongly that they turn by 0.7 rad within half an amplitude.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..cloud import CoreBox, SimulatedCloud, TorusObject, TrueEdge
from ..scanning import Progress, ScanError, ScannedEdge, ScanParameters, scan_edge
from .edge_report import middle_of

__all__ = ["BEND", "BOX", "ROUNDED_BOX", "ExactEdge", "exact_edge_table", "measure_exact_edges"]

Array = NDArray[np.float64]

BOX, ROUNDED_BOX, BEND = "core box", "core box rounded", "bend"
RIM_RADIUS = 0.8  # mm, of the rounded rims
AMPLITUDE = 10.0  # mm, of the bends' scans
EDGE_RADIUS = 3.0 * AMPLITUDE
BEND_PITCH, BEND_NOISE = 0.5, 0.02  # mm, of the bends' clouds
ANGLES = (60.0, 110.0, 150.0)  # degrees
SECTION_RADII = (0.5 * AMPLITUDE / 0.7, 100.0)  # mm, of the bends' sides
BEND_CLOUDS = 3


@dataclass(frozen=True)
class ExactEdge:
    """One edge, over all clouds of its object; lengths mm.

    Attributes
    ----------
    kind : which of the objects it is of
    name : of the edge
    errors : (m,) distances of the edge points from the true edge; none where a scan found nothing
    sigmas : (m,) what the scan states for them
    bias : length of the mean of the errors as vectors across the edge; nan where the edge is not
        the same everywhere
    radius : median radius of the rounding that the scan states; nan where it states none
    """

    kind: str
    name: str
    errors: Array
    sigmas: Array
    bias: float
    radius: float

    @property
    def average(self) -> float:
        """Mean error, mm; nan where nothing was found."""
        return float(self.errors.mean()) if len(self.errors) else float("nan")

    @property
    def maximum(self) -> float:
        """Largest error, mm; nan where nothing was found."""
        return float(self.errors.max()) if len(self.errors) else float("nan")

    @property
    def sigma(self) -> float:
        """Mean of the stated standard deviations, mm; nan where nothing was found."""
        return float(self.sigmas.mean()) if len(self.sigmas) else float("nan")


def measure_exact_edges(
    kinds: Collection[str] = (BOX, ROUNDED_BOX, BEND), progress: Progress | None = None
) -> list[ExactEdge]:
    """Scan each rim and each bend from one click at its middle; those done so far when cancelled.

    Parameters
    ----------
    kinds : of which objects
    progress : told the share of the edges done
    """
    count = {BOX: 4, ROUNDED_BOX: 4, BEND: len(ANGLES) * len(SECTION_RADII)}
    whole = sum(count[kind] for kind in kinds)
    measured: list[ExactEdge] = []
    for each in _each_edge(kinds):
        measured.append(each)
        if progress is not None and not progress.update(len(measured) / whole, each.name):
            break
    return measured


def _each_edge(kinds: Collection[str]) -> Iterator[ExactEdge]:
    for kind, radius in ((BOX, 0.0), (ROUNDED_BOX, RIM_RADIUS)):
        if kind in kinds:
            box = CoreBox(rim_radius=radius)
            cloud = box.cloud(seed=1)
            for truth in box.edges:
                yield _rim(kind, cloud, truth)
    if BEND in kinds:
        for angle in ANGLES:
            for radius in SECTION_RADII:
                yield _bend(TorusObject(radius, EDGE_RADIUS, float(np.radians(angle))))


def _rim(kind: str, cloud: SimulatedCloud, truth: TrueEdge) -> ExactEdge:
    edge = _scanned(cloud, truth)
    if edge is None:
        return _not_found(kind, truth.name)
    errors = truth.distance(edge.points)
    return ExactEdge(kind, truth.name, errors, edge.sigma, np.nan, _radius(edge))


def _bend(bent: TorusObject) -> ExactEdge:
    name = f"{np.degrees(bent.angle):.0f}°, sides of R {bent.section_radius:.3g}"
    (truth,) = bent.edges
    edges = []
    for seed in range(BEND_CLOUDS):
        cloud = bent.cloud(BEND_PITCH, AMPLITUDE, BEND_NOISE, seed)
        edge = _scanned(cloud, truth, ScanParameters(amplitude=AMPLITUDE))
        if edge is None:
            return _not_found(BEND, name)
        edges.append(edge)
    x, y, z = np.vstack([edge.points for edge in edges]).T
    off = np.column_stack([np.hypot(x, y) - bent.edge_radius, z + bent.section_radius])
    errors, sigmas = np.linalg.norm(off, axis=1), np.concatenate([edge.sigma for edge in edges])
    return ExactEdge(BEND, name, errors, sigmas, float(np.hypot(*off.mean(axis=0))), np.nan)


def _scanned(
    cloud: SimulatedCloud, truth: TrueEdge, parameters: ScanParameters | None = None
) -> ScannedEdge | None:
    """The edge from one click at its middle; None where nothing is found."""
    try:
        return scan_edge(cloud, at=truth.points[middle_of(truth)], parameters=parameters)
    except ScanError:
        return None


def _not_found(kind: str, name: str) -> ExactEdge:
    return ExactEdge(kind, name, np.zeros(0), np.zeros(0), np.nan, np.nan)


def _radius(edge: ScannedEdge) -> float:
    known = edge.fillet_radius[np.isfinite(edge.fillet_radius)]
    return float(np.median(known)) if len(known) else float("nan")


def exact_edge_table(edges: Sequence[ExactEdge]) -> str:
    """Errors, what the scan states for them, and radii of roundings; lengths mm."""
    lines = ["edge".ljust(39) + "  points  average  maximum    sigma     bias  radius"]
    titles = {
        BOX: "core box, ",
        ROUNDED_BOX: f"core box rounded by {RIM_RADIUS:g}, ",
        BEND: f"bend of R {EDGE_RADIUS:g}, ",
    }
    for each in edges:
        lines.append(
            f"{titles[each.kind] + each.name:<39} {len(each.errors):7d}   {each.average:.4f}"
            f"   {each.maximum:.4f}   {each.sigma:.4f}"
            f"{_known(each.bias, 4):>9}{_known(each.radius, 2):>8}"
        )
    return "\n".join(line.rstrip() for line in lines)


def _known(value: float, digits: int) -> str:
    return f"{value:.{digits}f}" if np.isfinite(value) else ""
