# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept surfaces: what they hold, where they are exact, and what makes none."""

from __future__ import annotations

import re

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.geometry import Circle, fit_curve
from freecad_edgescan.geometry.exact_surfaces import circular_arc
from freecad_edgescan.surfacing import SweepKind, sweep_kinds
from freecad_edgescan.surfacing.self_crossing import self_crossing

X, Y, Z = np.eye(3)


def line(start, end):
    return es.BSplineCurve([start, end], [0, 0, 1, 1], 1)


def arc(centre, axis, radius, zero, first=0.0, last=np.pi / 2):
    return circular_arc(Circle(np.asarray(centre, float), axis, radius, zero), first, last)


def quarter_bend(big=40.0, small=10.0):
    """A half-pipe round a right angle: quarter of a torus' lower half, and its four curves."""
    rails = [arc([0, 0, 0], Z, radius, X) for radius in (big - small, big + small)]
    profiles = [
        arc(big * X, -Y, small, -X, 0.0, np.pi),
        arc(big * Y, X, small, -Y, 0.0, np.pi),
    ]
    return rails, profiles


def torus_distance(points, big=40.0, small=10.0):
    ring = np.hypot(points[..., 0], points[..., 1]) - big
    return np.abs(np.hypot(ring, points[..., 2]) - small)


def free_curves(gap=0.0, seed=0):
    """Two wavy rails and the profiles between their ends."""
    rng = np.random.default_rng(seed)
    knots = np.r_[[0.0] * 4, 0.3, 0.6, [1.0] * 4]
    x = np.linspace(0, 60, 6)
    rails = [
        es.BSplineCurve(np.stack([x, np.full(6, y), rng.normal(size=6)], axis=1), knots)
        for y in (0.0, 25.0)
    ]
    profiles = []
    for end in (0.0, 1.0):
        first, second = (rail.evaluate(end) for rail in rails)
        share = np.linspace(0, 1, 6)[:, None]
        poles = (1 - share) * first + share * second - 8 * share * (1 - share) * Z
        profiles.append(es.BSplineCurve(poles + gap * X, knots))
    return rails, profiles


SHARE = np.linspace(0, 1, 41)


@pytest.mark.parametrize("model", ["blend", "rotate"])
def test_a_sweep_holds_its_rails_and_profiles(model):
    rails, profiles = free_curves()
    sweep = es.SweptSurface(rails, profiles, model, pairing="parameter")
    for v, rail in zip((0.0, 1.0), rails, strict=True):
        assert np.allclose(sweep.evaluate(SHARE, v), rail.evaluate(SHARE), atol=1e-9)
    for u, profile in zip((0.0, 1.0), profiles, strict=True):
        assert np.allclose(sweep.evaluate(u, SHARE), profile.evaluate(SHARE), atol=1e-9)


def test_the_blend_model_is_the_published_formula():
    rails, profiles = free_curves(seed=3)
    sweep = es.SweptSurface(rails, profiles)
    u, v = 0.37, 0.71
    one, other = (profile.evaluate(v) for profile in profiles)
    ends = [np.linalg.norm(profiles[0].evaluate(t) - profiles[1].evaluate(t)) for t in (0, 1)]
    gamma = np.linalg.norm(one - other) / ((1 - v) * ends[0] + v * ends[1])
    expected = (1 - u) * one + u * other
    for rail, beta in zip(rails, (1 - v, v), strict=True):
        chord = (1 - u) * rail.evaluate(0.0) + u * rail.evaluate(1.0)
        expected = expected + beta * gamma * (rail.evaluate(u) - chord)
    assert np.allclose(sweep.evaluate(u, v), expected, atol=1e-12)


@pytest.mark.parametrize("model", ["blend", "rotate"])
def test_half_circles_round_concentric_rails_make_the_torus(model):
    u, v = np.meshgrid(SHARE, SHARE)
    points = es.SweptSurface(*quarter_bend(), model).evaluate(u, v)
    assert torus_distance(points).max() < 1e-3


