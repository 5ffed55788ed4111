# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges of CAD parts found in simulated scans of them, and compared with the parts' own."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

from numpy.typing import ArrayLike

from ..cloud import PointCloud, TrueEdge
from ..experiments.network_report import NetworkReport, labels_report, network_report
from ..experiments.regions_report import RegionsReport, regions_report
from ..scanning import Progress, find_edges
from .known_parts import KnownPart, block_with_bore, filleted, sharp_part
from .part_report import read_part
from .sharp_edges import smooth_faces
from .simulated_shape import simulate_cloud
from .varied_parts import varied_parts

__all__ = ["PartBench", "bench_part", "parts_to_bench"]

Labels = Callable[[PointCloud, Sequence[TrueEdge]], ArrayLike]

PITCH, NOISE = 0.002, 0.2  # of the part's diagonal, and of the pitch


@dataclass(frozen=True)
class PartBench:
    """What was found in the cloud of one part.

    Attributes
    ----------
    reports : of `find_edges`, and of the peers that were asked
    regions : of the network's regions beside the part's faces; None where fillets make them one
    """

    reports: tuple[NetworkReport, ...]
    regions: RegionsReport | None


def parts_to_bench(files: list[Path], fillets: list[float]) -> Iterator[tuple[KnownPart, float]]:
    """Parts with the pitch to scan them with: each as it is, and with fillets of some pitches.

    Without files: a block with a bore, and parts of different kinds.

    Raises
    ------
    ValueError: a file that cannot be read, or edges that cannot be rounded.
    """
    shapes: list[tuple[str, Any]] = [(file.name, read_part(file)) for file in files]
    for name, shape in shapes or [("block with bore", block_with_bore()), *varied_parts()]:
        pitch = PITCH * shape.BoundBox.DiagonalLength
        if not fillets:
            yield sharp_part(name, shape), pitch
        for radius in fillets:
            yield filleted(name, shape, radius * pitch, pitch), pitch


def bench_part(
    part: KnownPart,
    pitch: float,
    seed: int = 0,
    peers: Mapping[str, Labels] | None = None,
    progress: Progress | None = None,
) -> PartBench:
    """Find all edges of one part in its cloud, and what peers label there.

    Parameters
    ----------
    peers : by name, a function of the cloud and the true edges that answers labelled points (k, 3)
    """
    simulated = simulate_cloud(part.shape, pitch, NOISE * pitch, 0.0, seed)
    cloud = PointCloud(simulated.points)
    began = perf_counter()
    network = find_edges(cloud, progress=progress)
    reports = [network_report(network, part.edges, pitch, perf_counter() - began, part.others)]
    if network.cancelled:
        return PartBench(tuple(reports), None)
    for name, label in (peers or {}).items():
        began = perf_counter()
        labelled = label(cloud, part.edges)
        seconds = perf_counter() - began
        reports.append(labels_report(labelled, part.edges, pitch, seconds, len(cloud), name))
    sharp = not part.others
    faces = smooth_faces(part.shape)[simulated.labels] if sharp else None
    regions = None if faces is None else regions_report(network.regions, faces)
    return PartBench(tuple(reports), regions)
