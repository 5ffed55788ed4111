# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well the edges of a CAD part are found in a simulated scan of it: one click on each.

The part's own sharp edges are the truth. Every edge is clicked at the middle of its length, and
what the scan finds is compared with all of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import FreeCAD  # before Part, which ends the process otherwise
import numpy as np
import Part
from numpy.typing import NDArray

from ..cloud import TrueEdge
from ..cloud.simulated_cloud import SimulatedCloud
from ..scanning import Progress, ScannedEdge, scan_edge
from .simulated_shape import simulate_cloud

__all__ = ["EdgeReport", "PartReport", "block_with_bore", "read_part", "report_part"]

Array = NDArray[np.float64]

TRACED = 0.9  # share of a true edge from which on it counts as found
_WANDERING = 3.0  # pitches from every true edge


@dataclass(frozen=True)
class EdgeReport:
    """One row of a report; lengths mm.

    Attributes
    ----------
    truth : the true edge that was clicked
    edge : what the scan found, or None
    refusal : why it found nothing, else empty
    traced : share of the true edge within one pitch of the edge found
    errors : (k,) distances from the true edge, of the edge points that belong to it
    wandering : number of edge points farther than three pitches from every true edge
    """

    truth: TrueEdge
    edge: ScannedEdge | None
    refusal: str
    traced: float
    errors: Array
    wandering: int

    @property
    def rms(self) -> float:
        """Root mean square of the errors, nan without any."""
        return float(np.sqrt(np.mean(self.errors**2))) if len(self.errors) else float("nan")


@dataclass(frozen=True)
class PartReport:
    """All edges of one part.

    Attributes
    ----------
    name : of the part
    cloud : the simulated scan
    rows : one for each sharp edge
    """

    name: str
    cloud: SimulatedCloud
    rows: tuple[EdgeReport, ...]

    @property
    def traced(self) -> tuple[EdgeReport, ...]:
        """The edges that were found along at least 90 % of their length."""
        return tuple(row for row in self.rows if row.traced >= TRACED)

    def text(self) -> str:
        """The table and its summary."""
        lines = [
            "edge      length    room  traced      rms      max    sigma  wandering  stops",
            "              mm      mm       %       mm       mm       mm     points",
        ]
        lines += [_line(row) for row in self.rows]
        return "\n".join([*lines, *self._summary()])

    def _summary(self) -> list[str]:
        found = [row.errors for row in self.traced]
        errors = np.concatenate(found) if found else np.zeros(0)
        wandering = sum(row.wandering for row in self.rows)
        lines = [
            f"{self.name}: {len(self.cloud)} points, {len(self.rows)} sharp edges; "
            f"{len(self.traced)} of them traced along at least {TRACED:.0%} of their length."
        ]
        if len(errors):
            lines.append(
                f"Edge points on these: rms {np.sqrt(np.mean(errors**2)):.4f} mm, largest rms of "
                f"one edge {max(row.rms for row in self.traced):.4f} mm, largest error "
                f"{errors.max():.4f} mm."
            )
        lines.append(
            f"Edge points farther than {_WANDERING:g} pitches from every true edge: {wandering}."
        )
        return lines


def read_part(path: str | Path) -> Any:
    """Shape in a STEP, IGES or BREP file.

    Raises
    ------
    ValueError: a file that is missing, of another kind, unreadable, or without faces.
    """
    file = Path(path)
    if file.suffix.lower() not in (".step", ".stp", ".iges", ".igs", ".brep", ".brp"):
        raise ValueError(f"{file} has an unknown ending; give a .step, .iges or .brep file.")
    if not file.is_file():
        raise ValueError(f"There is no file {file}; check the name.")
    try:
        shape = Part.Shape()
        shape.read(str(file))
    except Exception as error:  # Part raises its own kinds, some of them not documented
        raise ValueError(f"{file} cannot be read as CAD: {error}.") from error
    if shape.isNull() or not shape.Faces:
        raise ValueError(f"{file} holds no faces; give a part made of solids or surfaces.")
    return shape


def block_with_bore() -> Any:
    """A block of 100 × 100 × 50 mm with a blind bore of 25 mm radius, 40 mm deep."""
    block = Part.makeBox(100.0, 100.0, 50.0)
    bore = Part.makeCylinder(25.0, 40.0, FreeCAD.Vector(50.0, 50.0, 10.0))
    return block.cut(bore)


def report_part(
    shape: Any,
    name: str,
    pitch: float,
    noise: float,
    probe_radius: float = 0.0,
    seed: int = 0,
    progress: Progress | None = None,
) -> PartReport:
    """Scan every sharp edge of a part in a simulated cloud, each from one click at its middle.

    Parameters
    ----------
    shape : Part.Shape
    name : of the part, for the text
    pitch, noise, probe_radius, seed : of the cloud, see `simulate_cloud`
    progress : told the share of the edges that is done; where it answers False, these are kept

    Raises
    ------
    ValueError: see `simulate_cloud`.
    """
    cloud = simulate_cloud(shape, pitch, noise, probe_radius, seed)
    rows: list[EdgeReport] = []
    for number, truth in enumerate(cloud.edges):
        if progress is not None and not progress.update(number / len(cloud.edges), truth.name):
            break
        rows.append(_report_edge(cloud, truth, pitch))
    return PartReport(name, cloud, tuple(rows))


def _report_edge(cloud: SimulatedCloud, truth: TrueEdge, pitch: float) -> EdgeReport:
    try:
        edge = scan_edge(cloud, at=truth.points[_middle(truth)])
    except ValueError as error:
        return EdgeReport(truth, None, str(error), 0.0, np.zeros(0), 0)
    nearest = np.min([other.distance(edge.points) for other in cloud.edges], axis=0)
    own = truth.distance(edge.points)
    # Smooth chains of edges are followed as one; what lies on a neighbour is judged there.
    mine = own <= nearest + 1e-9
    share = truth.traced_share(edge.points, pitch, edge.closed)
    wandering = int(np.sum(nearest > _WANDERING * pitch))
    return EdgeReport(truth, edge, "", share, own[mine], wandering)


def _middle(truth: TrueEdge) -> int:
    """Number of the sample at half the edge's length."""
    length = np.cumsum(np.linalg.norm(np.diff(truth.points, axis=0), axis=1))
    return int(np.searchsorted(length, 0.5 * length[-1]))


def _line(row: EdgeReport) -> str:
    room = float(np.min(row.truth.room))
    start = f"{row.truth.name:<8} {row.truth.length:7.2f}  {_length(room)}"
    if row.edge is None:
        return f"{start}       0  {row.refusal}"
    stops = " / ".join(stop.name for stop in row.edge.stops)
    largest = row.errors.max() if len(row.errors) else np.nan
    return (
        f"{start}  {100 * row.traced:6.1f}  {row.rms:7.4f}  {largest:7.4f}  "
        f"{row.edge.sigma.mean():7.4f}  {row.wandering:9d}  {stops}"
    )


def _length(value: float) -> str:
    return f"{value:6.2f}" if np.isfinite(value) else "     -"