def test_facing_points_are_paired_although_the_rails_differ_in_length():
    """Straight, then round a bend: the outer rail is longer only in the bend."""
    rails, profiles = [], []
    angle = np.linspace(0, np.pi / 2, 60)[1:]
    for radius in (30.0, 50.0):
        straight = np.stack([np.full(60, radius), np.linspace(-80, 0, 60), np.zeros(60)], axis=1)
        bend = radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
        points = np.concatenate([straight, bend])
        at = np.append(0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
        rails.append(es.BSplineCurve(points, np.r_[0, at, at[-1]], 1))
    profiles = [
        arc([40, -80, 0], -Y, 10.0, -X, 0.0, np.pi),
        arc(40 * Y, X, 10.0, -Y, 0.0, np.pi),
    ]
    u, v = np.meshgrid(SHARE, SHARE)
    points = es.SweptSurface(rails, profiles, "rotate").evaluate(u, v).reshape(-1, 3)
    in_bend = points[:, 1] > 1
    assert torus_distance(points[in_bend]).max() < 0.05
    by_parameter = es.SweptSurface(rails, profiles, "rotate", pairing="parameter")
    assert torus_distance(by_parameter.evaluate(u, v).reshape(-1, 3)[in_bend]).max() > 1


def test_profiles_between_the_ends_are_held_too():
    rails = [line([0, y, 0], [90, y, 0]) for y in (0.0, 20.0)]
    profiles = [
        es.BSplineCurve([[x, 0, 0], [x, 10, -depth], [x, 20, 0]], [0, 0, 0, 1, 1, 1], 2)
        for x, depth in ((0, 10), (30, 16), (90, 8))
    ]
    sweep = es.SweptSurface(rails, profiles, "rotate")
    assert np.allclose(sweep.stations, [0, 1 / 3, 1])
    for station, profile in zip(sweep.stations, profiles, strict=True):
        assert np.allclose(sweep.evaluate(station, SHARE), profile.evaluate(SHARE), atol=1e-9)


def test_along_one_rail_the_profile_keeps_its_size_and_place_in_the_frame():
    rail = arc([0, 0, 0], Z, 40.0, X)
    profile = arc([40, 0, 0], -Y, 10.0, -X, 0.0, np.pi)
    sweep = es.SweptSurface((rail,), (profile,), "rotate")
    u, v = np.meshgrid(SHARE, SHARE)
    assert torus_distance(sweep.evaluate(u, v)).max() < 1e-6


def test_curves_drawn_the_other_way_are_turned_and_that_is_said():
    rails, profiles = free_curves()
    expected = es.SweptSurface(rails, profiles)
    turned = es.SweptSurface((rails[0], rails[1].reversed()), (profiles[1], profiles[0].reversed()))
    assert np.allclose(turned.evaluate(0.3, 0.8), expected.evaluate(0.3, 0.8), atol=1e-9)
    assert turned.message == (
        "Rail 2 was turned round. The profiles were taken in the opposite order. "
        "Profile 1 was turned round."
    )
    assert expected.message == ""


def test_small_gaps_are_closed_on_the_rails():
    rails, profiles = free_curves(gap=0.4)
    sweep = es.SweptSurface(rails, profiles, "rotate", pairing="parameter")
    assert np.allclose(sweep.evaluate(SHARE, 0.0), rails[0].evaluate(SHARE), atol=1e-9)
    assert np.allclose(sweep.evaluate(0.0, SHARE), profiles[0].evaluate(SHARE) - 0.4 * X, atol=1e-9)


def test_profiles_along_one_rail_are_turned_like_the_first_and_that_is_said():
    rail = arc([0, 0, 0], Z, 30.0, X, 0.0, 1.2)
    hooks = []
    for t in (0.0, 0.5, 1.0):
        place = rail.evaluate(1.2 * t)
        out = place / np.linalg.norm(place)
        hooks.append(
            es.BSplineCurve([place, place + 5 * out, place + 7 * Z], [0, 0, 0, 1, 1, 1], 2)
        )
    expected = es.SweptSurface([rail], hooks, "rotate")
    turned = es.SweptSurface([rail], (hooks[0], hooks[1].reversed(), hooks[2]), "rotate")
    assert np.allclose(turned.evaluate(0.3, 0.8), expected.evaluate(0.3, 0.8), atol=1e-9)
    assert turned.message == "Profile 2 was turned round." and expected.message == ""


def longer(rail, before, after):
    """The same curve over a longer range of its straight line."""
    start, end = rail.evaluate(0.0), rail.evaluate(1.0)
    way = (end - start) / np.linalg.norm(end - start)
    return line(start - before * way, end + after * way)


def test_rails_beyond_the_profiles_are_offered_to_be_cut_and_cut():
    rails = [line([0, y, 0], [50, y, 0]) for y in (0.0, 20.0)]
    ends = [line([x, 0, 0], [x, 20, 0]) for x in (0, 50)]
    expected = es.SweptSurface(rails, ends, "rotate")
    long = [rails[0], longer(rails[1], 4.0, 7.5)]
    with pytest.raises(ValueError, match=r"1: 0 and 4 mm; profile 2: 0 and 7.5 mm. Cut the rails"):
        es.SweptSurface(long, ends, "rotate")
    cut = es.SweptSurface(long, ends, "rotate", cut_rails=True)
    assert cut.message == "Rail 2 was cut by 11.5 mm to end at the profiles."
    assert np.allclose(
        cut.evaluate(SHARE[:, None], SHARE), expected.evaluate(SHARE[:, None], SHARE), atol=1e-9
    )


def test_cutting_leaves_small_gaps_to_the_profiles_and_cannot_mend_short_rails():
    rails, profiles = free_curves(gap=0.4)
    cut = es.SweptSurface(rails, profiles, "rotate", pairing="parameter", cut_rails=True)
    assert np.allclose(cut.evaluate(SHARE, 0.0), rails[0].evaluate(SHARE), atol=1e-9)
    short = [rails[0], rails[1].restricted(0.2, 1.0)]
    for choice in (False, True):
        with pytest.raises(ValueError, match=r"do not meet.*Let the curves meet"):
            es.SweptSurface(short, profiles, cut_rails=choice)


def test_rails_may_cross_where_they_are_cut_off():
    first, second = line([0, 0, 0], [80, 0, 0]), line([0, 20, 0], [80, -5, 0])
    ends = [line([x, 0, 0], second.evaluate(x / 80)) for x in (0, 40)]
    with pytest.raises(ValueError, match="meet or cross near"):
        es.SweptSurface((first, second), ends, "rotate", largest_gap=60.0)
    cut = es.SweptSurface((first, second), ends, "rotate", cut_rails=True)
    assert "Rail 1 was cut by 40 mm" in cut.message


@pytest.mark.parametrize("model", ["blend", "rotate"])
@pytest.mark.parametrize("tolerance", [1e-1, 1e-3])
def test_the_b_spline_of_a_sweep_keeps_the_tolerance(model, tolerance):
    sweep = es.SweptSurface(*quarter_bend(), model)
    surface = sweep.to_bspline(tolerance)
    u, v = np.linspace(0, 1, 91)[:, None], np.linspace(0, 1, 87)
    miss = np.linalg.norm(surface.evaluate(u, v) - sweep.evaluate(u, v), axis=2)
    assert miss.max() <= 1.5 * tolerance


def test_equal_profiles_blended_are_an_exact_b_spline():
    rails, profiles = free_curves()
    shift = rails[0].evaluate(1.0) - rails[0].evaluate(0.0)
    parallel = es.BSplineCurve(
        rails[0].poles + (rails[1].evaluate(0.0) - rails[0].evaluate(0.0)), rails[0].knots
    )
    moved = es.BSplineCurve(profiles[0].poles + shift, profiles[0].knots)
    sweep = es.SweptSurface((rails[0], parallel), (profiles[0], moved))
    surface = sweep.to_bspline(1e-9)
    assert surface.poles.shape[:2] == (6, 6)
    assert np.allclose(
        surface.evaluate(SHARE[:, None], SHARE), sweep.evaluate(SHARE[:, None], SHARE), atol=1e-11
    )


def test_simpler_kinds_are_recognised():
    rails, profiles = quarter_bend()
    bend = es.SweptSurface(rails, profiles, "rotate")
    assert sweep_kinds(bend, 1e-3) == (SweepKind.PIPE, SweepKind.REVOLUTION)
    straight = [line([0, y, 0], [50, y, 0]) for y in (-10.0, 10.0)]
    ends = [arc([x, 0, 0], X, 10.0, -Y, 0.0, np.pi) for x in (0, 50)]
    assert sweep_kinds(es.SweptSurface(straight, ends), 1e-3) == (
        SweepKind.PIPE,
        SweepKind.EXTRUSION,
    )
    rails, _ = free_curves()
    chords = [line(rails[0].evaluate(t), rails[1].evaluate(t)) for t in (0.0, 1.0)]
    assert sweep_kinds(es.SweptSurface(rails, chords), 1e-3) == (SweepKind.RULED,)
    assert sweep_kinds(es.SweptSurface(*free_curves()), 1e-3) == ()


def test_a_sweep_that_runs_back_on_itself_is_said():
    rails = [arc([0, 0, 0], Z, radius, X) for radius in (4.0, 24.0)]
    wide = [
        es.BSplineCurve(poles, [0, 0, 0, 1, 1, 1], 2)
        for poles in (
            [[4, 0, 0], [-60, 0, -30], [24, 0, 0]],
            [[0, 4, 0], [0, -60, -30], [0, 24, 0]],
        )
    ]
    assert "runs back on itself" in es.SweptSurface(rails, wide, "rotate").message


def test_a_sweep_that_passes_through_itself_is_said():
    a = np.linspace(-0.6, np.pi + 0.6, 80)[:, None]  # half a figure of eight
    path = np.hstack([80 * np.sin(a), 40 * np.sin(2 * a), 4 * a])
    way = np.hstack([80 * np.cos(a), 80 * np.cos(2 * a), 0 * a])
    left = np.cross(Z, way) / np.linalg.norm(way, axis=1)[:, None]
    rails = [fit_curve(path + side * left, 1e-3).over_range(0.0, 1.0) for side in (-8.0, 8.0)]
    dishes = []
    for end in (0.0, 1.0):
        first, second = (rail.evaluate(end) for rail in rails)
        middle = (first + second) / 2 - 30 * Z
        dishes.append(es.BSplineCurve([first, middle, second], [0, 0, 0, 1, 1, 1], 2))
    said = es.SweptSurface(rails, dishes, "rotate").message
    near = re.search(r"passes through itself near \((.+), (.+), (.+)\)", said)
    assert np.hypot(*(float(x) for x in near.groups()[:2])) < 20


@pytest.mark.parametrize("turn, crosses", [(0.9, False), (1.4, True)])
def test_a_net_that_only_touches_does_not_cross(turn, crosses):
    """A tube whose seam meets, along an arc that runs into itself or does not."""
    u, v = np.linspace(0, 2 * np.pi * turn, 101)[:, None], np.linspace(0, 2 * np.pi, 21)
    ring = 30 + 5 * np.cos(v)
    lift = 5 * np.sin(v) + u  # the tube is 10 mm thick, and rises 6.3 mm in a turn
    grid = np.stack([ring * np.cos(u), ring * np.sin(u), lift], axis=2)
    assert (self_crossing(grid) is not None) == crosses


def test_what_makes_no_sweep_is_refused_with_the_gaps():
    rails, profiles = free_curves()
    far = free_curves(gap=3.0)[1]
    with pytest.raises(ValueError, match="profile 1: 3 and 3 mm; profile 2: 3 and 3 mm"):
        es.SweptSurface(rails, far)
    circle = circular_arc(Circle(np.zeros(3), Z, 5.0, X))
    with pytest.raises(ValueError, match="Rail 2 is closed"):
        es.SweptSurface((rails[0], circle), profiles)
    crossing = line([0, 25, 0], [60, -25, 0])
    with pytest.raises(ValueError, match="meet or cross near"):
        es.SweptSurface((line([0, 0, 0], [60, 0, 0]), crossing), profiles, largest_gap=100)
    with pytest.raises(ValueError, match="no sweep model 'twist'"):
        es.SweptSurface(rails, profiles, "twist")
    with pytest.raises(ValueError, match="no pairing 'near'"):
        es.SweptSurface(rails, profiles, pairing="near")
    with pytest.raises(ValueError, match="one or two rails, not 3"):
        es.SweptSurface([*rails, rails[0]], profiles)
    with pytest.raises(ValueError, match="needs 2 or more profiles, not 1"):
        es.SweptSurface(rails, profiles[:1])
    with pytest.raises(ValueError, match="blend model takes two rails and two profiles"):
        es.SweptSurface(rails[:1], profiles)
    with pytest.raises(ValueError, match="tolerance is 0 mm"):
        sweep_kinds(es.SweptSurface(rails, profiles), 0)
