# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points as measurements of two sides and the rounding between them."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.scanning.rounded_rows import Rounded, equations, rows_of, solved
from freecad_edgescan.scanning.section import Frames, SectionPoints, frames_from_sides

REACH = 10.0


def wedge_frame(degrees: float) -> Frames:
    half = np.radians(degrees) / 2
    sides = [[0.0, np.sin(half), -np.cos(half)], [0.0, -np.sin(half), -np.cos(half)]]
    return frames_from_sides(np.zeros((1, 3)), np.array([[1.0, 0.0, 0.0]]), np.array([sides]))


def rounded_points(
    degrees: float, radius: float, rng: np.random.Generator, count: int = 400
) -> SectionPoints:
    """Exact points on both flat sides and on the rounding between them, mm."""
    half = np.radians(degrees) / 2
    touch = radius / np.tan(half)
    side, along = rng.integers(0, 2, count), rng.uniform(-1.0, 1.0, count)
    away, height = rng.uniform(touch, 9.0, count), np.zeros(count)
    turn = rng.uniform(0.0, np.pi / 2 - half, count)
    on_arc = rng.random(count) < 0.4
    # From where it touches a side, the rounding turns towards the edge.
    away = np.where(on_arc, touch - radius * np.sin(turn), away)
    height = np.where(on_arc, radius * (np.cos(turn) - 1.0), height)
    zero = np.zeros(count, dtype=np.int64)
    return SectionPoints(zero, zero, along, side, away, height)


@pytest.mark.parametrize("degrees", [40.0, 90.0, 150.0])
def test_exact_points_lie_on_the_exact_model(degrees: float) -> None:
    points = rounded_points(degrees, 1.5, np.random.default_rng(0))
    model = Rounded(np.zeros((1, 2, 4)), np.array([1.5 / REACH]))
    rows = rows_of(wedge_frame(degrees), model, points, REACH)
    assert rows.residual == pytest.approx(np.zeros(len(points.along)), abs=1e-9)
    assert rows.begins[0] == pytest.approx([1.5 / REACH / np.tan(np.radians(degrees) / 2)] * 2)
    assert np.array_equal(rows.on_arc, points.away < rows.begins[0, 0] * REACH - 1e-9)


@pytest.mark.parametrize("degrees", [60.0, 110.0])
def test_rows_are_the_derivatives_of_the_residuals(degrees: float) -> None:
    """Against differences of the residuals at models a little to both sides."""
    rng = np.random.default_rng(1)
    frame, points = wedge_frame(degrees), rounded_points(degrees, 2.0, rng)
    base = rng.normal(size=9) * np.append(np.tile([0.01, 0.02, 0.1, 0.01], 2), 0.0)
    base[-1] = 2.0 / REACH

    def residual(unknown: np.ndarray) -> np.ndarray:
        model = Rounded(unknown[None, :8].reshape(1, 2, 4), unknown[8:])
        return rows_of(frame, model, points, REACH).residual

    at = Rounded(base[None, :8].reshape(1, 2, 4), base[8:])
    rows = rows_of(frame, at, points, REACH)
    # One point at a time: the right side of its equations is its row times what it measures.
    for k in rng.choice(len(points.along), 40, replace=False):
        alone = (np.arange(len(points.along)) == k).astype(float)
        normal, right = equations(rows.summed(points, REACH, alone))
        unknown = np.append(base[:8], 0.0)
        # Row r: residual(base + d) = residual(base) − r·d.
        row = np.sqrt(np.diag(normal[0]))
        slopes = np.array(
            [
                (residual(base + step)[k] - residual(base - step)[k]) / 2e-5
                for step in 1e-5 * np.eye(9)
            ]
        )
        # The drift of the sides bends the rounding's cone a little, which the rows leave out.
        assert np.abs(slopes) == pytest.approx(row, abs=2e-2)
        gap = right[0] - normal[0] @ unknown
        assert gap == pytest.approx(-slopes * residual(base)[k], abs=2e-2)


def test_the_radius_and_the_sides_are_found_from_exact_points() -> None:
    frame, points = wedge_frame(100.0), rounded_points(100.0, 2.0, np.random.default_rng(2))
    model = Rounded(np.array([[[0.02, 0.05, 0.0, 0.0], [-0.01, -0.03, 0.0, 0.0]]]), np.array([0.1]))
    for _ in range(8):
        rows = rows_of(frame, model, points, REACH)
        summed = rows.summed(points, REACH, np.full(len(points.along), 1e6))
        unknown, _ = solved(summed, np.zeros((1, 9)), np.zeros((1, 9, 9)))
        model = Rounded(unknown[:, :8].reshape(1, 2, 4), model.radius + unknown[:, 8])
    assert model.radius[0] * REACH == pytest.approx(2.0, abs=1e-6)
    assert model.coefficients == pytest.approx(np.zeros((1, 2, 4)), abs=1e-6)
