# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our B-spline surfaces and OpenCASCADE's give the same numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

import freecad_edgescan as es  # noqa: E402


def any_surface(rational: bool) -> es.BSplineSurface:
    rng = np.random.default_rng(8)
    u, v = np.meshgrid(np.linspace(0, 60, 9), np.linspace(0, 40, 7), indexing="ij")
    poles = np.stack([u, v, 6 * np.sin(u / 12) * np.cos(v / 10)], axis=-1)
    poles += rng.normal(size=poles.shape)
    knots = (
        np.r_[[0.0] * 4, 0.2, 0.5, 0.5, 0.6, 0.9, [1.0] * 4],
        np.r_[[2.0] * 3, 3, 4, 4.5, 6, [7] * 3],
    )
    weights = rng.uniform(0.6, 1.5, (9, 7)) if rational else None
    return es.BSplineSurface(poles, knots, (3, 2), weights)


def native(surface: es.BSplineSurface) -> Any:
    (u, count_u), (v, count_v) = surface.distinct_knots_and_multiplicities()
    weights = np.ones(surface.poles.shape[:2]) if surface.weights is None else surface.weights
    made = Part.BSplineSurface()
    made.buildFromPolesMultsKnots(
        [[FreeCAD.Vector(*pole) for pole in row] for row in surface.poles],
        count_u.tolist(),
        count_v.tolist(),
        u.tolist(),
        v.tolist(),
        False,
        False,
        *surface.degree,
        weights.tolist(),
    )
    return made


@pytest.mark.parametrize("rational", [False, True])
def test_points_and_derivatives_are_opencascades(rational: bool) -> None:
    surface = any_surface(rational)
    other = native(surface)
    u = np.random.default_rng(0).uniform(0, 1, 100)
    v = np.random.default_rng(1).uniform(2, 7, 100)
    exact = np.array([other.value(*at) for at in zip(u, v, strict=True)])
    assert np.allclose(surface.evaluate(u, v), exact, atol=1e-11)
    for order in ((1, 0), (0, 1), (1, 1), (2, 0), (0, 2)):
        exact = np.array([other.getDN(*at, *order) for at in zip(u, v, strict=True)])
        assert np.allclose(surface.derivative(u, v, *order), exact, rtol=1e-9, atol=1e-8)


@pytest.mark.parametrize("rational", [False, True])
def test_no_foot_of_opencascades_is_nearer(rational: bool) -> None:
    surface = any_surface(rational)
    other = native(surface)
    rng = np.random.default_rng(2)
    points = surface.evaluate(rng.random(60), rng.uniform(2, 7, 60)) + rng.normal(size=(60, 3))
    theirs = [
        np.linalg.norm(np.array(other.value(*other.parameter(FreeCAD.Vector(*point)))) - point)
        for point in points
    ]
    ours = surface.closest(points)[2]
    # theirs may lie a trifle beyond the rim
    assert np.all(ours <= np.array(theirs) + 1e-6)


@pytest.mark.parametrize("rational", [False, True])
def test_changes_of_form_are_opencascades(rational: bool) -> None:
    surface = any_surface(rational)
    other = native(surface)
    other.insertUKnot(0.3, 1, 1e-9)
    other.increaseDegree(4, 3)
    ours = surface.refined(u=[0.3]).elevated((4, 3))
    assert np.allclose(np.array(other.getPoles()), ours.poles, atol=1e-10)
    assert np.allclose(np.repeat(other.getUKnots(), other.getUMultiplicities()), ours.knots[0])
