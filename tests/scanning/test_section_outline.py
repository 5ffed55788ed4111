# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn of a section agrees with the part it was scanned from."""

import numpy as np
import pytest

from freecad_edgescan.scanning import scan_edge, section_outline


@pytest.fixture(scope="module")
def rounded(wedge):
    part = wedge(80.0, 0.4, noise=0.005, rounding=3.0)
    return part, scan_edge(part.cloud, part.at())


def test_the_circle_of_a_rounding_lies_where_the_part_is_rounded(rounded):
    part, edge = rounded
    number = len(edge) // 2
    outline = section_outline(edge, number)
    centre, radius = outline.fillet
    bisector = -part.outward.sum(axis=0)
    bisector /= np.linalg.norm(bisector)
    true = part.middle + 3.0 / np.sin(part.angle / 2) * bisector
    found = part.across(outline.line.in_space(centre[None]))[0]
    assert abs(radius - 3.0) < 3 * edge.fillet_sigma[number] + 0.02
    assert np.linalg.norm(found - (true - part.middle)) < 0.1


def test_the_circle_touches_both_sides(rounded):
    outline = section_outline(rounded[1], 10)
    centre, radius = outline.fillet
    for side in outline.surfaces:
        fine = np.column_stack(
            [np.interp(np.linspace(0, 39, 4000), np.arange(40), c) for c in side.T]
        )
        assert np.linalg.norm(fine - centre, axis=1).min() == pytest.approx(radius, rel=0.02)


def test_a_sharp_edge_has_no_circle(wedge):
    part = wedge(90.0, 0.4, noise=0.005)
    edge = scan_edge(part.cloud, part.at())
    numbers = np.flatnonzero(np.isnan(edge.fillet_radius))
    assert len(numbers) > 0.8 * len(edge)
    assert section_outline(edge, int(numbers[0])).fillet is None


def test_the_ellipse_has_the_edge_points_sigma_in_its_worst_direction(rounded):
    _, edge = rounded
    outline = section_outline(edge, 7)
    away = np.linalg.norm(outline.ellipse(2.0) - outline.line.edge_point, axis=1)
    assert away.max() == pytest.approx(2.0 * edge.sigma[7], rel=1e-2)


def test_the_plane_leads_back_to_the_cloud(rounded):
    _, edge = rounded
    line = section_outline(edge, 7).line
    assert line.in_space(line.edge_point[None])[0] == pytest.approx(edge.points[7], abs=1e-9)
