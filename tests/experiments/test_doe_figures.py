# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures: what they show follows from what they say."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from freecad_edgescan.cloud import TorusObject
from freecad_edgescan.experiments.doe_choices import compare_choices
from freecad_edgescan.experiments.doe_curves import Curve, Curves, draw_curves
from freecad_edgescan.experiments.doe_figures import make_figure
from freecad_edgescan.experiments.scan_figures import printed_trial
from freecad_edgescan.experiments.tangent_figures import tangent_errors

TWO = Curves(
    "Two curves",
    "place, mm",
    "height, mm",
    (
        Curve.of("first", [1.0, 2.0, 3.0], [0.5, np.nan, 0.25]),
        Curve.of("second", [2.0, 4.0], [7.0, 8.0], measured=True),
    ),
    notes=("A note.",),
)


def test_a_table_has_a_row_for_each_place_and_gaps_where_nothing_is_known() -> None:
    lines = TWO.table().splitlines()
    assert lines[:3] == ["Two curves", "place, mm | height, mm", lines[2]]
    assert lines[2].split() == ["first", "second"]
    assert [line.split() for line in lines[3:7]] == [
        ["1", "0.5", "-"],
        ["2", "-", "7"],
        ["3", "0.25", "-"],
        ["4", "-", "8"],
    ]
    assert lines[7:] == ["A note."]


def test_long_tables_are_thinned_out() -> None:
    places = np.arange(1000.0)
    long = Curves("Long", "x", "y", (Curve.of("all", places, places**2),))
    rows = long.table().splitlines()[3:]
    assert 12 <= len(rows) <= 24
    assert all(float(row.split()[1]) == float(row.split()[0]) ** 2 for row in rows[:3])


def test_figures_are_drawn_below_each_other(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    draw_curves((TWO,), tmp_path / "one.png")
    draw_curves((TWO, TWO), tmp_path / "two.png")
    heights = [
        int.from_bytes((tmp_path / f"{name}.png").read_bytes()[20:24], "big")
        for name in ("one", "two")
    ]
    assert 1.8 < heights[1] / heights[0] < 2.2


def test_the_object_printed_with_the_figures_has_line_sections_of_the_length_said() -> None:
    row = printed_trial(0.4, 0.05)
    assert row.section_radius - row.probe_radius == 50.0
    assert (row.amplitude - row.object.rounding_length) / 2 == pytest.approx(20.0)
    assert row.tolerance == 0.25
    assert row.object == TorusObject(50.5, 250.0, np.pi / 2, 0.0, 0.5)


def test_the_angle_of_a_tangent_is_measured_from_the_circle() -> None:
    azimuth = np.linspace(0.2, 2.9, 7)
    x, y = 35 * np.cos(azimuth), 35 * np.sin(azimuth)
    points = np.column_stack([x, y, np.full(7, -10.0)])
    turned = azimuth + np.pi / 2 + np.radians(np.arange(7))
    tangents = np.column_stack([np.cos(turned), np.sin(turned), np.zeros(7)])
    np.testing.assert_allclose(tangent_errors(points, tangents), np.arange(7), atol=1e-6)


@pytest.mark.parametrize("number", ["5.2", "5.3", "5.4", "5.5", "D.9", "D.10", "D.11", "D.12"])
def test_the_analytical_error_grows_with_the_length_of_a_line_section(number: str) -> None:
    (figure,) = make_figure(number)
    assert number in figure.title
    for curve in figure.curves:
        assert np.all(np.diff(curve.y) > 0.0), curve.name
        assert np.isfinite(curve.y).all()


def test_sharper_angles_and_larger_radii_make_the_analytical_error_larger() -> None:
    """As Schreve 5.2.4 says of figures 5.3 to 5.5."""
    for number, order in (("5.3", -1), ("5.4", 1), ("5.5", 1)):
        (figure,) = make_figure(number)
        last = np.array([curve.y[-1] for curve in figure.curves])
        assert np.all(order * np.diff(last) > 0.0), number


def test_there_is_no_other_figure() -> None:
    with pytest.raises(ValueError, match=r"D\.12.*5\.6"):
        make_figure("5.1")
    with pytest.raises(ValueError, match="compensation, tangent, model"):
        compare_choices("colour")
