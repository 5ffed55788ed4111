# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one edge costs, from a file to its curve, however many points there are besides.

A cloud grows here as that of a larger part does: at the same pitch, by more surface. Copies of one
object with a curved edge stand in rows; the edge of the one in the middle is scanned from a click,
and its points are the same in every size. A part that is scanned more finely has more edge points
and takes longer for that reason alone; the time for each edge point is what ``bench`` prints.

Each size is measured in a fresh process, whose peak of memory belongs to this size.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..cloud import SimulatedCloud, TrueEdge, read_cloud
from ..scanning import Progress, scan_edge
from .peak_memory import memory_now, peak_memory
from .processes import Failure, map_in_processes
from .speed import simulated_cloud

__all__ = ["SIZES", "SizeCost", "measure_sizes", "slope", "write_copies"]

Array = NDArray[np.float64]
Result = TypeVar("Result")

SIZES = (100_000, 320_000, 1_000_000, 3_200_000, 10_000_000)
FEWEST = 20_000
_OBJECT = 100_000  # points of one copy, unless a size is smaller
_GAP = 20.0  # mm between two copies


@dataclass(frozen=True)
class SizeCost:
    """What one size costs: seconds of processor time, and bytes.

    Attributes
    ----------
    points : number of points in the cloud
    file_bytes : size of its file
    cropping : to read the region of one copy out of it
    crop_peak : most bytes in memory meanwhile
    reading, indexing : to read all of it, and for the KD-tree
    searching : for pitch and noise, from 2000 neighbourhoods
    scanning : for the edge from one click, the quickest of three
    curve : for its B-spline
    file_to_curve : all of this by the clock, with the first scan, without the cropping
    peak : most bytes in memory until then
    edge_points : number of edge points
    mean_error : their mean distance from the true edge, mm
    """

    points: int
    file_bytes: int
    cropping: float
    crop_peak: int
    reading: float
    indexing: float
    searching: float
    scanning: float
    curve: float
    file_to_curve: float
    peak: int
    edge_points: int
    mean_error: float

    HEADER = (
        "            file  crop  crop  read index search  scan curve file to bytes/   edge  error\n"
        "   points     MB     s    MB     s     s      s     s     s curve s  point points     mm"
    )

    @property
    def bytes_per_point(self) -> float:
        """Most bytes in memory for each point."""
        return self.peak / self.points

    def text(self) -> str:
        """One row below `HEADER`."""
        return (
            f"{self.points:9d} {self.file_bytes / 1e6:6.1f} "
            f"{self.cropping:5.2f} {self.crop_peak / 1e6:5.1f} {self.reading:5.2f} "
            f"{self.indexing:5.2f} {self.searching:6.2f} {self.scanning:5.2f} {self.curve:5.2f} "
            f"{self.file_to_curve:7.2f} {self.bytes_per_point:6.0f} {self.edge_points:6d} "
            f"{self.mean_error:6.4f}"
        )


def measure_sizes(
    sizes: Sequence[int] = SIZES, progress: Progress | None = None
) -> Iterator[SizeCost]:
    """Measure one size after the other.

    Parameters
    ----------
    sizes : about how many points the clouds shall have
    progress : object with ``update``, optional
        Is told how far the measurement is; where it answers False, there are no more rows.

    Raises
    ------
    ValueError: fewer than 20 000 points, or a measurement that failed.
    """
    for size in sizes:
        if size < FEWEST:
            raise ValueError(f"A cost cannot be told from {size} points; take {FEWEST} or more.")
    tell = progress.update if progress is not None else _tell_nobody
    begun, whole = 0, sum(sizes)
    one = simulated_cloud(min(_OBJECT, *sizes))
    for size in sizes:
        share, now = begun / whole, f"{size} points"
        if not tell(share, now):
            return
        with TemporaryDirectory() as folder:
            file = Path(folder) / "cloud.ply"
            write_copies(one, size, file)
            task = _Task(file, one.edges[0], one.bounds, simulated_cloud(FEWEST))
            cost = _in_a_fresh_process(task, partial(tell, share, now))
        if cost is None:
            return
        if isinstance(cost, Failure):
            raise ValueError(f"{now} could not be measured: {cost.text}.")
        yield cost
        begun += size
    tell(1.0, "done")


def slope(costs: Sequence[SizeCost]) -> float:
    """How the time of a scan grows: exponent of the number of points, nan for a single size."""
    if len({cost.points for cost in costs}) < 2:
        return float("nan")
    points, seconds = np.log([(cost.points, cost.scanning) for cost in costs]).T
    return float(np.polyfit(points, seconds, 1)[0])


@dataclass(frozen=True)
class _Task:
    file: Path
    edge: TrueEdge
    region: tuple[Array, Array]
    tried_before: SimulatedCloud


def write_copies(one: SimulatedCloud, size: int, file: Path) -> int:
    """Write copies of a cloud in rows, about so many points, as a binary .ply of floats.

    Copy by copy, so that memory holds one at a time. The middle one stands where the first stood.

    Returns
    -------
    The number of points.
    """
    copies = max(1, round(size / len(one)))
    width = np.ceil(one.size + _GAP) * (1.0, 1.0, 0.0)
    columns = int(np.ceil(np.sqrt(copies)))
    middle = divmod(copies // 2, columns)
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {copies * len(one)}\n"
        "property float x\nproperty float y\nproperty float z\nend_header\n"
    )
    with file.open("wb") as stream:
        stream.write(header.encode("ascii"))
        for copy in range(copies):
            row, column = np.array(divmod(copy, columns)) - middle
            away = width * (column, row, 0.0)
            stream.write((one.points + away).astype("<f4").data)
    return copies * len(one)


def _in_a_fresh_process(task: _Task, goes_on: Callable[[], bool]) -> SizeCost | Failure | None:
    """What it costs, or why that is not known; None when it shall not go on."""
    with closing(map_in_processes(_measure, [task], 2)) as answers:  # one job would stay here
        for answer in answers:
            if answer is not None:
                return answer[1]
            if not goes_on():
                break
    return None


def _measure(task: _Task) -> SizeCost:
    click = task.edge.points[len(task.edge) // 2]
    before = memory_now()
    cropping, _ = _seconds(lambda: read_cloud(task.file, region=task.region))
    crop_peak = peak_memory() - before
    scan_edge(task.tried_before, at=task.tried_before.edges[0].points[9]).curve()  # loads all code
    before = memory_now()
    began = perf_counter()
    reading, cloud = _seconds(lambda: read_cloud(task.file))
    indexing, _ = _seconds(lambda: cloud.tree)
    searching, _ = _seconds(lambda: (cloud.pitch, cloud.noise))
    scanning, edge = _seconds(lambda: scan_edge(cloud, at=click))
    curve, _ = _seconds(edge.curve)
    file_to_curve = perf_counter() - began
    peak = peak_memory() - before
    again = [_seconds(lambda: scan_edge(cloud, at=click))[0] for _ in range(2)]
    return SizeCost(
        points=len(cloud),
        file_bytes=task.file.stat().st_size,
        cropping=cropping,
        crop_peak=crop_peak,
        reading=reading,
        indexing=indexing,
        searching=searching,
        scanning=min(scanning, *again),
        curve=curve,
        file_to_curve=file_to_curve,
        peak=peak,
        edge_points=len(edge.points),
        mean_error=float(task.edge.distance(edge.points).mean()),
    )


def _seconds(task: Callable[[], Result]) -> tuple[float, Result]:
    began = process_time()
    result = task()
    return process_time() - began, result


def _tell_nobody(_fraction: float, _so_far: Any) -> bool:
    return True
