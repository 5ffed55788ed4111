# SPDX-License-Identifier: LGPL-2.1-or-later
"""Schreve appendices H and I, and the comparison of 6.5.2 on test 2S1.11."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.experiments.doe_design import trial
from freecad_edgescan.experiments.published_surfaces import PublishedSurface, published_surface
from freecad_edgescan.experiments.surface_route import published_route, surface_route
from freecad_edgescan.experiments.surface_tables import at_the_joint, surface_tables


def test_table_3_comes_out_to_every_printed_digit():
    original = published_surface(PublishedSurface.ORIGINAL)
    printed = published_surface(PublishedSurface.EXTENDED_BY_SHETTY_AND_WHITE)
    longer = es.extend_surface(original, "v0", 0.25, tau=1.0)
    assert longer.knots[1][0] == -0.5
    assert np.allclose((longer.knots[1] + 0.5) / 2.5, printed.knots[1])
    assert np.abs(longer.poles - printed.poles).max() <= 0.0005
    assert np.abs(longer.weights - printed.weights).max() <= 0.0005


def test_the_rule_printed_with_table_3_gives_other_weights():
    original = published_surface(PublishedSurface.ORIGINAL)
    by_rule, by_nine = (es.extend_surface(original, "v0", 0.25, tau) for tau in (None, 9.0))
    assert np.allclose(by_rule.weights, by_nine.weights)
    assert np.allclose(by_rule.weights[:, 0], [2.5, 1, 1, 2.5])


def test_table_4_is_reached_on_both_sides():
    longer = es.extend_surface(published_surface(PublishedSurface.ORIGINAL), "v0", 0.25, tau=1.0)
    for side in at_the_joint(longer):
        assert np.allclose(side, [12, 0, 13.8], atol=1e-12)


def test_autocads_extension_has_a_crease():
    surface = published_surface(PublishedSurface.EXTENDED_BY_AUTOCAD)
    before, after = at_the_joint(surface)
    assert np.allclose(after, [12, 0, 13.8])
    cosine = before @ after / np.linalg.norm(before) / np.linalg.norm(after)
    assert np.degrees(np.arccos(cosine)) > 8


def test_the_printed_fits_lie_on_the_tori_of_the_test_object():
    # 2S1.11 without its rounding and probe: those of the printed surfaces
    sharp = replace(trial(2, 11).object, fillet_radius=0.0, probe_radius=0.0)
    outer, inner = sharp.faces(4.0)
    u, v = np.meshgrid(np.linspace(0, 1, 100), np.linspace(0, 1, 100))
    for which, face, error in (
        (PublishedSurface.OUTER, outer, 0.010),
        (PublishedSurface.INNER, inner, 0.018),
    ):
        x = published_surface(which).evaluate(u, v).reshape(-1, 3)
        rho = np.hypot(x[:, 0], x[:, 1]) - face.major_radius
        off = np.abs(np.hypot(rho, x[:, 2] - face.centre_height) - face.section_radius)
        assert off.mean() == pytest.approx(error, abs=0.001)


def test_the_printed_surfaces_extended_meet_a_tenth_of_a_millimetre_off_the_edge():
    route = published_route()
    assert route.average == pytest.approx(0.107, abs=0.0015)
    assert route.maximum == pytest.approx(0.267, abs=0.001)
    assert route.curve.length == pytest.approx(np.pi * 35.0, rel=0.02)


def test_our_own_fits_to_such_a_cloud_meet_nearer_to_the_edge_than_published():
    assert surface_route().average < 0.08


def test_all_of_it_is_printed_beside_what_was_published():
    text = surface_tables()
    joint = text.split("Shetty and White, ours")[1].splitlines()[0]
    assert joint.count("(12.0, 0.0, 13.8)") == 2
    rows = {line[:30]: [float(x) for x in line[54:].split()] for line in text.splitlines()[-4:]}
    printed, ours, lines, patches = rows.values()
    assert printed == pytest.approx([0.107, 0.267], abs=0.0015)
    assert ours[0] < 0.08 and patches[0] < 0.08 and lines[0] < 0.094
