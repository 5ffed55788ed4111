# SPDX-License-Identifier: LGPL-2.1-or-later
"""How small the errors of edge points can be, and how large a scan says that they are."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_edgescan.experiments import run_doe
from freecad_edgescan.experiments.doe_comparison import compare_all
from freecad_edgescan.experiments.doe_design import Trial, trial
from freecad_edgescan.experiments.doe_scan import off_the_edge, scan_trial, trial_cloud
from freecad_edgescan.experiments.doe_tables import experiments_table
from freecad_edgescan.experiments.edge_bound import edge_bound
from freecad_edgescan.experiments.honesty import (
    TRUE_95,
    TRUE_MEDIAN,
    mahalanobis,
    median_and_95,
    true_share,
)
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
        distances = mahalanobis(moved, partial(off_the_edge, row))
        assert distances == pytest.approx(0.3 / sigma, rel=0.05)


def test_the_table_tells_how_exact_and_how_honest_the_scans_are() -> None:
    result = run_doe([9], method="patch", tests=[7, 8], jobs=1)
    runs = [run for run in result if run.completed]
    compared = compare_all(result)
    ratios = np.array([[run.unsmoothed_rms, run.rms_error] for run in runs])
    ratios /= [[run.bound] for run in runs]
    # Neighbours share curvature, so that errors below the bound are no wonder; half is enough.
    assert np.all((ratios > 0.2) & (ratios < 1.0))
    numbers = [compared.avg_ratio, compared.max_ratio, *np.median(ratios, axis=0)]
    numbers.append(ratios[:, 1].max())
    for name in ("mahalanobis", "unsmoothed_mahalanobis"):
        median, most = median_and_95(np.concatenate([getattr(run, name) for run in runs]))
        assert 0.6 < median < 1.5
        assert most < 3.2
        numbers += [median, most]
    line = next(line for line in experiments_table(result).splitlines() if line[:5] == "patch")
    assert [float(word) for word in line.split()[1:]] == pytest.approx([9, *numbers], abs=5e-3)


def test_runs_know_their_sections_before_smoothing() -> None:
    """With the numbers of the edge itself, not of the smoothed one."""
    row = trial(9, 8)
    (run,) = run_doe([9], method="patch", tests=[8], jobs=1)
    single = scan_trial(row, trial_cloud(row, 0), PATCH, "patch").unsmoothed
    off = off_the_edge(row, single.points)
    assert run.unsmoothed_rms == pytest.approx(np.sqrt(np.mean(np.sum(off**2, axis=1))), rel=1e-6)
    assert run.unsmoothed_rms != run.rms_error
    assert len(run.unsmoothed_mahalanobis) == run.points


def test_true_covariances_give_the_distances_of_two_normal_directions() -> None:
    """Sampled with a covariance that is neither round nor along the axes."""
    rng = np.random.default_rng(5)
    spread = np.array([[0.04, 0.015], [0.015, 0.01]])
    off = rng.multivariate_normal([0.0, 0.0], spread, 200_000)
    normals = np.tile([[1.0, 1.0, 0.0], [1.0, -1.0, 0.0]], (len(off), 1, 1)) / np.sqrt(2.0)
    edge = SimpleNamespace(
        points=np.column_stack([off, np.zeros(len(off))]),
        normals=normals,
        covariance=np.broadcast_to(spread, (len(off), 2, 2)),
    )
    distances = mahalanobis(edge, lambda points: points)
    assert median_and_95(distances) == pytest.approx((TRUE_MEDIAN, TRUE_95), abs=0.02)
    for distance in (0.5, 1.0, 2.0, 3.0):
        assert np.mean(distances < distance) == pytest.approx(true_share(distance), abs=0.005)
    assert true_share([TRUE_MEDIAN, TRUE_95]) == pytest.approx([0.5, 0.95])
