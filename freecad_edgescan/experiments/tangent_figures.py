# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways to find the direction of the edge, compared: figures 4.9 and 4.11.

The edges of the published figures are not stated. The sides of the first edge here are all but
flat over the length of a scan line, those of the second bend by 38°, which no plane follows.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..scanning import Progress
from ..scanning.automatic import MIN_ANGLE
from ..scanning.parameters import Tangent
from ..scanning.probe_settings import ProbeSettings
from ..scanning.probed_tangent import edge_tangent
from ..scanning.progress import SoFar
from ..scanning.safeguards import Safeguards
from ..scanning.section import Station
from .doe import run_doe
from .doe_curves import Curve, Curves
from .doe_design import Trial, trial
from .doe_result import Group
from .doe_scan import scan_trial, trial_cloud
from .partial_progress import PartialProgress

__all__ = ["compare_tangents", "tangent_errors", "tangents_along"]

_GROUP: Group = ("square", 2)
_EDGES = {"4.9": trial(2, 4), "4.11": trial(4, 15)}
_HARDEST = 5  # experiment with the most published failures of quadratic scans


def compare_tangents(
    seed: int = 0, jobs: int = 2, progress: Progress | None = None
) -> tuple[Curves, ...]:
    """Angle between the edge's tangent as each way finds it and the true one.

    All ways look at the same lines, of one scan. How well a walk does with each of them is told
    in the notes: runs of experiment 5 that completed, without any of the safeguards that could
    make up for a bad tangent.
    """
    completed = {}
    for number, way in enumerate(Tangent):
        result = run_doe(
            [_HARDEST],
            degrees=[2],
            seed=seed,
            jobs=jobs,
            literal=True,
            overrides={"tangent": way.value},
            progress=PartialProgress(progress, number, len(Tangent)),
        )
        if result.cancelled:
            return ()
        completed[way] = f"{result.completed} of {len(result)}"
    note = f"Walks of experiment {_HARDEST} that completed (quadratic, as printed): " + ", ".join(
        f"{way} {count}" for way, count in completed.items()
    )
    figures = [tangents_along(number, row, seed) for number, row in _EDGES.items()]
    return (*figures[:-1], replace(figures[-1], notes=(*figures[-1].notes, note)))


def tangents_along(number: str, row: Trial, seed: int) -> Curves:
    """Errors of the three ways at every line of one scan."""
    walk = _Recorder()
    edge = scan_trial(row, trial_cloud(row, seed), _GROUP, progress=walk)
    lines = [station.line for station in walk.stations if station.line is not None]
    points = np.array([line.edge_point for line in lines])
    printed = replace(edge.parameters, safeguards=Safeguards.none())
    settings = ProbeSettings.from_parameters(printed, MIN_ANGLE)
    forward = np.gradient(points, axis=0)
    curves, notes = [], []
    for way in Tangent:
        chosen = replace(settings, tangent=way)
        tangents = [
            edge_tangent(lines[j], lines[j - 1], forward[j], chosen) for j in range(1, len(lines))
        ]
        angles = tangent_errors(points[1:], np.array(tangents))
        curves.append(Curve.of(way.value, np.arange(1, len(lines)), angles, measured=True))
        notes.append(f"{way}: median {np.median(angles):.2f}°, largest {angles.max():.2f}°")
    title = f"Figure {number}: error of the tangent along edge {row.experiment}.{row.test}"
    title += f", s·κ_s = {row.arc_share:.2f}"
    return Curves(title, "scan line", "angle, degrees", tuple(curves), tuple(notes))


class _Recorder:
    """Keeps the stations of a walk as they were found."""

    def __init__(self) -> None:
        self.stations: tuple[Station, ...] = ()

    def update(self, fraction: float, so_far: object) -> bool:
        """Note what there is so far."""
        if isinstance(so_far, SoFar):
            self.stations = so_far.stations
        return True


def tangent_errors(points: NDArray, tangents: NDArray) -> NDArray[np.float64]:
    """Angle of tangents (m, 3) to the circle round the z axis at points (m, 3), degrees."""
    x, y, _ = points.T
    true = np.column_stack([-y, x, np.zeros(len(points))]) / np.hypot(x, y)[:, None]
    return np.degrees(np.arccos(np.clip(np.einsum("mi,mi->m", true, tangents), -1.0, 1.0)))
