# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast one processor core of this machine reads, indexes and scans a cloud.

Indexing is compared with SciPy's bare KD-tree on the same points in the same run, so that the
ratio says something about this software on any machine.
"""

from __future__ import annotations

from collections.abc import Callable
from cProfile import Profile
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from pstats import Stats
from tempfile import TemporaryDirectory
from time import process_time
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..cloud import PointCloud, SimulatedCloud, TorusObject, read_cloud, write_cloud
from ..scanning import Progress, ScanLines, scan_edge

__all__ = ["Speed", "measure_speed"]

Result = TypeVar("Result")

OBJECT = TorusObject(section_radius=100.0, edge_radius=150.0, angle=np.radians(110.0))
AMPLITUDE = 60.0  # mm, of the simulated strip on both sides of the edge together
NOISE = 0.02  # mm
# Functions, by the file they are in, that fit sides and intersect them; none calls another.
_FITS = {
    ("normal_equations", "block_moments"),
    ("side_fit", "choose_stretches"),
    ("side_fit", "fit_summed"),
    ("corner", "corners"),
}


@dataclass(frozen=True)
class Speed:
    """Seconds of processor time that each task takes.

    Attributes
    ----------
    points : number of points in the cloud
    reading : seconds to read them, by file name ending
    indexing : seconds for the cloud's KD-tree
    bare_indexing : seconds for SciPy's KD-tree alone
    scanning : seconds for one edge from one click, everything automatic, the quickest of three,
        as for the index
    edge_points : number of edge points that gave
    slab_points : mean number of cloud points in the slab of one of them
    in_tree, in_fits : share of the scan's time in queries of the KD-tree, and in the fits of the
        sides and their intersection
    mean_error : their mean distance from the true edge, mm
    """

    points: int
    reading: dict[str, float]
    indexing: float
    bare_indexing: float
    scanning: float
    edge_points: int
    slab_points: float
    in_tree: float
    in_fits: float
    mean_error: float

    @property
    def edge_points_per_second(self) -> float:
        """Edge points in a second of scanning."""
        return self.edge_points / self.scanning

    @property
    def indexing_ratio(self) -> float:
        """Time for the cloud's index over the time for SciPy's bare tree."""
        return self.indexing / self.bare_indexing

    def per_million(self, seconds: float) -> float:
        """Seconds for a million points, of seconds for this cloud."""
        return seconds * 1e6 / self.points


def measure_speed(points: int = 1_000_000, progress: Progress | None = None) -> Speed | None:
    """Time reading, indexing and scanning on a simulated cloud with one curved edge.

    Parameters
    ----------
    points : int
        About how many points the cloud shall have.
    progress : object with ``update``, optional
        Is told how far the measurement is; where it answers False, the result is None.

    Raises
    ------
    ValueError: fewer than 10 000 points.
    """
    if points < 10_000:
        raise ValueError(f"A speed cannot be told from {points} points; take 10000 or more.")
    tell = progress.update if progress is not None else _tell_nobody
    if not tell(0.0, "simulating"):
        return None
    cloud = simulated_cloud(points)
    reading = {}
    with TemporaryDirectory() as folder:
        for number, ending in enumerate((".xyz", ".ply")):
            if not tell(0.1 + 0.2 * number, f"reading {ending}"):
                return None
            path = Path(folder) / f"cloud{ending}"
            write_cloud(cloud, path)
            reading[ending] = _seconds(partial(read_cloud, path))[0]
    if not tell(0.6, "indexing"):
        return None
    array = np.array(cloud.points)
    bare = min(_seconds(lambda: cKDTree(array, balanced_tree=False))[0] for _ in range(3))
    indexing = min(_seconds(lambda: PointCloud(array).tree)[0] for _ in range(3))
    if not tell(0.7, "scanning"):
        return None
    true_edge = cloud.edges[0]
    click = true_edge.points[len(true_edge) // 2]
    scans = []
    for _ in range(3):  # the first one also loads what it needs
        fresh = PointCloud(array)
        fresh.tree  # noqa: B018 (built before the clock of the scan starts)
        scans.append(_seconds(partial(scan_edge, fresh, at=click)))
    scanning, edge = min(scans, key=lambda scan: scan[0])
    if not isinstance(edge.scan_lines, ScanLines):
        raise TypeError("a scan with patches has patches")
    in_tree, in_fits = _shares(array, click)
    tell(1.0, "done")
    return Speed(
        points=len(cloud),
        reading=reading,
        indexing=indexing,
        bare_indexing=bare,
        scanning=scanning,
        edge_points=len(edge.points),
        slab_points=len(edge.scan_lines.points.index) / len(edge.points),
        in_tree=in_tree,
        in_fits=in_fits,
        mean_error=float(true_edge.distance(edge.points).mean()),
    )


def simulated_cloud(points: int) -> SimulatedCloud:
    """Half a ring with a curved edge, of about so many points."""
    trial = OBJECT.cloud(pitch=0.3, amplitude=AMPLITUDE)
    pitch = float(0.3 * np.sqrt(len(trial) / points))
    return OBJECT.cloud(pitch=pitch, amplitude=AMPLITUDE, noise=NOISE, seed=0)


def _shares(points: NDArray[np.float64], click: NDArray[np.float64]) -> tuple[float, float]:
    """Shares of one scan's time in queries of the KD-tree and in fits, seen by the profiler."""
    cloud = PointCloud(points)
    cloud.tree  # noqa: B018 (as above)
    profile = Profile(process_time)
    profile.runcall(scan_edge, cloud, at=click)
    times = Stats(profile).stats  # type: ignore[attr-defined]
    queries = sum(own for (_, _, name), (_, _, own, _, _) in times.items() if "cKDTree" in name)
    fits = sum(
        total
        for (file, _, name), (_, _, _, total, _) in times.items()
        if (Path(file).stem, name) in _FITS
    )
    whole = sum(own for _, _, own, _, _ in times.values())
    return queries / whole, fits / whole


def _seconds(task: Callable[[], Result]) -> tuple[float, Result]:
    began = process_time()
    result = task()
    return process_time() - began, result


def _tell_nobody(fraction: float, so_far: object) -> bool:
    return True
