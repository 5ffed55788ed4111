# SPDX-License-Identifier: LGPL-2.1-or-later
"""Borrowed normal equations are those of the same points, seen from the section that borrows."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry.frames import rotate
from freecad_edgescan.scanning.edge_path import EdgePath
from freecad_edgescan.scanning.neighbours import Neighbours
from freecad_edgescan.scanning.normal_equations import BLOCKS, block_moments, sum_stretches
from freecad_edgescan.scanning.section import Frames, frames_from_sides, section_points
from freecad_edgescan.scanning.stop import Stop

REACH = 5.0
RADIUS = 40.0
SECTIONS = 7


def path(bent: bool, rng) -> EdgePath:
    """Sections beside a straight or a circular edge, each turned about its tangent."""
    turn = np.linspace(0.0, 0.3, SECTIONS)
    circle = RADIUS * np.stack([np.cos(turn) - 1.0, np.sin(turn), 0.0 * turn], axis=1)
    round_it = np.stack([-np.sin(turn), np.cos(turn), 0.0 * turn], axis=1)
    inward = np.stack([-np.cos(turn), -np.sin(turn), 0.0 * turn], axis=1)
    if not bent:
        round_it, inward = np.tile([0.0, 1.0, 0.0], (2, SECTIONS, 1))
        circle = turn[:, None] * RADIUS * round_it
    aside = np.tile(0.2 * rng.normal(size=2), (SECTIONS, 1))
    outward = np.cross(round_it, [0.0, 0.0, 1.0]) if bent else np.tile([1.0, 0, 0], (SECTIONS, 1))
    origin = circle + aside[:, :1] * outward + aside[:, 1:] * [0.0, 0.0, 1.0]
    tilt = 0.1 * rng.normal(size=SECTIONS)
    sides = np.stack([rotate(outward, round_it, tilt), rotate([0, 0, 1.0], round_it, tilt)], 1)
    # Concentric circles: the edge's own curvature where the section stands.
    bend = inward / (RADIUS + aside[:, :1]) if bent else None
    frames = frames_from_sides(origin, round_it, sides, bend)
    radius = RADIUS + aside[0, 0] if bent else RADIUS
    return EdgePath(frames, turn * radius, 0.3 * radius, False, (Stop.CORNER, Stop.CORNER))


def moments_of(frames: Frames, groups):
    """Normal equations (m, 2, 15) of one group of points (n, 3) for each section."""
    found = []
    for k, (points, sides) in enumerate(groups):
        index = np.arange(len(points))
        seen = section_points(frames[k], np.zeros_like(index), index, points)
        assert np.array_equal(seen.side, sides)
        found.append(block_moments(seen, 1, 10.0 * REACH).sum(axis=2)[0])
    return np.array(found)


@pytest.mark.parametrize("bent", [False, True])
@pytest.mark.parametrize("step", [1, -2])
def test_borrowed_are_the_neighbours_points(bent, step):
    rng = np.random.default_rng(5)
    edge = path(bent, rng)
    groups = []
    for frame in (edge.frames[k] for k in range(SECTIONS)):
        sides = rng.integers(0, 2, 60)
        away, height, along = rng.uniform([1.0, -0.3, -1.0], [4.0, 0.3, 1.0], (60, 3)).T
        plane = away[:, None] * frame.sides[0, sides] + height[:, None] * frame.normals[0, sides]
        # Along the edge, on circles about the same axis where it is bent.
        if bent:
            turn = along / RADIUS
            centre = np.array([-RADIUS, 0.0, 0.0])
            points = centre + rotate(frame.origin[0] + plane - centre, [0, 0, 1.0], turn)
        else:
            points = frame.origin[0] + plane + along[:, None] * frame.tangent[0]
        groups.append((points, sides))
    own = moments_of(edge.frames, groups)
    neighbours = Neighbours(edge, 10.0 * REACH)
    seen = neighbours.borrowed(own, step)
    for k in range(SECTIONS):
        if not 0 <= k + step < SECTIONS:
            assert not seen[k].any()
            continue
        expected = moments_of(edge.frames[k], [groups[k + step]])[0]
        assert seen[k] == pytest.approx(expected, rel=1e-6, abs=1e-6 if not bent else 2e-3)
    some = np.array([1, 4])
    assert neighbours.borrowed(own, step, some) == pytest.approx(seen[some])


@pytest.mark.parametrize("width", [1, 3, 9])
def test_pooled_is_the_sum_of_what_is_borrowed(width):
    """Blocks pooled and then summed over a stretch, or the other way round, and not too many."""
    rng = np.random.default_rng(2)
    edge = path(False, rng)
    neighbours = Neighbours(edge, 10.0 * REACH)
    blocks = rng.random((SECTIONS, 2, BLOCKS, 15))
    stretch = np.tile([3, 9], (SECTIONS, 2, 1))
    near = range(-min(width, 3), min(width, 3) + 1)
    expected = blocks + sum(neighbours.borrowed(blocks, step) for step in near if step)
    pooled = neighbours.pooled(blocks, width)
    assert pooled == pytest.approx(expected)
    assert neighbours.pooled(blocks, width, np.array([0, 5])) == pytest.approx(pooled[[0, 5]])
    summed = neighbours.pooled_stretches(blocks, stretch, width)
    assert summed == pytest.approx(sum_stretches(pooled, stretch))
