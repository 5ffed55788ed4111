# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections that a walk has left beside their neighbours are moved into line with them."""

import numpy as np
import pytest
from scipy.ndimage import uniform_filter1d

from freecad_edgescan.scanning.aligned import in_line
from freecad_edgescan.scanning.edge_path import EdgePath
from freecad_edgescan.scanning.neighbours import Neighbours
from freecad_edgescan.scanning.normal_equations import BLOCKS, block_moments
from freecad_edgescan.scanning.section import SectionPoints, frames_from_sides, section_points
from freecad_edgescan.scanning.side_fit import fit_summed
from freecad_edgescan.scanning.stop import Stop

REACH, SECTIONS, EACH, NOISE, POOLED = 6.0, 60, 400, 0.02, 4


def straight_edge(aside, angle):
    """Sections beside the y axis by (m, 2) mm in x and z, and points of two planes that meet in it.

    Returns the path, the points, and the planes as nine neighbours see them.
    """
    rng = np.random.default_rng(4)
    at = 2.0 * np.arange(SECTIONS)
    half = 0.5 * angle
    sides = np.array([[np.sin(half), 0.0, np.cos(half)], [-np.sin(half), 0.0, np.cos(half)]])
    origin = np.column_stack([aside[:, 0], at, aside[:, 1]])
    tangent = np.tile([0.0, 1.0, 0.0], (SECTIONS, 1))
    frames = frames_from_sides(origin, tangent, np.tile(sides, (SECTIONS, 1, 1)))
    path = EdgePath(frames, at, at[-1], False, (Stop.CORNER, Stop.CORNER))
    owner = np.repeat(np.arange(SECTIONS), EACH)
    side = rng.integers(0, 2, len(owner))
    away, height, along = rng.uniform([1.0, 0.0, -1.0], [REACH - 0.5, 0.0, 1.0], (len(owner), 3)).T
    height = NOISE * rng.normal(size=len(owner))
    places = away[:, None] * frames.sides[0, side] + height[:, None] * frames.normals[0, side]
    places[:, 1] += at[owner] + along
    points = section_points(frames, owner, np.arange(len(owner)), places)
    stretch = np.tile([0, BLOCKS], (SECTIONS, 2, 1))
    summed = Neighbours(path, REACH).pooled_stretches(
        block_moments(points, SECTIONS, REACH), stretch, POOLED
    )
    each = np.full((SECTIONS, 2), 1.0)
    return path, points, fit_summed(summed, REACH, NOISE * each, stretch, 0.0 * each, 0.3 * each)


def wander(origin):
    """How far sections stand from the mean of those that decide with them, (2,) mm rms."""
    across = origin[:, [0, 2]]
    mean = uniform_filter1d(across, 2 * POOLED + 1, axis=0)
    return np.sqrt(np.mean(np.square(across - mean)[POOLED:-POOLED], axis=0))


@pytest.mark.parametrize("angle", [0.8, 1.6, 2.6])
def test_sections_that_stand_beside_each_other_are_moved_into_line(angle):
    aside = 0.05 * np.random.default_rng(1).normal(size=(SECTIONS, 2))
    path, points, pooled = straight_edge(aside, angle)
    moved = in_line(points, np.ones(len(points.index), dtype=bool), pooled, path)
    assert moved is not None
    assert (wander(moved[1].frames.origin) < 0.4 * wander(path.frames.origin)).all()
    # The points stay where they are.
    before, after = (in_space(*each) for each in ((points, path), moved))
    assert np.abs(before - after).max() < 1e-12


def test_sections_in_line_stay_and_so_do_those_that_are_all_beside_the_edge():
    for aside in (np.zeros((SECTIONS, 2)), np.full((SECTIONS, 2), 0.1)):
        path, points, pooled = straight_edge(aside, 1.6)
        assert in_line(points, np.ones(len(points.index), dtype=bool), pooled, path) is None


def in_space(points: SectionPoints, path: EdgePath) -> np.ndarray:
    frames, owner, side = path.frames, points.owner, points.side
    return (
        frames.origin[owner]
        + points.along[:, None] * frames.tangent[owner]
        + points.away[:, None] * frames.sides[owner, side]
        + points.height[:, None] * frames.normals[owner, side]
    )
