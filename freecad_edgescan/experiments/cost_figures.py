# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a scan costs: with a growing amplitude and with a growing cloud, figures 5.37 and 5.38.

Seconds are processor time of this process; building the cloud's index is not counted. Instead of
an octree with its levels the cloud has a KD-tree, so that figure 5.38 has no step.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from time import process_time

import numpy as np

from ..cloud import SimulatedCloud
from ..scanning import Progress
from .doe_curves import Curve, Curves
from .doe_design import Trial
from .doe_result import PATCH, Group
from .doe_scan import scan_trial, trial_cloud
from .scan_figures import printed_trial

__all__ = ["amplitude_cost", "cloud_cost", "timed"]

AMPLITUDES = np.arange(14.0, 46.0, 2.0)  # mm; with a line pitch of 2 mm a quadratic needs 12
WIDTHS = np.arange(24.0, 300.0, 18.0)  # mm, of the clouds across the edge
_WIDE = 132.5  # mm: a cloud of the published 123 000 points
_USUAL = 20.0  # mm, amplitude on clouds of every size
_NOISE = 0.005  # mm
_RADIUS = 100.0  # mm
_TIMES = 2  # that each scan is timed; the shorter time counts


def amplitude_cost(method: str, number: str, progress: Progress | None) -> tuple[Curves, ...]:
    """Seconds for one scan by amplitude, on one cloud: proportional."""
    cloud = trial_cloud(_trial(_USUAL), 0, _WIDE)
    jobs = [(_trial(float(amplitude)), cloud) for amplitude in AMPLITUDES]
    seconds = list(timed(jobs, method, progress))
    if len(seconds) < 2:
        return ()
    amplitudes = AMPLITUDES[: len(seconds)]
    slope, offset = np.polyfit(amplitudes, seconds, 1)
    correlation = np.corrcoef(amplitudes, seconds)[0, 1]
    notes = (
        f"{len(cloud)} points; line: {offset:.3f} s {slope:+.4f} s/mm · A, "
        f"correlation {correlation:.3f}.",
    )
    curves = (
        Curve.of("scan", amplitudes, seconds, measured=True),
        Curve.of("line", amplitudes, offset + slope * amplitudes),
    )
    title = f"Figure {number}: time of a scan by amplitude"
    return (Curves(title, "amplitude, mm", "processor time, s", curves, notes),)


def cloud_cost(method: str, number: str, progress: Progress | None) -> tuple[Curves, ...]:
    """Seconds for one scan by the cloud's number of points: all but constant."""
    trial, sizes = _trial(_USUAL), []

    def jobs() -> Iterator[tuple[Trial, SimulatedCloud]]:
        for width in WIDTHS:
            cloud = trial_cloud(trial, 0, float(width))
            sizes.append(len(cloud))
            yield trial, cloud

    seconds = list(timed(jobs(), method, progress, len(WIDTHS)))
    if len(seconds) < 2:
        return ()
    known = np.array(sizes[: len(seconds)], dtype=float)
    growth = np.polyfit(known, seconds, 1)[0] * (known[-1] - known[0]) / np.mean(seconds)
    notes = (
        f"The largest cloud has {known[-1] / known[0]:.0f} times the points of the smallest; "
        f"a line through the times grows by {100 * growth:.0f} % of their mean.",
    )
    curve = Curve.of("scan", known / 1000, seconds, measured=True)
    title = f"Figure {number}: time of a scan by size of the cloud"
    return (Curves(title, "points in the cloud, thousands", "processor time, s", (curve,), notes),)


def _trial(amplitude: float) -> Trial:
    """The object printed with the figures."""
    return replace(printed_trial(0.1, _NOISE, section_radius=_RADIUS), amplitude=amplitude)


def timed(
    jobs: Iterable[tuple[Trial, SimulatedCloud]],
    method: str,
    progress: Progress | None,
    count: int = len(AMPLITUDES),
) -> Iterator[float]:
    """Seconds of each scan, until `progress` cancels."""
    group: Group = PATCH if method == PATCH[0] else ("square", 2)
    for number, (trial, cloud) in enumerate(jobs):
        scan_trial(trial, cloud, group, method)  # builds what a cloud keeps: index, pitch, noise
        yield min(_seconds(trial, cloud, group, method) for _ in range(_TIMES))
        if progress and not progress.update((number + 1) / count, f"{number + 1} scans"):
            return


def _seconds(trial: Trial, cloud: SimulatedCloud, group: Group, method: str) -> float:
    began = process_time()
    scan_trial(trial, cloud, group, method)
    return process_time() - began
