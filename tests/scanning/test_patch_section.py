# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of a known edge, measured together from the points on its sides."""

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning.patch_section import PatchSection, PatchSettings
from freecad_edgescan.scanning.section import frames_from_sides
from freecad_edgescan.scanning.stop import Stop

PITCH, NOISE = 0.5, 0.02
SETTINGS = PatchSettings(8.0, 1.0, PITCH, NOISE)


@pytest.fixture(scope="module")
def part(wedge):
    return wedge(90.0, PITCH, NOISE)


def sections_at(part, shares):
    """Predicted sections of the wedge, off the edge by half a noise."""
    origin = np.array([part.at(share, 0.5 * NOISE) for share in shares])
    count = len(origin)
    return frames_from_sides(
        origin, np.tile(part.along, (count, 1)), np.tile(part.sides, (count, 1, 1))
    )


def look(part, shares, cloud=None):
    predicted = sections_at(part, shares)
    section = PatchSection(cloud or part.cloud, SETTINGS)
    return section.look(predicted, np.full(len(predicted), SETTINGS.half_width))


def test_sections_on_the_edge_are_found_and_those_off_the_cloud_say_why(part):
    seen = look(part, [-0.3, 0.8, 0.0, 0.3])
    assert seen.found.tolist() == [True, False, True, True]
    assert np.all(part.distance(seen.frames.origin[seen.found]) < 4 * seen.sigma[seen.found])
    # A name that only reads like the reason would not be recognised by a walk.
    assert seen.stops[1] is Stop.CLOUD_END
    assert seen.station(1).stop is Stop.CLOUD_END
    assert np.isnan(seen.sigma[1])


def test_outliers_in_one_section_change_no_other_one(part):
    shares = [-0.3, 0.0, 0.3]
    strays = part.at(0.0, np.linspace(2.0, 7.0, 6)[:, None]) + 0.2 * part.outward[0]
    spoilt = PointCloud(np.vstack([part.cloud.points, strays]))
    clean, seen = look(part, shares), look(part, shares, spoilt)
    assert seen.frames.origin[[0, 2]] == pytest.approx(clean.frames.origin[[0, 2]], abs=1e-9)
    assert part.distance(seen.frames.origin)[1] < 4 * seen.sigma[1]


def test_where_no_section_has_points_each_says_so(part):
    nothing = look(part, [2.0, 3.0])
    assert not nothing.found.any()
    assert all(stop is Stop.CLOUD_END for stop in nothing.stops)


def test_a_section_whose_points_lie_on_neither_side_has_reached_a_corner(part):
    """In the middle of one side, both sides of the section rise steeply out of the surface."""
    outward, away = part.outward[0], part.sides[0]
    steep = np.array([2.0 * outward + away, 2.0 * outward - away])
    frame = frames_from_sides(part.at(0.0, 7.0)[None], part.along[None], steep[None])
    seen = PatchSection(part.cloud, SETTINGS).look(frame, np.array([SETTINGS.half_width]))
    assert seen.station(0).stop is Stop.CORNER
