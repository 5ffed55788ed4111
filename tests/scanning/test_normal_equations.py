# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sums of points in blocks, and their solution, against the sums and LAPACK's solution."""

import numpy as np
import pytest

from freecad_edgescan.scanning.normal_equations import (
    BLOCK_EDGES,
    BLOCKS,
    PRIOR_SIGMA,
    block_counts,
    block_moments,
    solve,
    square_forms,
    sum_stretches,
    sums_of_terms,
    without_crowds,
)
from freecad_edgescan.scanning.section import SectionPoints

REACH = 12.0


def side_points(shape, noise=0.0, count=600, reach=REACH):
    """Both sides of one section with the same shape: height(away, along)."""
    rng = np.random.default_rng(5)
    n = 2 * count
    away, along = rng.uniform(0, reach, n), rng.uniform(-1.5, 1.5, n)
    height = shape(away, along) + noise * rng.normal(size=n)
    zero = np.zeros(n, dtype=int)
    return SectionPoints(np.arange(n), zero, along, np.repeat([0, 1], count), away, height)


def test_normal_equations_are_the_sums_over_each_blocks_points():
    points = side_points(lambda s, u: 0.1 * s, 0.1)
    moments = block_moments(points, 1, REACH)
    s, n, u = points.away / REACH, points.height / REACH, points.along / REACH
    for block in (0, 3, BLOCKS - 1):
        mine = (points.side == 1) & (s >= BLOCK_EDGES[block]) & (s < BLOCK_EDGES[block + 1])
        rows = np.column_stack([np.ones_like(s), s, (s**2 + n**2) / 2, u, n])[mine]
        whole = (rows.T @ rows)[np.triu_indices(5)]
        assert moments[0, 1, block] == pytest.approx(whole, rel=1e-9, abs=1e-12)
        assert block_counts(points, 1, REACH)[0, 1, block] == mine.sum()


def test_points_outside_the_reach_are_in_no_block():
    points = side_points(lambda s, u: 0.0 * s, reach=2 * REACH)
    inside = np.count_nonzero(points.away < REACH)
    assert block_counts(points, 1, REACH).sum() == inside
    assert block_moments(points, 1, REACH)[..., 0].sum() == pytest.approx(inside)


def test_the_sum_over_a_stretch_is_the_sum_of_its_blocks():
    moments = block_moments(side_points(lambda s, u: 0.02 * s**2, 0.1), 1, REACH)
    summed = sum_stretches(moments, np.array([[[2, 5], [0, BLOCKS]]]))
    assert summed[0, 0] == pytest.approx(moments[0, 0, 2:5].sum(axis=0))
    assert summed[0, 1] == pytest.approx(moments[0, 1].sum(axis=0))


def test_a_crowd_of_points_has_no_more_say_than_its_area():
    """A thousand points in one block count as two of the pitch's own."""
    even = side_points(lambda s, u: 0.0 * s, count=400)
    pitch = np.sqrt(REACH * 3.0 / 400)
    moments = block_moments(even, 1, REACH)
    crowded = moments.copy()
    crowded[0, 0, 3] *= 50.0
    evened = without_crowds(crowded, REACH, 1.5, pitch)
    expected = REACH * np.diff(BLOCK_EDGES)[3] * 3.0 / pitch**2
    assert evened[0, 0, 3, 0] == pytest.approx(2 * expected)
    assert evened[0, 1] == pytest.approx(moments[0, 1], rel=0.35)


@pytest.mark.parametrize("narrow", [1.0, 0.05])
def test_solutions_are_those_of_lapack_with_the_prior(narrow):
    """Also where a side is so narrow that only the prior tells slope from curvature."""
    points = side_points(lambda s, u: 0.1 * s - 0.07 * u, 0.1)
    points = points[points.away < narrow * REACH]
    summed = block_moments(points, 1, REACH).sum(axis=2)
    variance, expected, sigma = (0.1 / REACH) ** 2, 0.2, 0.3
    seen = solve(summed, np.full((1, 2), variance), np.full((1, 2), expected), sigma)
    s, n, u = points.away / REACH, points.height / REACH, points.along / REACH
    prior = np.diag(variance / np.array([*PRIOR_SIGMA[:2], sigma, PRIOR_SIGMA[3]]) ** 2)
    for k in range(2):
        mine = points.side == k
        rows = np.column_stack([np.ones_like(s), s, (s**2 + n**2) / 2, u])[mine]
        inverse = np.linalg.inv(rows.T @ rows + prior)
        wanted = inverse @ (rows.T @ n[mine] + prior @ [0.0, 0.0, expected, 0.0])
        coefficients, found, misfit, count = (array[0, k] for array in seen)
        assert found == pytest.approx(inverse, rel=1e-6)
        assert coefficients == pytest.approx(wanted, rel=1e-6)
        # Of the points alone: how far the prior is off is no scatter of theirs.
        assert misfit == pytest.approx(np.sum((n[mine] - rows @ wanted) ** 2), rel=1e-6)
        assert count == mine.sum()


def test_square_forms_are_products_with_each_vector():
    rng = np.random.default_rng(3)
    half, vectors = rng.normal(size=(2, 5, 4, 4)), rng.normal(size=(2, 7, 4))
    matrices = half @ np.swapaxes(half, -1, -2)
    wanted = np.einsum("mbi,mkij,mbj->mbk", vectors, matrices, vectors)
    assert square_forms(matrices, vectors) == pytest.approx(wanted)


def test_sums_of_terms_begin_with_the_number_of_points():
    points = side_points(lambda s, u: 0.1 * s)
    sums = sums_of_terms(block_moments(points, 1, REACH)).sum(axis=2)
    assert sums[0, 0, 0] == np.count_nonzero(points.side == 0)
    assert sums[0, 1, 1] == pytest.approx(points.away[points.side == 1].sum() / REACH)
