# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from scipy.optimize import fsolve
from scipy.spatial.transform import Rotation

from freecad_edgescan.scanning.corner import across_axes, corners, largest_sigma
from freecad_edgescan.scanning.normal_equations import BLOCKS
from freecad_edgescan.scanning.section import frames_from_sides
from freecad_edgescan.scanning.side_fit import SideFits

REACH = 7.0


def exact_fits(coefficients, variance=1e-6, inverse=None, expectation=0.0):
    """Fits as if the sides were known: coefficients (2, 4) in mm, 1, 1/mm, 1."""
    c = np.asarray(coefficients, dtype=float) * [1 / REACH, 1.0, REACH, 1.0]
    inverse = np.eye(4) if inverse is None else inverse
    return SideFits(
        REACH,
        c[None],
        np.broadcast_to(inverse, (1, 2, 4, 4)),
        np.full((1, 2), variance),
        np.full((1, 2), 100.0),
        np.array([[[0, BLOCKS]] * 2]),
        np.ones((1, 2), dtype=bool),
        np.zeros((1, 2)),
        np.broadcast_to(expectation, (1, 2)),
    )


def wedge_frame(degrees, seed=0, tilt=0.0, moved=0.0):
    """A true wedge, and a section that stands on it a little wrongly turned and moved."""
    half = np.radians(degrees) / 2
    sides = np.array([[0, s * np.sin(half), -np.cos(half)] for s in (1, -1)])
    outward = np.array([[0, s * np.cos(half), np.sin(half)] for s in (1, -1)])
    rng = np.random.default_rng(seed)
    place = Rotation.random(random_state=seed)
    wrong = Rotation.from_rotvec(tilt * rng.normal(size=3))
    origin = place.apply([0.0, *(moved * rng.normal(size=2))])
    frame = frames_from_sides(
        origin[None],
        (place * wrong).apply([[1.0, 0, 0]]),
        (place * wrong).apply(sides)[None],
    )
    return frame, place.apply([1.0, 0, 0]), place.apply(outward)


def planes_in(frame, outward):
    """Coefficients of planes through the zero of space with given normals, in the section."""
    rows = []
    for k in range(2):
        facing = outward[k] @ frame.normals[0, k]
        rows.append(
            [
                -(outward[k] @ frame.origin[0]) / facing,
                -(outward[k] @ frame.sides[0, k]) / facing,
                0.0,
                -(outward[k] @ frame.tangent[0]) / facing,
            ]
        )
    return rows


@pytest.mark.parametrize("degrees", [30, 90, 150, 170])
@pytest.mark.parametrize("offset", [0.0, 0.8, -0.8])
def test_planes_moved_by_the_probe_meet_where_planes_do(degrees, offset):
    """Also when the section does not stand square on the edge: slopes along it are in the sum."""
    for seed in range(5):
        frame, along, outward = wedge_frame(degrees, seed, tilt=0.05, moved=0.3)
        found = corners(frame, exact_fits(planes_in(frame, outward)), offset)
        # The moved planes' line, cut by the plane of the section.
        matrix = np.array([*outward, frame.tangent[0]])
        wanted = np.linalg.solve(matrix, [offset, offset, frame.tangent[0] @ frame.origin[0]])
        assert found.found.all()
        assert found.point[0] == pytest.approx(wanted, abs=1e-8)
        assert np.abs(found.tangent[0] @ along) == pytest.approx(1.0, abs=1e-12)
        assert found.tangent[0] @ frame.tangent[0] > 0
        assert found.normals[0] == pytest.approx(outward, abs=1e-9)
        assert np.arccos(found.sides[0, 0] @ found.sides[0, 1]) == pytest.approx(
            np.radians(degrees), abs=1e-7
        )


def circles_in(frame, centres, radii):
    """Coefficients of circles about centres (2, 3) in the section's plane."""
    rows = []
    for k in range(2):
        offset = centres[k] - frame.origin[0]
        s0, n0 = offset @ frame.sides[0, k], offset @ frame.normals[0, k]
        rows.append([(s0**2 + n0**2 - radii[k] ** 2) / (2 * n0), -s0 / n0, 1 / n0, 0.0])
    return rows


