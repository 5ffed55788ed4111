# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges of CAD parts found in simulated scans of them, and compared with the parts' own."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from time import perf_counter
from typing import Any

from ..cloud import PointCloud
from ..experiments.network_report import NetworkReport, labels_report, network_report
from ..experiments.peers import whole_cloud_labels
from ..scanning import Progress, find_edges
from .known_parts import KnownPart, block_with_bore, filleted, sharp_part
from .part_report import read_part
from .simulated_shape import simulate_cloud

__all__ = ["bench_part", "parts_to_bench"]

PITCH, NOISE = 0.002, 0.2  # of the part's diagonal, and of the pitch


def parts_to_bench(files: list[Path], fillets: list[float]) -> Iterator[tuple[KnownPart, float]]:
    """Parts with the pitch to scan them with: each as it is, and with fillets of some pitches.

    Raises
    ------
    ValueError: a file that cannot be read, or edges that cannot be rounded.
    """
    shapes: list[tuple[str, Any]] = [(file.name, read_part(file)) for file in files]
    for name, shape in shapes or [("block with bore", block_with_bore())]:
        pitch = PITCH * shape.BoundBox.DiagonalLength
        if not fillets:
            yield sharp_part(name, shape), pitch
        for radius in fillets:
            yield filleted(name, shape, radius * pitch, pitch), pitch


def bench_part(
    part: KnownPart,
    pitch: float,
    seed: int = 0,
    peers: bool = False,
    progress: Progress | None = None,
) -> list[NetworkReport]:
    """Find all edges of one part in its cloud; and what surface variation labels there."""
    simulated = simulate_cloud(part.shape, pitch, NOISE * pitch, 0.0, seed)
    cloud = PointCloud(simulated.points)
    began = perf_counter()
    network = find_edges(cloud, progress=progress)
    reports = [network_report(network, part.edges, pitch, perf_counter() - began, part.others)]
    if peers and not network.cancelled:
        began = perf_counter()
        labelled = whole_cloud_labels(cloud, part.edges)
        seconds = perf_counter() - began
        reports.append(
            labels_report(labelled, part.edges, pitch, seconds, len(cloud), "surface variation")
        )
    return reports
