# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well the edges of a CAD part are found in a simulated scan of it: one click on each.

The part's own sharp edges are the truth. Every edge is clicked at the middle of its length, and
what the scan finds is compared with all of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import FreeCAD  # noqa: F401 (before Part, which ends the process otherwise)
import numpy as np
import Part
from numpy.typing import NDArray

from ..cloud.simulated_cloud import SimulatedCloud
from ..experiments.edge_report import WANDERING, EdgeReport, report_edge
from ..experiments.honesty import TRUE_95, TRUE_MEDIAN, median_and_95
from ..scanning import Progress
from .known_parts import KnownPart
from .simulated_shape import simulate_cloud

__all__ = ["PartReport", "read_part", "report_part"]

Array = NDArray[np.float64]

TRACED = 0.9  # share of a true edge from which on it counts as found
# Pitches: what a scan needs of an edge, and how well it finds it.
_ROOM, _LONG, _RMS = 5.0, 12.0, 0.25
_OF_RADIUS = 0.02  # how much worse than the noise an edge may be known under a fillet


@dataclass(frozen=True)
class PartReport:
    """All edges of one part.

    Attributes
    ----------
    part : what was scanned
    cloud : the simulated scan
    pitch, noise : of it, mm
    rows : one for each sharp edge
    """

    part: KnownPart
    cloud: SimulatedCloud
    pitch: float
    noise: float
    rows: tuple[EdgeReport, ...]

    @property
    def traced(self) -> tuple[EdgeReport, ...]:
        """The edges that were found along at least 90 % of their length."""
        return tuple(row for row in self.rows if row.traced >= TRACED)

    @property
    def in_sigmas(self) -> Array:
        """Mahalanobis distances (m,) of the edge points on these."""
        return np.concatenate([np.zeros(0), *(row.in_sigmas for row in self.traced)])

    @property
    def in_own_sigmas(self) -> Array:
        """The same in the standard deviations of each point alone, without what short edges add."""
        alone = (row.in_sigmas * row.edge.reserve for row in self.traced if row.edge is not None)
        return np.concatenate([np.zeros(0), *alone])

    @property
    def unsmoothed_in_sigmas(self) -> Array:
        """The same of the sections by themselves, before they were smoothed along the edge."""
        return np.concatenate([np.zeros(0), *(row.unsmoothed_in_sigmas for row in self.traced)])

    def text(self) -> str:
        """The table and its summary."""
        lines = [
            "edge      length    room  traced      rms      max    sigma  wandering  stops",
            "              mm      mm       %       mm       mm       mm     points",
        ]
        lines += [_line(row) for row in self.rows]
        return "\n".join([*lines, *self._summary()])

    def _summary(self) -> list[str]:
        errors = np.concatenate([np.zeros(0), *(row.errors for row in self.traced)])
        wandering = sum(row.wandering for row in self.rows)
        lines = [
            f"{self.part.name}: {len(self.cloud)} points, {len(self.rows)} sharp edges; "
            f"{len(self.traced)} of them traced along at least {TRACED:.0%} of their length."
        ]
        if len(errors):
            lines.append(
                f"Edge points on these: rms {np.sqrt(np.mean(errors**2)):.4f} mm, largest rms of "
                f"one edge {max(row.rms for row in self.traced):.4f} mm, largest error "
                f"{errors.max():.4f} mm."
            )
            middle, most = median_and_95(self.in_sigmas)
            alone, most_alone = median_and_95(self.in_own_sigmas)
            before, most_before = median_and_95(self.unsmoothed_in_sigmas)
            lines.append(
                f"Their distance in stated sigma: median {middle:.2f}, 95 % {most:.2f}; without "
                f"what short edges add {alone:.2f}, {most_alone:.2f}; of one section by itself "
                f"{before:.2f}, {most_before:.2f} (true ones: {TRUE_MEDIAN:.2f}, {TRUE_95:.2f})."
            )
        lines += self._by_room()
        lines += self._under_fillets()
        lines.append(
            f"Edge points farther than {WANDERING:g} pitches from every true edge: {wandering}."
        )
        return lines

    def _by_room(self) -> list[str]:
        """How many are found where there is room to see the sides, and where there is less."""
        lines = []
        roomy = [row for row in self.rows if self._has_room(row)]
        narrow = [row for row in self.rows if not self._has_room(row)]
        for rows, where in (
            (roomy, f"With {_ROOM:g} pitches of room and more, and {_LONG:g} of length"),
            (narrow, "With less"),
        ):
            if rows:
                found = [row for row in rows if self._is_found(row)]
                middle = np.median([row.rms for row in found]) if found else np.nan
                lines.append(
                    f"{where}: {len(found)} of {len(rows)} found, with an rms error of at most "
                    f"{_RMS:g} pitches (median {middle:.4f} mm)."
                )
        return lines

    def _under_fillets(self) -> list[str]:
        """How many of the original sharp edges are met under their fillets."""
        radius = self.part.fillet
        if not radius:
            return []
        allowed = self.noise + _OF_RADIUS * radius
        near = [row.rms <= allowed for row in self.rows]
        wide = [
            bool(np.min(self.part.side_left(row.truth)) >= _ROOM * self.pitch) for row in self.rows
        ]
        both = sum(n and w for n, w in zip(near, wide, strict=True))
        return [
            f"Under fillets of {radius:g} mm: {sum(near)} of {len(near)} with an rms error of at "
            f"most one noise sigma and {_OF_RADIUS:.0%} of the radius ({allowed:.3g} mm); of those "
            f"with {_ROOM:g} pitches of side between their fillet and the next all along, {both} "
            f"of {sum(wide)}."
        ]

    def _has_room(self, row: EdgeReport) -> bool:
        room = float(np.min(row.truth.room))
        return room >= _ROOM * self.pitch and row.truth.length > _LONG * self.pitch

    def _is_found(self, row: EdgeReport) -> bool:
        return row.traced >= TRACED and row.rms <= _RMS * self.pitch and not row.wandering


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
        said = error.args[0] if error.args else error
        said = said.get("sErrMsg", said) if isinstance(said, dict) else said
        raise ValueError(f"{file} cannot be read as CAD ({said}); export it again.") from error
    if shape.isNull() or not shape.Faces:
        raise ValueError(f"{file} holds no faces; give a part made of solids or surfaces.")
    return shape


def report_part(
    part: KnownPart,
    pitch: float,
    noise: float,
    probe_radius: float = 0.0,
    seed: int = 0,
    progress: Progress | None = None,
) -> PartReport:
    """Scan every edge that is sought in a simulated cloud, each from one click at its middle.

    Parameters
    ----------
    part : the shape to scan, and its true edges
    pitch, noise, probe_radius, seed : of the cloud, see `simulate_cloud`
    progress : told the share of the edges that is done; where it answers False, these are kept

    Raises
    ------
    ValueError: see `simulate_cloud`.
    """
    cloud = simulate_cloud(part.shape, pitch, noise, probe_radius, seed)
    sought, others = part.edges, (*part.edges, *part.others)
    rows: list[EdgeReport] = []
    for number, truth in enumerate(sought):
        if progress is not None and not progress.update(number / len(sought), truth.name):
            break
        rows.append(report_edge(cloud, truth, pitch, others))
    return PartReport(part, cloud, pitch, noise, tuple(rows))


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