@pytest.mark.parametrize("bends", [(1, 1), (-1, -1), (1, -1)], ids=["hollow", "bulging", "both"])
@pytest.mark.parametrize("offset", [0.0, 0.8, -0.8])
@pytest.mark.parametrize("degrees", [60, 120])
def test_circles_moved_by_the_probe_meet_where_circles_do(bends, offset, degrees):
    frame, _, outward = wedge_frame(degrees)
    centres = np.array([bend * r * n for bend, r, n in zip(bends, (9, 14), outward, strict=True)])
    fits = exact_fits(circles_in(frame, centres, (9.0, 14.0)))
    found = corners(frame, fits, offset)
    axes = across_axes(frame.normals)[0]

    def missing(shift):
        at = shift @ axes
        return [
            np.linalg.norm(at - c) - (r - bend * offset)
            for c, r, bend in zip(centres, (9, 14), bends, strict=True)
        ]

    start = np.array([offset / np.sin(np.radians(degrees) / 2), 0.1])
    wanted = fsolve(missing, start, xtol=1e-11) @ axes
    assert found.found.all()
    assert found.point[0] == pytest.approx(wanted, abs=1e-8)
    for k in range(2):
        normal = bends[k] * (centres[k] - wanted)
        assert found.normals[0, k] == pytest.approx(normal / np.linalg.norm(normal), abs=1e-8)


def test_sides_that_do_not_meet_are_said_not_to():
    frame, _, outward = wedge_frame(90)
    # Two small circles, each away from the edge, that never meet.
    centres = 4.0 * outward
    found = corners(frame, exact_fits(circles_in(frame, centres, (1.0, 1.0))))
    assert not found.found.any()


def test_covariance_is_that_of_two_lines_known_each_with_its_own_variance():
    """In the axes n1 + n2 and n1 − n2: var/2 / cos² and var/2 / sin² of half the turn."""
    for degrees in (40, 90, 140):
        frame, _, outward = wedge_frame(degrees)
        sigma = 0.02
        fits = exact_fits(
            planes_in(frame, outward), (sigma / REACH) ** 2, np.diag([1.0, 0.0, 0.0, 0.0])
        )
        found = corners(frame, fits)
        half = np.radians(180 - degrees) / 2
        wanted = sigma**2 / 2 * np.diag([1 / np.cos(half) ** 2, 1 / np.sin(half) ** 2])
        assert found.covariance[0] == pytest.approx(wanted, rel=1e-6, abs=1e-12)


def test_covariance_with_a_probe_is_the_scatter_of_corners_of_scattered_sides():
    frame, _, outward = wedge_frame(110)
    rng = np.random.default_rng(3)
    centres = 20.0 * outward
    exact = np.asarray(circles_in(frame, centres, (20.0, 20.0)))
    root = np.diag([2e-3, 3e-3, 2e-2, 0.0])  # of the coefficients in reaches, each by itself
    fits = exact_fits(exact, 1.0, root @ root.T)
    stated = corners(frame, fits, -1.0)
    drawn = []
    for _ in range(2000):
        change = rng.normal(size=(2, 4)) @ root.T
        c = exact + change * [REACH, 1.0, 1 / REACH, 1.0]
        drawn.append(corners(frame, exact_fits(c), -1.0).shift[0])
    seen = np.cov(np.array(drawn).T)
    assert stated.covariance[0] == pytest.approx(seen, rel=0.1, abs=0.03 * seen.max())


def test_what_neighbours_share_is_what_an_error_of_the_expected_curvature_does():
    """A curvature expected with the variance 1/weight, and 40 points that tell it, too."""
    frame, _, outward = wedge_frame(110)
    exact = np.asarray(circles_in(frame, 20.0 * outward, (20.0, 20.0)))
    away = np.linspace(0.1, 1.0, 40)
    terms = np.column_stack([np.ones(40), away, 0.5 * away**2, np.zeros(40)])
    weight, expected = 5.0, np.diag([0.0, 0.0, 5.0, 1.0])
    inverse = np.linalg.inv(terms.T @ terms + expected)
    stated = corners(frame, exact_fits(exact, 1e-6, inverse, weight))
    drawn = []
    for error in (1e-4, -1e-4):  # of both sides' expected curvature, in reaches
        moved = exact + error * weight * inverse[:, 2] * [REACH, 1.0, 1 / REACH, 1.0]
        drawn.append(corners(frame, exact_fits(moved)).shift[0])
    by_both = (drawn[0] - drawn[1]) / 2e-4 * np.sqrt(1e-6 / weight)
    # Errors of the two sides are independent: alike they move the edge along the first axis.
    assert by_both[1] == pytest.approx(0.0, abs=1e-6)
    assert stated.shared[0, 0, 0] == pytest.approx(by_both[0] ** 2 / 2.0, rel=0.01)
    assert np.all(np.linalg.eigvalsh(stated.covariance[0] - stated.shared[0]) > 0.0)


def test_the_largest_sigma_is_the_root_of_the_largest_eigenvalue():
    half = np.random.default_rng(2).normal(size=(50, 2, 2))
    covariance = half @ np.swapaxes(half, 1, 2)
    wanted = np.sqrt(np.linalg.eigvalsh(covariance)[:, -1])
    assert largest_sigma(covariance) == pytest.approx(wanted)
    assert largest_sigma(np.zeros((1, 2, 2))) == 0.0
