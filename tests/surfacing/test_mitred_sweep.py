# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mitred sweeps as numbers: rims are shared, and tubes keep their radius."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline

from freecad_edgescan.geometry import BSplineCurve
from freecad_edgescan.surfacing.mitred_sweep import mitred_sweep


def line(start: np.ndarray, end: np.ndarray) -> BSplineCurve:
    return BSplineCurve(np.array([start, end]), np.array([0.0, 0.0, 1.0, 1.0]), 1)


def chain(corners: np.ndarray) -> list[BSplineCurve]:
    return [line(*pair) for pair in pairwise(corners)]


def quarter(at: np.ndarray, one: np.ndarray, other: np.ndarray) -> BSplineCurve:
    """A quarter of a circle about a place, from one radius to another."""
    poles = at + np.array([one, one + other, other])
    knots = np.array([0.0, 0.0, 0.0, 1.0, 1.0, 1.0])
    return BSplineCurve(poles, knots, 2, weights=np.array([1.0, np.sqrt(0.5), 1.0]))


def test_neighbours_share_their_rim_in_the_plane_that_halves_the_corner() -> None:
    corners = np.array([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [13.0, 8.0, 2.0], [6.0, 12.0, 9.0]])
    across = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    swept = mitred_sweep([quarter(corners[0], *across)], chain(corners))
    tangents = np.diff(corners, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    for k, ((before,), (after,)) in enumerate(pairwise(swept.surfaces)):
        rim = before.curve_at(v=1.0)
        np.testing.assert_allclose(rim.poles, after.curve_at(v=0.0).poles, atol=1e-12)
        halving = tangents[k] + tangents[k + 1]
        np.testing.assert_allclose((rim.poles - corners[k + 1]) @ halving, 0.0, atol=1e-12)
    for (surface,), start, tangent in zip(swept.surfaces, corners[:-1], tangents, strict=True):
        u, v = (grid.ravel() for grid in np.meshgrid(*2 * [np.linspace(0.0, 1.0, 20)]))
        away = np.cross(surface.evaluate(u, v) - start, tangent)
        np.testing.assert_allclose(np.linalg.norm(away, axis=1), 1.0, atol=1e-12)


def test_a_tube_along_a_spline_in_space_keeps_its_radius() -> None:
    angle = np.linspace(0.0, 4.0, 12)
    places = np.column_stack([5 * np.cos(angle), 4 * np.sin(angle), angle + np.sin(3 * angle)])
    spline = make_interp_spline(angle, places, k=3)
    rail = BSplineCurve(spline.c, spline.t, 3)
    radius = 0.3
    second = np.cross(rail.tangent(0.0), [0.0, 0.0, 1.0])
    second *= radius / np.linalg.norm(second)
    third = np.cross(rail.tangent(0.0), second)
    ((surface,),) = mitred_sweep([quarter(places[0], second, third)], [rail]).surfaces
    u, v = (grid.ravel() for grid in np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 500)))
    away = rail.closest(surface.evaluate(u, v))[1]
    assert np.abs(away - radius).max() < 1e-4


WIDE = (quarter(np.zeros(3), np.array([0.0, 3.0, 0.0]), np.array([0.0, 0.0, 3.0])),)


def test_a_short_piece_between_turns_to_and_fro_has_room_for_a_wide_profile() -> None:
    corners = np.array([[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [9.0, 2.0, 0.0], [18.0, 2.0, 0.0]])
    swept = mitred_sweep(WIDE, chain(corners))
    assert len(swept.surfaces) == 3
    np.testing.assert_allclose(swept.last[0].poles, WIDE[0].poles + corners[3], atol=1e-12)


@pytest.mark.parametrize(
    ("corners", "sentence"),
    [
        ([[0, 0, 0], [9, 0, 0], [9, 2, 0], [0, 2, 0]], "too wide for the rail"),
        ([[0, 0, 0], [9, 0, 0], [0, 1, 0]], "turns by 174°"),
    ],
)
def test_what_has_no_room_is_said(corners: list[list[float]], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        mitred_sweep(WIDE, chain(np.array(corners, dtype=float)))
