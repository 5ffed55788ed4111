# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of clouds whose profile is known."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.surfacing.point_chain import chain_order

NOISE = 0.03


def straight(start, end):
    return es.BSplineCurve(np.array([start, end], dtype=float), [0, 0, 1, 1], 1)


def trench(profile, width, noise=NOISE, origin=(0.0, 0, 0), seed=0, count=24_000):
    """A groove along x, y = profile's first and z = its second coordinate, in the plane z = 0."""
    rng = np.random.default_rng(seed)
    y, z = profile(rng.random(count))
    wall = np.stack([60 * rng.random(count), y, z], axis=1)
    land = rng.random((count, 3)) * [60, 15, 0] + [0, width, 0]
    land[::2, 1] = -land[::2, 1]
    points = np.concatenate([wall, land])
    points += noise * rng.normal(size=points.shape) + origin
    x, y, z = origin
    rails = [straight([x, y + w, z], [x + 60, y + w, z]) for w in (-width, width)]
    return es.PointCloud(points), rails


def half_round(share):
    return -17 * np.cos(np.pi * share), -17 * np.sin(np.pi * share)


def vee(share):
    return 34 * share - 17, 0 * share


def waved(share):
    y = 34 * share - 17
    return y, -4 * np.sin(2 * np.pi * share) * np.sin(np.pi * share)


@pytest.mark.parametrize("origin", [(0, 0, 0), (1e6, -2e6, 5e5)])
@pytest.mark.parametrize("at", [0.5, 0.2])
def test_between_two_rims_a_pipe_is_an_arc_from_rim_to_rim(at, origin):
    cloud, rails = trench(half_round, 17.0, origin=origin)
    section = es.cross_section(cloud, rails[0], at, towards=rails[1])
    assert section.kind == "arc"
    assert section.primitive.radius == pytest.approx(17, abs=0.02)
    ends = section.curve.evaluate(np.array(section.curve.parameter_range)) - origin
    assert np.abs(ends - [[60 * at, -17, 0], [60 * at, 17, 0]]).max() < 0.05
    assert section.average == pytest.approx(NOISE * np.sqrt(2 / np.pi), rel=0.2)
    assert np.allclose(np.abs(section.plane.normal), [1, 0, 0], atol=1e-6)
    # in the plane, in order, and those of the wall only
    assert np.abs(section.plane.residuals(section.points)).max() < 1e-6
    angle = np.arctan2(section.points[:, 2] - origin[2], section.points[:, 1] - origin[1])
    turned = np.mod(angle - np.pi / 2, 2 * np.pi)
    order = np.polyfit(np.arange(len(turned)), turned, 1)
    assert np.abs(turned - np.polyval(order, np.arange(len(turned)))).max() < 0.3
    assert (section.rows >= 24_000).sum() <= 3  # of the land, within the noise of the rim
    assert np.abs(cloud.points[section.rows] - section.points).max() < 1.0


def test_a_flat_bottom_is_a_line_and_a_wave_a_spline():
    cloud, rails = trench(vee, 17.0)
    assert es.cross_section(cloud, rails[0], 0.5, towards=rails[1]).kind == "line"
    cloud, rails = trench(waved, 17.0)
    section = es.cross_section(cloud, rails[0], 0.5, towards=rails[1])
    assert section.kind == "spline" and section.primitive is None
    share = np.linspace(0.02, 0.98, 50)
    true = np.stack([30 + 0 * share, *waved(share)], axis=1)
    assert section.curve.closest(true)[1].max() < NOISE


def test_exact_points_give_the_exact_arc():
    cloud, rails = trench(half_round, 17.0, noise=0.0)
    section = es.cross_section(cloud, rails[0], 0.5, towards=rails[1])
    assert section.kind == "arc" and section.maximum < 1e-9


def test_another_kind_may_be_wanted():
    cloud, rails = trench(half_round, 17.0)
    section = es.cross_section(cloud, rails[0], 0.5, towards=rails[1], kind="spline")
    assert section.kind == "spline" and section.curve.degree == 3
    share = np.linspace(0.02, 0.98, 50)
    true = np.stack([30 + 0 * share, *half_round(share)], axis=1)
    assert section.curve.closest(true)[1].max() < NOISE
    line = es.cross_section(cloud, rails[0], 0.5, towards=rails[1], kind="line")
    assert line.kind == "line" and line.maximum > 3


