# SPDX-License-Identifier: LGPL-2.1-or-later
"""A search for confident wrong edges: one click on each of many wedges, or steps, at random.

A scan may refuse, and may know an edge badly; it must not state a small sigma for an edge that is
somewhere else. The measure is the Mahalanobis distance of each edge point: how far off it is across
the edge, in the standard deviations that the scan states.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..cloud import PointCloud
from ..geometry import Line
from ..scanning import Progress, ScanError, scan_edge
from .collecting import collect
from .honesty import TRUE_95, TRUE_MEDIAN, mahalanobis, median_and_95
from .processes import Failure
from .random_steps import RandomStep, StepEdges, make_step
from .random_wedges import RandomWedge, make_wedge

__all__ = ["KINDS", "Judged", "by_chance", "judge", "scanned_again", "search", "wedge_table"]

KINDS = ("wedges", "sharp wedges", "steps")
# A scan is wrong when more than this share of its points, or one point, or the root mean square
# of all is farther off than so many of its own standard deviations.
_SHARE, _OFF, _FAR_OFF, _RMS = 0.02, 4.0, 7.0, 2.5


@dataclass(frozen=True)
class Judged:
    """What a scan of one wedge or step states, held against the truth.

    Attributes
    ----------
    shape : it
    distances : (m,) Mahalanobis distances; none where the scan refused
    errors : (m,) pitches, distances from the edge
    reserve : what is added to the standard deviations because short edges err as a whole
    """

    shape: RandomWedge | RandomStep
    distances: np.ndarray
    errors: np.ndarray
    reserve: float = 1.0

    @property
    def refused(self) -> bool:
        """Whether the scan found no edge."""
        return len(self.distances) == 0

    @property
    def wrong(self) -> bool:
        """Whether the edge is farther off than the scan states."""
        if self.refused:
            return False
        off, rms = self.distances > _OFF, np.sqrt(np.mean(self.distances**2))
        return bool(off.mean() > _SHARE or self.distances.max() > _FAR_OFF or rms > _RMS)

    @property
    def elsewhere(self) -> bool:
        """Whether most of it is off by more than four standard deviations."""
        return not self.refused and bool(np.median(self.distances) > _OFF)

    def line(self) -> str:
        """One line of text; only of an edge that was found."""
        return (
            f"{self.shape}: {len(self.distances)} edge points, "
            f"{(self.distances > _OFF).mean():.0%} beyond {_OFF:g}, largest "
            f"{self.distances.max():.1f}, up to {self.errors.max():.2g} pitches off"
        )


def _make(
    kind: str, number: int, sample: int
) -> tuple[RandomWedge | RandomStep, PointCloud, np.ndarray, Line | StepEdges]:
    if kind == "steps":
        return make_step(number, sample)
    return make_wedge(number, kind == "wedges", sample)


def judge(task: tuple[str, int, int]) -> Judged:
    """Scan one shape from one click: which kind it is, its number, and which of its scans."""
    shape, cloud, click, truth = _make(*task)
    try:
        edge = scan_edge(cloud, at=click)
    except ScanError:
        return Judged(shape, np.zeros(0), np.zeros(0))
    errors = np.linalg.norm(truth.residuals(edge.points), axis=1)
    return Judged(shape, mahalanobis(edge, truth.residuals), errors / shape.pitch, edge.reserve)


def search(
    count: int,
    kind: str = "wedges",
    first: int = 0,
    jobs: int = 2,
    progress: Progress | None = None,
) -> list[Judged]:
    """Scan shapes at random; those that were scanned so far when `progress` cancels.

    Parameters
    ----------
    count : of the shapes
    kind : one of `KINDS`; half of the wedges have a rounding, or none
    first : number of the first one
    jobs : number of processes
    progress : told the share of the shapes done

    Raises
    ------
    RuntimeError: a scan has failed with something else than a refusal, which is always a fault.
    """
    tasks = [(kind, number, 0) for number in range(first, first + count)]
    return _judged(tasks, jobs, progress)


def scanned_again(
    found: Sequence[Judged],
    kind: str,
    times: int = 10,
    jobs: int = 2,
    progress: Progress | None = None,
) -> list[Judged]:
    """The same shapes scanned again, with other points and other noise: is it chance, or they?

    Parameters
    ----------
    found : shapes
    kind : of them
    times : how often each of them
    jobs, progress : see `search`
    """
    tasks = [(kind, each.shape.number, k) for each in found for k in range(1, times + 1)]
    return _judged(tasks, jobs, progress) if tasks else []


def _judged(
    tasks: list[tuple[str, int, int]], jobs: int, progress: Progress | None
) -> list[Judged]:
    found = collect(judge, tasks, jobs, progress, lambda done: f"{len(done)} {tasks[0][0]}")
    judged = []
    for number, answer in sorted(found.items(), key=lambda item: item[0]):
        if isinstance(answer, Failure):
            raise RuntimeError(f"{tasks[number][0]}, number {tasks[number][1]}: {answer.text}")
        judged.append(answer)
    return judged


def wedge_table(found: Sequence[Judged], kind: str = "wedges") -> str:
    """Each wedge, or whatever kind it is, whose edge is wrong, and a summary of all."""
    scanned = [judged for judged in found if not judged.refused]
    lines = [judged.line() for judged in scanned if judged.wrong]
    if scanned:
        stated = np.concatenate([judged.distances for judged in scanned])
        alone = np.concatenate([judged.reserve * judged.distances for judged in scanned])
        (middle, most), (middle_alone, most_alone) = map(median_and_95, (stated, alone))
        lines.append(
            f"Distance of edge points in the standard deviations the scan states: median "
            f"{middle:.2f}, 95 % {most:.2f}; in those of each point alone, without the reserve of "
            f"short edges: {middle_alone:.2f}, {most_alone:.2f} (true ones: {TRUE_MEDIAN:.2f}, "
            f"{TRUE_95:.2f})."
        )
    wrong, elsewhere = (
        sum(getattr(judged, name) for judged in scanned) for name in ("wrong", "elsewhere")
    )
    lines.append(
        f"{len(found)} {kind}: {len(found) - len(scanned)} refused, {wrong} farther off than "
        f"stated, {elsewhere} of these somewhere else."
    )
    lines.append(
        f"Farther off than stated: more than {_SHARE:.0%} of the edge points are beyond {_OFF:g} "
        f"stated standard deviations, one is beyond {_FAR_OFF:g}, or their rms is above {_RMS:g}. "
        f"Somewhere else: most are beyond {_OFF:g}."
    )
    return "\n".join(lines)


def by_chance(again: Sequence[Judged], kind: str = "wedges") -> str:
    """How many shapes that were wrong once are wrong again with other points, and which often."""
    wrong = Counter({judged.shape.number: 0 for judged in again})
    wrong.update(judged.shape.number for judged in again if judged.wrong)
    times = len(again) // max(len(wrong), 1)
    mostly = sorted(number for number, count in wrong.items() if count > 0.5 * times)
    named = f": {', '.join(map(str, mostly))}" if mostly else ""
    return (
        f"These {len(wrong)} {kind} scanned {times} times more, with other points: "
        f"{wrong.total()} of {len(again)} scans are farther off than stated; more than half of its "
        f"scans are with {len(mostly)} of the {kind}{named}."
    )
