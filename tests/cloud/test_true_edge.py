# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest

from freecad_edgescan.cloud import TrueEdge

RADIUS = 25.0


def circle(share=1.0, closed=True, count=20_000):
    angle = np.linspace(0, 2 * np.pi * share, count, endpoint=not closed)
    x, y, zero = np.cos(angle), np.sin(angle), np.zeros(count)
    return TrueEdge(
        "circle",
        np.column_stack([RADIUS * x, RADIUS * y, zero]),
        np.column_stack([-y, x, zero]),
        np.pi / 2,
        convex=True,
        closed=closed,
    )


def test_length_counts_the_closing_step():
    assert circle().length == pytest.approx(2 * np.pi * RADIUS, rel=1e-7)
    assert circle(0.5, closed=False).length == pytest.approx(np.pi * RADIUS, rel=1e-7)


def test_distance_and_nearest_place_are_those_of_the_circle():
    points = np.random.default_rng(1).uniform(-40, 40, (500, 3))
    rho = np.hypot(points[:, 0], points[:, 1])
    edge = circle()
    assert np.abs(edge.distance(points) - np.hypot(rho - RADIUS, points[:, 2])).max() < 1e-5
    foot = np.column_stack([points[:, :2] * (RADIUS / rho)[:, None], np.zeros(500)])
    assert np.abs(edge.nearest(points) - foot).max() < edge.length / len(edge)
    nearest = edge.points[edge.nearest_sample(points)]
    assert np.linalg.norm(nearest - foot, axis=1).max() < 0.51 * edge.length / len(edge)


def test_beyond_an_open_end_the_end_is_nearest():
    edge = circle(0.5, closed=False)
    assert edge.distance([[-RADIUS, -3.0, 4.0]]) == pytest.approx([5.0], abs=1e-6)
    assert edge.nearest_sample([[-RADIUS, -3.0, 4.0]]) == [len(edge) - 1]


def test_traced_share_is_the_part_of_the_length_that_edge_points_cover():
    edge = circle()
    quarter = circle(0.25, closed=False, count=60).points + np.array([0.0, 0.0, 0.1])
    assert edge.traced_share(quarter, 0.15) == pytest.approx(0.25, abs=2e-3)
    assert edge.traced_share(quarter, 0.05) == 0.0
    assert edge.traced_share(np.empty((0, 3)), 1.0) == 0.0


def test_a_closed_polyline_traces_the_last_step_too():
    edge, polygon = circle(), circle(count=40).points
    assert edge.traced_share(polygon, 0.1) == pytest.approx(39 / 40, abs=2e-3)
    assert edge.traced_share(polygon, 0.1, closed=True) == 1.0


def test_traced_share_does_not_depend_on_where_samples_crowd():
    x = np.concatenate([np.linspace(0, 5, 1000, endpoint=False), np.linspace(5, 10, 50)])
    points = np.column_stack([x, 0 * x, 0 * x])
    edge = TrueEdge("line", points, np.array([1.0, 0.0, 0.0]), 2.0)
    assert edge.traced_share([[0, 0, 0], [5, 0, 0]], 0.01) == pytest.approx(0.5, abs=0.02)


def test_one_number_serves_every_sample_and_arrays_cannot_be_changed():
    edge = circle()
    assert edge.angle.shape == edge.room.shape == (len(edge),)
    assert np.isnan(edge.room).all()
    with pytest.raises(ValueError, match="read-only"):
        edge.points[0] = 0.0


def test_arrays_that_do_not_match_are_refused_with_their_shape():
    points = np.zeros((5, 3))
    with pytest.raises(ValueError, match=r"tangents of edge 'rim' .* \(4, 3\); give \(5, 3\)"):
        TrueEdge("rim", points, np.zeros((4, 3)), 1.0)
    with pytest.raises(ValueError, match=r"shape \(1, 3\)"):
        TrueEdge("rim", points[:1], points[:1], 1.0)