def test_towards_a_point_one_side_of_a_scanned_edge_is_taken():
    box = es.CoreBox.small()
    cloud = box.cloud(0.4, 0.03)
    rim = box.edges[0]
    middle = len(rim.points) // 2
    edge = es.scan_edge(cloud, at=rim.points[middle])
    surface = es.compensate_cloud(cloud)
    place = rim.points[middle]
    across = np.cross(rim.tangents[middle], [0, 0, 1.0])
    down = np.array([0, 0, -1.0])
    beside = [place + 3 * across + down, place - 3 * across + down]
    sections = [es.cross_section(surface, edge, place, towards=at) for at in beside]
    land, wall = sorted(sections, key=lambda section: np.ptp(section.points[:, 2]))
    assert np.abs(land.points[:, 2]).max() < 0.2
    assert np.ptp(wall.points[:, 2]) > 2
    # both begin at the edge
    for section in sections:
        start = section.curve.evaluate(section.curve.parameter_range[0])
        assert np.linalg.norm(start - place) < 0.1
    both = es.cross_section(surface, edge, place, reach=5.0)
    assert len(both.points) > 0 and np.linalg.norm(both.local, axis=1).max() < 5.3


def test_strays_are_left_out_and_said():
    cloud, rails = trench(half_round, 17.0)
    y = np.linspace(-4, 4, 6)
    strays = np.stack([30 + 0 * y, y, 0.35 - np.sqrt(17**2 - y**2)], axis=1)
    mixed = es.PointCloud(np.vstack([cloud.points, strays]))
    section = es.cross_section(mixed, rails[0], 0.5, towards=rails[1])
    assert section.outside[section.rows >= len(cloud)].all()
    assert "6 of" in section.message or "7 of" in section.message
    assert section.primitive.radius == pytest.approx(17, abs=0.02)


def test_points_along_a_curve_come_into_order_whatever_way_it_winds():
    rng = np.random.default_rng(0)
    turn = np.sort(rng.random(3000)) * 5.0
    points = np.stack([(8 + turn) * np.cos(turn), (8 + turn) * np.sin(turn), 0 * turn], axis=1)
    shuffled = rng.permutation(3000)
    noisy = points[shuffled] + 0.02 * rng.normal(size=points.shape) * [1, 1, 0]
    rows = chain_order(noisy, points[0], 0.3, 3.0)
    assert len(rows) == 3000
    assert np.abs(np.diff(turn[shuffled][rows])).max() < 0.15
    assert turn[shuffled][rows[0]] < 0.1


def test_between_two_concave_edges_the_walls_do_not_belong_to_the_profile():
    random = np.random.default_rng(0)
    bottom = random.uniform((0, -8, 0), (20, 8, 0), (6000, 3))
    walls = np.vstack([random.uniform((0, y, 0), (20, y, 6), (2000, 3)) for y in (-8, 8)])
    points = np.vstack([bottom, walls]) + random.normal(0, 0.01, (10_000, 3))
    rails = [
        es.BSplineCurve(np.array([[0.0, y, 0], [20, y, 0]]), np.array([0.0, 0, 1, 1]), 1)
        for y in (-8, 8)
    ]
    section = es.cross_section(es.PointCloud(points), rails[0], 0.5, rails[1])
    assert section.kind == "line"
    assert np.abs(section.curve.evaluate(np.linspace(0, 1, 9))[:, 2]).max() < 0.01


def test_a_piece_beyond_a_gap_does_not_belong_to_the_chain():
    x = np.concatenate([np.linspace(0, 10, 200), np.linspace(20, 30, 200)])
    points = np.stack([x, 0 * x, 0 * x], axis=1)
    assert set(chain_order(points, np.array([9.0, 0, 0]), 0.2, 3.0)) == set(range(200))


def test_what_is_no_section_is_refused():
    cloud, rails = trench(half_round, 17.0)
    with pytest.raises(ValueError, match=r"place of a section is 1\.5"):
        es.cross_section(cloud, rails[0], 1.5)
    with pytest.raises(ValueError, match="no profile of the kind 'oval'"):
        es.cross_section(cloud, rails[0], 0.5, kind="oval")
    with pytest.raises(ValueError, match="reach is -1 mm"):
        es.cross_section(cloud, rails[0], 0.5, reach=-1)
    with pytest.raises(ValueError, match="thickness is 0 mm"):
        es.cross_section(cloud, rails[0], 0.5, thickness=0)
    with pytest.raises(ValueError, match="lies along the edge"):
        es.cross_section(cloud, rails[0], 0.5, towards=[99.0, -17, 0])
    with pytest.raises(ValueError, match="three numbers"):
        es.cross_section(cloud, rails[0], 0.5, towards=[1.0, 2.0])
    with pytest.raises(ValueError, match="rails meet"):
        es.cross_section(cloud, rails[0], 0.5, towards=rails[0])
    far = straight([0, 0, 500], [60, 0, 500])
    with pytest.raises(ValueError, match=r"holds 0 points .* profile needs 8"):
        es.cross_section(cloud, far, 0.5)
    with pytest.raises(ValueError, match="compensate_cloud"):
        es.cross_section(es.PointCloud(cloud.points, 1.0), rails[0], 0.5)
    for few in (np.zeros((1, 3)), np.ones((30, 3))):
        with pytest.raises(ValueError, match="too few, or too much alike, for a profile"):
            es.cross_section(es.PointCloud(few), rails[0], 0.5)
