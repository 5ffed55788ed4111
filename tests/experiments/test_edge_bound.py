# SPDX-License-Identifier: LGPL-2.1-or-later
"""How small the errors of edge points can be, and how large a scan says that they are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from freecad_edgescan.experiments import run_doe
from freecad_edgescan.experiments.doe_design import Trial, trial
from freecad_edgescan.experiments.doe_scan import off_the_edge, scan_trial, trial_cloud
from freecad_edgescan.experiments.doe_tables import honesty_table
from freecad_edgescan.experiments.edge_bound import edge_bound
from freecad_edgescan.experiments.honesty import mahalanobis
from freecad_edgescan.scanning.corner import across_axes

PATCH = ("patch", 0)


def simulated(row: Trial, seed: int) -> float:
    """Root mean square error of least squares on exact points with noise along the normal only."""
    rng = np.random.default_rng(seed)
    exact = row.object.cloud(row.cloud_pitch, row.amplitude)
    rho, z = np.hypot(*exact.points[:, :2].T), exact.points[:, 2]
    azimuth = np.arctan2(exact.points[:, 1], exact.points[:, 0])
    edge = np.array([row.edge_radius, -row.section_radius])
    outer, inner = row.object.faces(row.amplitude)[:2]
    centres = [np.array([face.major_radius, face.centre_height]) for face in (outer, inner)]
    normals = np.array([(c - edge) / row.section_radius for c in centres])
    corner = edge + row.probe_radius * normals.sum(axis=0) / (1.0 + normals[0] @ normals[1])
    near = np.hypot(rho - corner[0], z - corner[1]) <= 0.5 * row.amplitude
    squares = []
    for station in np.arange(0.1, np.pi - 0.1, row.edge_pitch / row.edge_radius):
        here = near & (np.abs(azimuth - station) * row.edge_radius <= 0.5 * row.edge_pitch)
        moved = []
        for k, centre in enumerate(centres):
            mine = here & (exact.labels == k)
            away = np.column_stack([rho[mine], z[mine]]) - centre
            foot = edge - centre
            turn = np.arctan2(
                foot[0] * away[:, 1] - foot[1] * away[:, 0], away @ foot
            )  # of the section, from the edge's foot
            terms = np.column_stack([np.ones_like(turn), np.sin(turn), 1.0 - np.cos(turn)])
            noise = rng.normal(0.0, row.noise / np.sqrt(3.0), mine.sum())
            moved.append(np.linalg.lstsq(terms, noise, rcond=None)[0][0])
        squares.append(np.sum(np.linalg.solve(normals, moved) ** 2))
    return float(np.sqrt(np.mean(squares)))


@pytest.mark.parametrize("numbers", [(1, 2), (5, 5), (9, 8)])
def test_the_bound_is_the_error_of_the_best_there_is(numbers: tuple[int, int]) -> None:
    row = trial(*numbers)
    bound = edge_bound(row, trial_cloud(row, 0))
    drawn = np.sqrt(np.mean([simulated(row, seed) ** 2 for seed in range(5)]))
    assert bound == pytest.approx(drawn, rel=0.1)


def test_without_points_there_is_no_bound() -> None:
    row = trial(1, 2)
    cloud = trial_cloud(row, 0)
    assert edge_bound(replace(row, amplitude=1e-3), cloud) == np.inf


def test_a_distance_is_measured_in_the_stated_standard_deviations() -> None:
    row = trial(9, 8)
    edge = scan_trial(row, trial_cloud(row, 0), PATCH, "patch")
    x, y, _ = edge.points.T
    azimuth = np.arctan2(y, x)
    exact = np.column_stack(
        [
            row.edge_radius * np.cos(azimuth),
            row.edge_radius * np.sin(azimuth),
            np.full(len(edge), -row.section_radius),
        ]
    )
    covariance = np.tile(np.diag([0.04, 0.01]), (len(edge), 1, 1))  # 0.2 and 0.1 mm
    radial = np.column_stack([np.cos(azimuth), np.sin(azimuth), np.zeros(len(edge))])
    for axis, sigma in enumerate((0.2, 0.1)):
        way = across_axes(edge.normals)[:, axis]
        way = np.einsum("mi,mi->m", way, radial)[:, None] * radial + way * [0.0, 0.0, 1.0]
        moved = replace(edge, points=exact + 0.3 * way, covariance=covariance)
        assert mahalanobis(moved, off_the_edge(row, moved.points)) == pytest.approx(
            0.3 / sigma, rel=0.05
        )


def test_the_table_tells_how_honest_the_scans_are() -> None:
    result = run_doe([9], method="patch", tests=[7, 8], jobs=1)
    table = honesty_table(result)
    runs = [run for run in result if run.completed]
    ratio = np.median([run.rms_error / run.bound for run in runs])
    assert f"patch      9 {ratio:12.3f}" in table
    # Neighbours share curvature, so that errors below the bound are no wonder; half is enough.
    assert 0.2 < ratio < 1.0
    found = np.percentile(np.concatenate([run.mahalanobis for run in runs]), [50, 95])
    assert 0.6 < found[0] < 1.5
    assert found[1] < 3.2
