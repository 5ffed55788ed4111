# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smoothing along an edge: nearer to the truth, no farther than stated, and no change lost."""

import copy
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud, TorusObject
from freecad_edgescan.scanning import ScanParameters, scan_edge
from freecad_edgescan.scanning.corner import across_axes
from freecad_edgescan.scanning.section import frames_from_sides
from freecad_edgescan.scanning.smoothing import _runs, smoothed

SIGMA = 0.01  # mm


def root_mean_square(values):
    return np.sqrt(np.mean(np.square(values)))


def test_on_a_straight_edge_it_halves_the_error(wedge):
    before, after = [], []
    for seed in range(6):
        part = wedge(90.0, noise=0.03, length=40.0, width=10.0, seed=seed)
        edge = scan_edge(part.cloud, part.at(0.1, 0.4))
        before.append(part.distance(edge.unsmoothed.points))
        after.append(part.distance(edge.points))
    before, after = (root_mean_square(np.concatenate(part)) for part in (before, after))
    assert after < 0.65 * before


@pytest.mark.parametrize("radius", [12.0, 40.0])
def test_a_bent_edge_is_not_drawn_inwards(radius):
    """A mean over a chord would be off by its height, half a millimetre on the smaller circle."""
    part = TorusObject(section_radius=60.0, edge_radius=radius, angle=np.pi / 2)
    outwards, sigma = [], []
    for seed in range(4):
        cloud = part.cloud(pitch=0.4, amplitude=12.0, noise=0.05, seed=seed)
        truth = cloud.edges[0]
        edge = scan_edge(
            cloud, truth.points[len(truth) // 2], parameters=ScanParameters(edge_pitch=0.6)
        )
        middle = edge.points[5:-5]
        outwards.append(np.hypot(middle[:, 0], middle[:, 1]).mean() - radius)
        sigma.append(edge.sigma.mean())
    assert abs(np.mean(outwards)) < 0.5 * np.mean(sigma)


def test_a_sharp_bend_of_the_edge_stays():
    """Two straight pieces that meet under 12°: the edge between two planes and a bent roof."""
    rng = np.random.default_rng(4)
    turn = np.radians(12.0)
    x, y = rng.uniform(-20.0, 20.0, (2, 20000))
    z = -np.abs(y - np.maximum(x, 0.0) * np.tan(turn))
    cloud = PointCloud(np.column_stack([x, y, z]) + rng.normal(0.0, 0.02, (len(x), 3)))
    edge = scan_edge(cloud, at=(-8.0, 0.2, 0.0))
    x, y, _ = edge.points.T
    off = y - np.maximum(x, 0.0) * np.tan(turn)
    assert x.max() > 10.0
    # Half an edge pitch round the bend the sections themselves see both pieces.
    assert root_mean_square(off) < 0.05
    single = edge.unsmoothed.points
    worst = np.abs(single[:, 1] - np.maximum(single[:, 0], 0.0) * np.tan(turn)).max()
    assert np.abs(off).max() < worst + 0.02


def test_few_points_that_their_neighbours_contradict_give_way():
    """A few sections are moved by ten of their standard deviations, or many are."""
    measured, edge = straight_sections()
    for count, gives_way in ((1, True), (3, True), (8, False)):
        point = edge.point.copy()
        point[20 : 20 + count, 1] += 10.0 * SIGMA
        moved = copy.copy(edge)
        moved.point = point
        after = smoothed(measured, moved, 0.5, closed=False, straight=True).point[20, 1]
        assert (abs(after) < 2.0 * SIGMA) == gives_way


def test_a_run_goes_on_over_the_seam_of_a_closed_edge():
    chosen = np.array([True, True, False, True, False, True])
    assert [run.tolist() for run in _runs(chosen, closed=False)] == [[0, 1], [3], [5]]
    assert [run.tolist() for run in _runs(chosen, closed=True)] == [[3], [5, 0, 1]]
    assert [len(run) for run in _runs(np.ones(6, dtype=bool), closed=True)] == [6]


def test_one_section_that_is_off_by_chance_keeps_nothing_of_its_own_place():
    """Of a hundred sections one is three sigma off; it is drawn to its neighbours all the same."""
    measured, edge = straight_sections()
    point = edge.point.copy()
    point[20, 1] += 3.5 * SIGMA
    edge.point = point
    after = smoothed(measured, edge, 0.5, closed=False, straight=True).point[20, 1]
    assert abs(after) < 0.5 * SIGMA


@pytest.mark.parametrize(("ending", "stays"), [(True, False), (False, True)])
def test_at_an_end_the_neighbours_are_believed_only_where_another_surface_may_begin(ending, stays):
    measured, edge = straight_sections()
    point = edge.point.copy()
    point[-1, 1] += 10.0 * SIGMA
    edge.point = point
    after = smoothed(measured, edge, 0.5, closed=False, straight=True, ending=(True, ending)).point[
        -1, 1
    ]
    assert (after > 8.0 * SIGMA) == stays
    assert stays or abs(after) < 2.0 * SIGMA


@pytest.mark.parametrize("half_lengths", [(0.25, 0.25), (0.25, 2.0)])
def test_sections_are_averaged_by_what_their_sides_have_in_common(half_lengths):
    """Errors drawn with the stated covariance: what is stated of their mean is its scatter.

    The second side's slabs overlap; that says nothing about the points of the first one.
    """
    off, stated = [], []
    for seed in range(200):
        measured, edge = straight_sections(seed, half_lengths)
        after = smoothed(measured, edge, 0.5, closed=False, straight=True)
        away = np.einsum("mai,mi->ma", across_axes(measured.frames.normals), after.point)
        off.append(away[8:-8])
        stated.append(np.einsum("maa->ma", after.covariance)[8:-8])
    variance = np.mean(stated, axis=(0, 1))
    assert variance == pytest.approx(np.mean(np.square(off), axis=(0, 1)), rel=0.15)
    assert np.sqrt(variance[0]) < 0.35 * SIGMA


@pytest.mark.parametrize(("half_length", "straight"), [(0.25, True), (0.25, False), (2.0, True)])
def test_what_errs_by_itself_is_counted(half_length, straight):
    """Of a mean of k squared distances in two directions, the variance is 1 / k of its square."""
    means, counted = [], []
    for seed in range(300):
        measured, edge = straight_sections(seed, (half_length, half_length))
        after = smoothed(measured, edge, 0.5, closed=False, straight=straight)
        away = np.einsum("mai,mi->ma", across_axes(measured.frames.normals), after.point)
        square = np.einsum("ma,mab,mb->m", away, np.linalg.inv(after.covariance), away)
        means.append(square.mean())
        counted.append(after.independent)
    assert np.mean(counted) == pytest.approx(np.mean(means) ** 2 / np.var(means), rel=0.15)


@pytest.mark.parametrize("radius", [2.0, 5.0, 15.0])
def test_where_a_line_becomes_an_arc_the_error_is_no_larger_than_stated(radius):
    """A parabola comes close to both, and would be off by several of its sigmas between them."""
    in_sigmas = []
    for seed in range(40):
        measured, edge = straight_sections(seed)
        bent = np.maximum(edge.point[:, 0] - 10.0, 0.0) ** 2 / (2.0 * radius)
        edge.point[:, 1] += bent
        after = smoothed(measured, edge, 0.5, closed=False, straight=False)
        across = across_axes(measured.frames.normals)
        truth = measured.frames.origin + [0.0, 1.0, 0.0] * bent[:, None]
        away = np.einsum("mai,mi->ma", across, after.point - truth)[12:28]
        solved = np.linalg.solve(after.covariance[12:28], away[..., None])[..., 0]
        in_sigmas.append(np.sqrt(np.sum(away * solved, axis=1)))
    assert np.median(in_sigmas) < 1.5
    assert np.percentile(in_sigmas, 95) < 3.2


def straight_sections(seed=None, half_lengths=(0.25, 0.25)):
    """Sections on the x axis, 0.5 mm apart, scattered across it or not.

    The scatter is that of two sides whose slabs have these half lengths.
    """
    count, spacing = 41, 0.5
    one = np.ones((count, 1))
    sides = np.broadcast_to([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], (count, 2, 3))
    origin = np.column_stack([spacing * np.arange(count), np.zeros((count, 2))])
    frames = frames_from_sides(origin, one * [1.0, 0.0, 0.0], sides)
    scatter = np.zeros((count, 2))
    if seed is not None:
        rng = np.random.default_rng(seed)
        for side, half in enumerate(half_lengths):
            slab = np.ones(round(2.0 * half / spacing))
            slab *= SIGMA / np.linalg.norm(slab)
            scatter[:, side] = np.convolve(rng.normal(size=count + len(slab) - 1), slab, "valid")
    axes = across_axes(frames.normals)
    measured = SimpleNamespace(
        frames=frames,
        at=origin[:, 0],
        half_length=np.tile(half_lengths, (count, 1)),
        summed_over=(4, 8),
    )
    edge = SimpleNamespace(
        point=origin + np.einsum("ma,mai->mi", scatter, axes),
        covariance=np.broadcast_to(SIGMA**2 * np.eye(2), (count, 2, 2)),
        shared=np.zeros((count, 2, 2)),
        scatter=np.broadcast_to(SIGMA * np.eye(2), (count, 2, 2)),
    )
    return measured, edge


def test_curves_are_fitted_to_what_was_measured(wedge):
    part = wedge(90.0, noise=0.03)
    edge = scan_edge(part.cloud, part.at(0.1, 0.4))
    assert edge.curve().poles == pytest.approx(edge.unsmoothed.curve().poles, abs=1e-12)
    assert edge.unsmoothed.unsmoothed is edge.unsmoothed
    backward = edge.reversed()
    assert backward.unsmoothed.points == pytest.approx(edge.unsmoothed.points[::-1])


def test_where_a_line_becomes_an_arc_the_edge_is_not_cut_short():
    """A slot's end: half a circle of seven pitches between two straight pieces."""
    rng = np.random.default_rng(3)
    radius = 3.5
    x, y = rng.uniform([-14.0, -9.0], [9.0, 9.0], (6000, 2)).T
    away = np.where(x > 0.0, np.hypot(x, y), np.abs(y)) - radius
    floor = np.column_stack([x, y, np.zeros(len(x))])[away > 0.0]
    along, depth = rng.uniform([-14.0, -8.0], [14.0 + np.pi * radius, 0.0], (6000, 2)).T
    turn = np.clip(along, 0.0, np.pi * radius) / radius - np.pi / 2
    back = np.where(along < 0.0, along, np.minimum(np.pi * radius - along, 0.0))
    wall = np.column_stack([radius * np.cos(turn) + back, radius * np.sin(turn), depth])
    points = np.vstack([floor, wall[wall[:, 0] > -14.0]])
    cloud = PointCloud(points + rng.normal(0.0, 0.02, points.shape))
    edge = scan_edge(cloud, at=(radius, 0.0, 0.0), parameters=ScanParameters(edge_pitch=0.5))

    def off(points):
        x, y, z = points.T
        return np.hypot(np.where(x > 0.0, np.hypot(x, y), np.abs(y)) - radius, z)

    assert edge.points[:, 0].min() < -5.0
    assert root_mean_square(off(edge.points)) < 1.1 * root_mean_square(off(edge.unsmoothed.points))
    assert off(edge.points).max() < 0.1
