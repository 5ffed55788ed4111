# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves rewritten without changing a point, and averaged knots by hand."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import BSplineCurve, Circle, compatible_curves
from freecad_edgescan.geometry.exact_surfaces import circular_arc
from freecad_edgescan.geometry.knot_vectors import averaged_knots, greville, merged_knots


def any_curve(periodic=False, rational=False, seed=2):
    rng = np.random.default_rng(seed)
    poles = np.cumsum(rng.normal(size=(9, 3)) * 4, axis=0)
    weights = rng.uniform(0.5, 2, 9) if rational else None
    if periodic:
        knots = np.cumsum(rng.uniform(0.5, 2, 10))
        return BSplineCurve.from_distinct_knots(poles, knots, [1] * 10, 3, True, weights)
    knots = np.r_[[0.0] * 4, np.cumsum(rng.uniform(0.5, 2, 5)), [12.0] * 4]
    return BSplineCurve(poles, knots, 3, False, weights)


@pytest.mark.parametrize("periodic", [False, True])
@pytest.mark.parametrize("rational", [False, True])
def test_no_form_of_a_curve_moves_its_points(periodic, rational):
    curve = any_curve(periodic, rational)
    first, last = curve.parameter_range
    u = np.linspace(first, last, 101)
    exact = curve.evaluate(u)
    for same in (
        curve.opened(),
        curve.refined([first + 0.1, (first + last) / 2, (first + last) / 2]),
        curve.elevated(6),
    ):
        assert not same.periodic
        assert np.allclose(same.evaluate(u), exact, atol=1e-11)
    scaled = curve.over_range(-1.0, 1.0)
    assert np.allclose(scaled.evaluate(-1 + 2 * (u - first) / (last - first)), exact)
    part = curve.restricted(first + 1.0, last - 2.0)
    inside = np.linspace(first + 1.0, last - 2.0, 50)
    assert np.allclose(part.evaluate(inside), curve.evaluate(inside), atol=1e-12)


def test_compatible_curves_have_one_knot_vector_and_their_own_points():
    arc = circular_arc(Circle(np.zeros(3), np.array([0, 0, 1.0]), 5.0, np.array([1.0, 0, 0])))
    curves = (
        any_curve(),
        arc,
        any_curve(periodic=True),
        BSplineCurve(np.eye(3)[:2], [0, 0, 2, 2], 1),
    )
    same = compatible_curves(curves)
    share = np.linspace(0, 1, 60)
    for before, after in zip(curves, same, strict=True):
        first, last = before.parameter_range
        assert np.allclose(after.evaluate(share), before.evaluate(first + share * (last - first)))
        assert np.array_equal(after.knots, same[0].knots) and after.degree == 3
        assert after.weights is not None


def test_knots_that_differ_by_rounding_are_one_knot():
    ends = [0.0] * 3, [1.0] * 3
    one = np.r_[ends[0], 0.1 + 0.2, 0.7, 0.7, ends[1]]
    other = np.r_[ends[0], 0.3, 0.5, 0.7, ends[1]]
    assert np.allclose(merged_knots([one, other], 2), np.r_[ends[0], 0.3, 0.5, 0.7, 0.7, ends[1]])


def test_averaged_knots_are_those_of_the_nurbs_book():
    # 9.68: d = 10/4, i = int(j d), a = j d - i; 9.69: u = (1 - a) t[i - 1] + a t[i]
    t = np.array([0, 1, 3, 4, 6, 7, 8, 9, 11, 12.0])
    inner = averaged_knots(t, 7, 3, (0, 12))[4:-4]
    assert np.allclose(inner, [0.5 * 1 + 0.5 * 3, t[4], 0.5 * t[6] + 0.5 * t[7]])


def test_the_spline_of_grevilles_abscissae_is_the_straight_line():
    curve = any_curve()
    at = greville(curve.knots, 3)
    line = BSplineCurve(np.outer(at, [1.0, 0, 0]), curve.knots, 3)
    u = np.linspace(0, 12, 30)
    assert np.allclose(line.evaluate(u)[:, 0], u)


def test_wrong_parts_and_degrees_are_refused_with_numbers():
    curve = any_curve()
    with pytest.raises(ValueError, match="from 5 to 4"):
        curve.restricted(5, 4)
    with pytest.raises(ValueError, match="A knot at 12 cannot"):
        curve.refined([12])
    with pytest.raises(ValueError, match="degree 3 cannot be written with degree 2"):
        curve.elevated(2)
    with pytest.raises(ValueError, match="give first < last"):
        curve.over_range(1, 1)
    with pytest.raises(ValueError, match="no curve"):
        compatible_curves([])
