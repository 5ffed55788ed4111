# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simple parts whose edges are known, scanned beside what others make of the same clouds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud
from ..experiments.edge_report import EdgeReport, report_edge, root_mean_square
from ..experiments.honesty import median_and_95
from ..experiments.peers import PEERS
from ..scanning import Progress
from .known_parts import KnownPart, simple_parts
from .simulated_shape import simulate_cloud

__all__ = ["SimpleAccuracy", "measure_simple_parts", "simple_table", "with_outliers"]

Array = NDArray[np.float64]

PITCH, NOISE, EDGE_PITCH = 0.5, 0.02, 0.75  # mm
_OUTLIERS, _OUTLIER_REACH = 0.05, 20.0  # share of the points; pitches from the surface


@dataclass(frozen=True)
class SimpleAccuracy:
    """One part, over all seeds; lengths mm.

    Attributes
    ----------
    name : of the part
    first : the scan of the first cloud, for a picture
    errors, in_sigmas : (m,) distances of the edge points from the true edge, and Mahalanobis
        distances
    unsmoothed, unsmoothed_in_sigmas : (m,) the same of the sections by themselves, before they were
        smoothed along the edge
    among_outliers : (k,) errors in the same clouds with outliers
    peers : (j,) errors of each peer, by its name; none where it was not asked
    """

    name: str
    first: EdgeReport
    errors: Array
    in_sigmas: Array
    unsmoothed: Array
    unsmoothed_in_sigmas: Array
    among_outliers: Array
    peers: dict[str, Array]


def measure_simple_parts(
    seeds: int, peers: Sequence[str] = (), progress: Progress | None = None
) -> list[SimpleAccuracy]:
    """Scan the simple parts, each in so many clouds; those done so far when cancelled.

    Parameters
    ----------
    seeds : number of clouds of each part
    peers : names of the peers to ask
    progress : told the share of the clouds done

    Raises
    ------
    ImportError: a peer that is not installed.
    """
    parts = simple_parts()
    rows: list[SimpleAccuracy] = []
    for number, part in enumerate(parts):
        found = []
        for seed in range(seeds):
            share = (number + seed / seeds) / len(parts)
            if progress is not None and not progress.update(share, part.name):
                return rows
            found.append(_measure(part, seed, peers))
        rows.append(_joined(part.name, found))
    return rows


def _measure(part: KnownPart, seed: int, peers: Sequence[str]) -> SimpleAccuracy:
    cloud = simulate_cloud(part.shape, PITCH, NOISE, seed=seed)
    (truth,) = part.edges
    plain, among = (
        report_edge(points, truth, PITCH, edge_pitch=EDGE_PITCH)
        for points in (cloud, with_outliers(cloud, seed))
    )
    asked = {name: truth.distance(PEERS[name][1](cloud, truth, NOISE)) for name in peers}
    return SimpleAccuracy(
        part.name,
        plain,
        plain.errors,
        plain.in_sigmas,
        plain.unsmoothed,
        plain.unsmoothed_in_sigmas,
        among.errors,
        asked,
    )


def _joined(name: str, found: Sequence[SimpleAccuracy]) -> SimpleAccuracy:
    def joined(field: str) -> Array:
        return np.concatenate([getattr(each, field) for each in found])

    return SimpleAccuracy(
        name,
        found[0].first,
        joined("errors"),
        joined("in_sigmas"),
        joined("unsmoothed"),
        joined("unsmoothed_in_sigmas"),
        joined("among_outliers"),
        {peer: np.concatenate([each.peers[peer] for each in found]) for peer in found[0].peers},
    )


def with_outliers(cloud: PointCloud, seed: int) -> PointCloud:
    """The cloud and 5 % more points, uniform in space within 20 pitches of the surface."""
    rng = np.random.default_rng([seed, 5])
    count = round(_OUTLIERS * len(cloud))
    way = rng.normal(size=(count, 3))
    way *= (rng.random(count) ** (1 / 3) / np.linalg.norm(way, axis=1))[:, None]
    near = cloud.points[rng.integers(len(cloud), size=count)]
    return PointCloud(np.vstack([cloud.points, near + _OUTLIER_REACH * PITCH * way]))


def simple_table(rows: Sequence[SimpleAccuracy]) -> str:
    """Root mean square distances from the true edge, and how honest the scan is."""
    peers = list(rows[0].peers) if rows else []
    lines = [
        "root mean square           edge      one     5 %   sigmas: points   one section"
        + "".join(f"  {name.rpartition(' ')[0]:>10}" for name in peers),
        "distance, mm             points  section  outliers  median  95 %  median  95 %"
        + "".join(f"  {name.rpartition(' ')[2]:>10}" for name in peers),
    ]
    for row in rows:
        distances = [*median_and_95(row.in_sigmas), *median_and_95(row.unsmoothed_in_sigmas)]
        lines.append(
            f"{row.name:<24} {root_mean_square(row.errors):.4f}   "
            f"{root_mean_square(row.unsmoothed):.4f}    "
            f"{root_mean_square(row.among_outliers):.4f}"
            + "  {:6.2f}{:6.2f}  {:6.2f}{:6.2f}".format(*distances)
            + "".join(f"  {root_mean_square(row.peers[name]):10.4f}" for name in peers)
        )
    return "\n".join(lines)
