# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error model, against dense points fitted and intersected by other means, and simulation."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import fsolve

from freecad_edgescan.scanning.error_model import (
    gap_to_edge,
    largest_deviation,
    model_error,
    noise_error,
    rounding_half_angle,
)

ANGLE = np.radians(110.0)
OBJECTS = (  # R, θ, R_f, R_p
    (50.0, ANGLE, 1.0, 1.0),
    (20.0, np.radians(90.0), 0.0, 0.5),
    (15.0, np.radians(140.0), 3.0, 2.5),
    (-40.0, np.radians(120.0), 2.0, 1.0),
    (30.0, np.radians(100.0), 1.5, -1.5),  # a ball that fills an inner corner
)


class Section:
    """The section across an edge at the origin, y the line of symmetry, material below.

    Side 0 goes to the right. Built from circles alone, without an equation of the source.
    """

    def __init__(self, radius: float, angle: float, fillet: float, probe: float) -> None:
        way = np.array([np.sin(0.5 * angle), -np.cos(0.5 * angle)])  # along side 0, away
        outward = np.array([-way[1], way[0]])  # into the air
        self.radius, self.probe = radius, probe
        self.centre = radius * outward
        self.edge_angle = np.arctan2(*-outward[::-1])
        # the rounding's centre lies on the line of symmetry, R + R_f from the surface's centre
        height = self.centre[1]
        reach = np.sqrt((radius + fillet) ** 2 - self.centre[0] ** 2)
        below = height - np.sign(radius) * reach
        to_rounding = np.array([0.0, below]) - self.centre
        to_rounding *= np.sign(radius) * np.sign(radius + fillet)
        self.begin = np.arctan2(to_rounding[1], to_rounding[0])
        if radius < 0:
            self.begin += np.pi
        self.turn = 1.0 if radius > 0 else -1.0

    def points(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Probe centres at arc lengths s from the rounding, and normals into the air."""
        r = self.radius - self.probe
        angle = self.begin + s / r
        out = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        return self.centre + r * out, -out


def intersection(points: np.ndarray, s: np.ndarray, degree: int, probe: float) -> np.ndarray:
    """Where the fitted curve, offset by the probe radius, meets its mirror image."""
    basis = np.vander(s, degree + 1)
    parts = np.linalg.lstsq(basis, points, rcond=None)[0]

    def offset(u: float) -> np.ndarray:
        x, y = (np.poly1d(parts[:, k]) for k in range(2))
        slope = np.array([x.deriv()(u), y.deriv()(u)])
        return np.array([x(u), y(u)]) + probe * np.array([slope[1], -slope[0]]) / np.hypot(*slope)

    def gap(pair: np.ndarray) -> np.ndarray:
        return offset(pair[0]) - offset(pair[1]) * [-1.0, 1.0]

    return offset(fsolve(gap, [-0.3, -0.3], xtol=1e-10)[0])


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("shape", OBJECTS)
def test_model_error_is_that_of_dense_points_without_noise(
    degree: int, shape: tuple[float, float, float, float]
) -> None:
    section = Section(*shape)
    lengths = np.array([2.0, 5.0, 9.0])
    expected = []
    for length in lengths:
        s = (np.arange(4000) + 0.5) / 4000 * length
        found = intersection(section.points(s)[0], s, degree, shape[3])
        expected.append(np.linalg.norm(found))
    assert model_error(degree, lengths, *shape) == pytest.approx(expected, rel=1e-4, abs=1e-8)


def test_the_rounding_is_tangent_to_both_surfaces() -> None:
    """Half its arc is the turn from the line of symmetry to where the surface begins."""
    radius, angle, fillet, probe = OBJECTS[0]
    section = Section(radius, angle, fillet, probe)
    _, normal = section.points(np.zeros(1))
    half = np.arctan2(normal[0, 0], normal[0, 1])
    assert rounding_half_angle(radius, angle, fillet) == pytest.approx(half)
    away = (radius - probe) * (section.begin - section.edge_angle)
    assert gap_to_edge(radius, angle, fillet, probe) == pytest.approx(away)


def test_planes_have_no_model_error_and_a_known_rounding() -> None:
    assert model_error(2, 5.0, np.inf, ANGLE, 1.0, 1.0) == 0.0
    assert model_error(1, 5.0, 1e6, ANGLE, 1.0, 1.0) < 1e-4
    assert rounding_half_angle(np.inf, ANGLE, 3.0) == pytest.approx(0.5 * (np.pi - ANGLE))
    assert gap_to_edge(np.inf, ANGLE, 3.0) == pytest.approx(3.0 * np.tan(0.5 * (np.pi - ANGLE)))
    assert gap_to_edge(1e6, ANGLE, 3.0) == pytest.approx(gap_to_edge(np.inf, ANGLE, 3.0), rel=1e-4)


@pytest.mark.parametrize("degree", [1, 2])
def test_largest_deviation_is_the_largest(degree: int) -> None:
    shares = np.array([0.2, 0.5, 1.0])
    for share, largest in zip(shares, largest_deviation(degree, shares), strict=True):
        u = np.linspace(0.0, share, 2001)
        arc = np.stack([np.cos(u), np.sin(u)], axis=1)
        middle = (np.arange(4000) + 0.5) / 4000 * share
        dense = np.stack([np.cos(middle), np.sin(middle)], axis=1)
        basis = np.vander(middle, degree + 1)
        fitted = np.vander(u, degree + 1) @ np.linalg.lstsq(basis, dense, rcond=None)[0]
        assert largest == pytest.approx(np.linalg.norm(arc - fitted, axis=1).max(), rel=1e-4)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("shape", [OBJECTS[0], OBJECTS[2]])
def test_noise_error_is_the_scatter_of_simulated_edge_points(
    degree: int, shape: tuple[float, float, float, float]
) -> None:
    """Both sides scatter; each is fitted by itself and offset, and the curves intersected."""
    radius, angle, fillet, probe = shape
    count, length, noise = 9, 6.0, 0.002
    section = Section(*shape)
    rng = np.random.default_rng(5)
    s = np.linspace(0.0, length, count)
    centres, normals = section.points(s)
    basis = np.linalg.pinv(np.vander(s, degree + 1))
    trials = 4000
    off = noise * rng.standard_normal((trials, 2, count, 1))
    parts = basis @ (centres + off * normals)  # both sides seen from the right
    u = np.full((trials, 2), -gap_to_edge(*shape))
    for _ in range(12):
        point, slope = offset_curve(parts, u, probe)
        mirror = np.array([-1.0, 1.0])
        gap = point[:, 0] - point[:, 1] * mirror
        steps = np.stack([slope[:, 0], -slope[:, 1] * mirror], axis=-1)
        u = u - np.linalg.solve(steps, gap[..., None])[..., 0]
    found = offset_curve(parts, u, probe)[0][:, 0]
    scatter = np.sqrt(found.var(axis=0).sum())
    stated = noise_error(degree, count, length, radius, angle, fillet, probe, noise)
    assert stated == pytest.approx(scatter, rel=0.05)


def offset_curve(parts: np.ndarray, u: np.ndarray, probe: float) -> tuple[np.ndarray, np.ndarray]:
    """Points and derivatives of offset curves; parts (..., degree + 1, 2), highest power first."""

    def value(at: np.ndarray) -> np.ndarray:
        degree = parts.shape[-2] - 1
        powers = at[..., None] ** np.arange(degree, -1, -1)
        point = np.einsum("...k,...ki->...i", powers, parts)
        factors = np.arange(degree, 0, -1)
        slope = np.einsum("...k,...ki->...i", factors * powers[..., 1:], parts[..., :-1, :])
        right = np.stack([slope[..., 1], -slope[..., 0]], axis=-1)
        return point + probe * right / np.linalg.norm(slope, axis=-1, keepdims=True)

    return value(u), (value(u + 1e-5) - value(u - 1e-5)) / 2e-5


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: model_error(4, 1.0, 50.0, ANGLE), "degree is 4"),
        (lambda: model_error(2, 0.0, 50.0, ANGLE), "positive"),
        (lambda: model_error(2, 1.0, 50.0, 3.5), "between 0 and pi"),
        (lambda: model_error(2, 1.0, 2.0, ANGLE, 0.0, 2.0), "does not fit into a hollow"),
        (lambda: rounding_half_angle(-3.0, ANGLE, 4.0), "does not fit between"),
        (lambda: noise_error(2, 2, 1.0, 50.0, ANGLE), "needs 3 points and has 2"),
    ],
)
def test_what_the_model_is_not_made_for_is_said(call: object, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call()  # type: ignore[operator]
