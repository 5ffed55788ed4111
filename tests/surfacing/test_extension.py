# SPDX-License-Identifier: LGPL-2.1-or-later
"""Extensions of surfaces: the same tangent plane on both sides, and ruled beyond."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.geometry import Circle
from freecad_edgescan.geometry.exact_surfaces import circular_arc, extruded_surface

SIDES = ["u0", "u1", "v0", "v1"]


def rational_surface(seed=5):
    rng = np.random.default_rng(seed)
    u, v = np.meshgrid(np.linspace(0, 40, 7), np.linspace(0, 25, 6), indexing="ij")
    poles = np.stack([u, v, 4 * np.sin(u / 9) * np.cos(v / 8)], axis=-1)
    poles += rng.normal(size=poles.shape)
    knots = np.r_[[0.0] * 4, 0.3, 0.4, 0.9, [2.0] * 4], np.r_[[-1.0] * 3, 0, 1, 1.5, [2.0] * 3]
    return es.BSplineSurface(poles, knots, (3, 2), rng.uniform(0.5, 2, (7, 6)))


def both_sides(surface, longer, side, share):
    """Derivatives across the side, on the surface's side and on the extension's."""
    axis = "uv".index(side[0])
    at = surface.parameter_range[axis][int(side[1])]
    first, last = surface.parameter_range[1 - axis]
    along = first + share * (last - first)
    pair = longer.split(axis, at)
    order = (1, 0) if axis == 0 else (0, 1)
    at_side = (at, along) if axis == 0 else (along, at)
    values = [part.derivative(*at_side, *order) for part in pair]
    return values if side[1] == "1" else values[::-1]


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("tau", [None, 30.0])
def test_the_surface_stays_and_its_first_derivative_goes_on(side, tau):
    surface = rational_surface()
    longer = es.extend_surface(surface, side, 0.4, tau)
    limits = surface.parameter_range
    u, v = (np.linspace(*own, 13) for own in limits)
    grid = u[:, None], v
    assert np.allclose(longer.evaluate(*grid), surface.evaluate(*grid), atol=1e-12)
    axis = "uv".index(side[0])
    first, last = limits[axis]
    expected = (
        (first - 0.4 * (last - first), last)
        if side[1] == "0"
        else (first, last + 0.4 * (last - first))
    )
    assert np.allclose(longer.parameter_range[axis], expected)
    inner, outer = both_sides(surface, longer, side, np.linspace(0.05, 0.95, 9))
    assert np.allclose(inner, outer, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("side", SIDES)
def test_poles_beyond_the_side_go_on_in_equal_steps(side):
    longer = es.extend_surface(rational_surface(), side)
    axis = "uv".index(side[0])
    p = longer.degree[axis]
    poles = np.moveaxis(longer.poles, axis, 0)
    beyond = poles[: p + 1] if side[1] == "0" else poles[-p - 1 :]
    steps = np.diff(beyond, axis=0)
    assert np.allclose(steps, steps[:1], atol=1e-12) and np.linalg.norm(steps) > 1


def test_a_surface_without_weights_gets_none_and_grows_by_the_ratio():
    knots = np.array([0.0, 0, 0, 1, 1, 1])
    x = np.array([0.0, 5, 10])
    grid = np.stack(np.broadcast_arrays(x[:, None], x, 0.0), axis=-1)
    longer = es.extend_surface(es.BSplineSurface(grid, (knots, knots), (2, 2)), "u1", 0.3)
    assert longer.weights is None
    assert longer.evaluate(1.3, 0.5) == pytest.approx([13, 5, 0])


def test_a_cylinder_is_extended_in_its_end_tangent():
    arc = circular_arc(Circle(np.zeros(3), np.eye(3)[2], 5.0, np.eye(3)[0]), 0.0, np.pi / 2)
    longer = es.extend_surface(extruded_surface(arc, [0, 0, 4]), "u1", 0.5)
    x = longer.evaluate(np.linspace(np.pi / 2, longer.parameter_range[0][1], 5), 0.5)
    assert np.allclose(x[:, 1], 5) and np.all(np.diff(x[:, 0]) < 0)


def test_what_cannot_be_extended_is_refused_with_a_sentence():
    surface = rational_surface()
    with pytest.raises(ValueError, match="no side 'w0'; choose u0, u1, v0 or v1"):
        es.extend_surface(surface, "w0")
    with pytest.raises(ValueError, match="ratio of the extension is 0"):
        es.extend_surface(surface, "u0", 0)
    with pytest.raises(ValueError, match="take τ above"):
        es.extend_surface(surface, "u0", 0.25, tau=-1000)
    circle = circular_arc(Circle(np.zeros(3), np.eye(3)[2], 5.0, np.eye(3)[0]))
    with pytest.raises(ValueError, match="closed in u"):
        es.extend_surface(extruded_surface(circle, [0, 0, 4]), "u0")
