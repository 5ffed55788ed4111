# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scans of an exact machine have the error of the analytical model."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.experiments import model_scans
from freecad_edgescan.experiments.doe_choices import compare_choices
from freecad_edgescan.experiments.model_scans import over_the_model


@pytest.mark.parametrize(("share", "points"), [(0.2, 10), (0.5, 10), (0.8, 10), (0.5, 20)])
@pytest.mark.parametrize("degree", [1, 2])
def test_a_square_scan_has_the_error_of_the_model(degree, share, points) -> None:
    """On the average of where the points fall beside the edge.

    Straight lines on arcs of 46° lie a millimetre off the edge and scatter by a fifth of that from
    line to line; of them only the average is held against the model.
    """
    found = [over_the_model((degree, share, points + place)) for place in (0.0, 0.25, 0.5, 0.75)]
    assert np.mean(found) == pytest.approx(1.0, abs=0.1)
    if (degree, share) != (1, 0.8):
        assert np.array(found) == pytest.approx(1.0, abs=0.2)


class Until:
    """Cancels at a share."""

    def __init__(self, end: float) -> None:
        self.end, self.told = end, [0.0]

    def update(self, fraction: float, so_far: object) -> bool:
        self.told.append(fraction)
        return fraction < self.end


def made_up(case: tuple[int, float, float]) -> float:
    degree, share, points = case
    if points > 20.8:
        raise ValueError("lost")
    return degree + share + 0.01 * points


@pytest.fixture
def without_scans(monkeypatch) -> None:
    monkeypatch.setattr(model_scans, "over_the_model", made_up)


def test_the_comparison_shows_the_mean_over_the_places(without_scans) -> None:
    progress = Until(2.0)
    figures = compare_choices("model", jobs=1, progress=progress)
    assert progress.told == sorted(progress.told)
    assert progress.told[-1] == 1.0
    middle = float(np.mean(model_scans.PLACES))
    for degree, figure in zip((1, 2), figures, strict=True):
        assert f"degree {degree}" in figure.title
        ten, twenty, forty = figure.curves
        expected = degree + np.array(model_scans.SHARES) + 0.01 * (10 + middle)
        assert ten.y == pytest.approx(expected)
        # One scan that failed leaves no mean.
        assert np.isnan(twenty.y).all()
        assert np.isnan(forty.y).all()
        assert "45 of 120 scans are missing" in figure.notes[-1]


def test_a_cancelled_comparison_shows_what_is_complete(without_scans) -> None:
    (figure,) = compare_choices("model", jobs=1, progress=Until(0.4))
    assert "degree 1" in figure.title
    assert np.isfinite(figure.curves[0].y).sum() == 4
    assert compare_choices("model", jobs=1, progress=Until(0.0)) == ()
