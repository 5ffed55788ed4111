# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ends of a straight edge that bend away with the roundings of the edges it meets."""

from types import SimpleNamespace

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import Stop, scan_edge
from freecad_edgescan.scanning.corner import across_axes
from freecad_edgescan.scanning.end_course import on_course
from freecad_edgescan.scanning.section import frames_from_sides

SIGMA, COUNT = 0.01, 40  # mm, sections
ENDS = (Stop.CORNER, Stop.LOST)


def sections(beside, bend=0.0):
    """Sections 1 mm apart along x whose edge points scatter, and are beside it by (m,) mm."""
    x = np.arange(float(COUNT))
    origin = np.column_stack([x, bend * (x - 20.0) ** 2, np.zeros(COUNT)])
    tangent = np.column_stack([np.ones(COUNT), 2.0 * bend * (x - 20.0), np.zeros(COUNT)])
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    sides = np.broadcast_to([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], (COUNT, 2, 3))
    frames = frames_from_sides(origin, tangent, sides)
    scatter = SIGMA * np.random.default_rng(5).normal(size=(COUNT, 2))
    scatter[:, 0] += beside
    point = origin + np.einsum("ma,mai->mi", scatter, across_axes(frames.normals))
    seen = SimpleNamespace(
        point=point, covariance=np.broadcast_to(SIGMA**2 * np.eye(2), (COUNT, 2, 2))
    )
    return SimpleNamespace(frames=frames, at=x, corners=lambda: seen)


def test_an_edge_that_keeps_its_course_keeps_its_ends():
    assert on_course(sections(np.zeros(COUNT)), ENDS) == slice(0, COUNT)


@pytest.mark.parametrize(
    ("stops", "left"),
    [
        (ENDS, slice(3, COUNT - 2)),
        ((Stop.START, Stop.LOST), slice(0, COUNT - 2)),
        ((Stop.CORNER, Stop.GATE), slice(3, COUNT)),
    ],
)
def test_ends_that_bend_away_are_cut_but_where_they_were_given(stops, left):
    beside = np.zeros(COUNT)
    beside[:3] = np.array([0.6, 0.3, 0.1])
    beside[-2:] = [0.1, 0.4]
    assert on_course(sections(beside), stops) == left


def test_a_bent_edge_may_bend_on():
    assert on_course(sections(np.zeros(COUNT), bend=0.01), ENDS) == slice(0, COUNT)


def test_a_short_edge_is_left_as_it_is():
    few = sections(np.zeros(COUNT))
    few.at = few.at[:19]
    assert on_course(few, ENDS) == slice(0, 19)


def rounded_block(radius, pitch, noise, seed):
    """Points strewn over a corner of a block whose edges are all rounded by a ball.

    Its sharp edges would meet in the origin, and the block lies where all coordinates are negative.
    """
    rng = np.random.default_rng(seed)
    # Of a block of three times the density what the normals of the inner block lead to.
    faces = []
    for axis in range(3):
        flat = rng.uniform(-25.0, 0.0, (int(3.0 * 25.0**2 / pitch**2), 3))
        flat[:, axis] = 0.0
        faces.append(flat)
    points = np.vstack(faces)
    foot = np.minimum(points, -radius)
    away = points - foot
    size = np.linalg.norm(away, axis=1, keepdims=True)
    out = away / size
    points = foot + radius * out
    keep = rng.uniform(size=len(points)) < (1.0 / 3.0) / _crowding(size[:, 0] / radius)
    points, out = points[keep], out[keep]
    return PointCloud(points + noise * rng.normal(size=(len(points), 1)) * out)


def _crowding(size):
    """How much denser points lie that are drawn in from so many radii to one."""
    return np.clip(size, 1.0, None) ** 2


@pytest.mark.parametrize("seed", range(3))
def test_under_roundings_an_edge_ends_before_it_bends_away_into_the_corner(seed):
    radius = 2.0
    cloud = rounded_block(radius, 0.5, 0.08, seed)
    edge = scan_edge(cloud, at=(-12.0, -0.6, -0.6))
    off = np.linalg.norm(edge.points[:, 1:], axis=1)
    assert edge.points[:, 0].max() > -2.0 * radius
    assert off.max() < 0.3
    assert np.max(off / edge.sigma) < 5.0
