# SPDX-License-Identifier: LGPL-2.1-or-later
"""No confident wrong edge on wedges at random; and that a wrong one would be seen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from freecad_edgescan.experiments import wedge_search
from freecad_edgescan.experiments.random_steps import make_step
from freecad_edgescan.experiments.random_wedges import SPOILT, make_wedge
from freecad_edgescan.experiments.wedge_search import (
    by_chance,
    judge,
    scanned_again,
    search,
    wedge_table,
)
from freecad_edgescan.scanning import ScanError, scan_edge


@pytest.fixture(scope="module")
def sharp():
    return search(64, "sharp wedges", jobs=1)


def test_no_sharp_edge_is_farther_off_than_stated(sharp) -> None:
    assert not any(judged.wrong for judged in sharp)
    assert sum(judged.refused for judged in sharp) < 0.05 * len(sharp)


def test_sigmas_of_sharp_edges_are_true_however_the_cloud_is_spoilt(sharp) -> None:
    """A two-dimensional normal distribution: median 1.18, 95 % below 2.45; by each point alone."""
    assert {judged.shape.spoilt for judged in sharp} == set(SPOILT)
    found = np.concatenate([judged.reserve * judged.distances for judged in sharp])
    assert 0.95 < np.median(found) < 1.5
    assert np.percentile(found, 95) < 3.2


def test_no_rounded_edge_is_farther_off_than_stated() -> None:
    assert not any(judged.wrong for judged in search(30, first=200, jobs=1))


@pytest.mark.parametrize("number", [283, 415, 506, 543])
def test_no_wedge_is_wrong_in_most_of_its_scans(number: int) -> None:
    """Sides of six to eight pitches beside a rounding half as wide, in noise of 0.3 pitches."""
    again = [judge(("wedges", number, sample)) for sample in range(1, 6)]
    assert sum(judged.wrong for judged in again) <= 2


@pytest.mark.parametrize("made", [make_wedge(1883, rounded=True), make_step(271)])
def test_a_wide_rounding_in_much_noise_is_no_side(made: tuple) -> None:
    """Its arc and the side behind it were taken for two sides, and an edge stated between them."""
    _, cloud, click, _ = made
    with pytest.raises(ScanError, match="it is a rounding, and no side"):
        scan_edge(cloud, at=click)


def test_a_wedge_is_what_it_says() -> None:
    """Points of its sides, away from a rounding, lie on two planes through its edge."""
    for number in range(40):
        wedge, cloud, click, edge = make_wedge(number, rounded=True)
        if wedge.spoilt == "outliers":
            continue
        off = edge.residuals(cloud.points) / wedge.pitch
        flat = np.linalg.norm(off, axis=1) > wedge.rounding / np.tan(0.5 * wedge.angle) + 3.0
        between = off[flat].mean(axis=0)
        aside = np.cross(edge.direction, between)
        turn = np.arctan2(off[flat] @ aside, off[flat] @ between)
        found = np.median(turn[turn > 0.0]) - np.median(turn[turn < 0.0])
        assert found == pytest.approx(wedge.angle, abs=0.03)
        assert np.linalg.norm(edge.residuals(click[None])) < 5.0 * wedge.pitch
        again = make_wedge(number, rounded=True)[1]
        assert np.array_equal(again.points, cloud.points)


def test_another_scan_of_a_wedge_has_other_points_of_the_same_sides() -> None:
    for number in range(10):
        wedge, cloud, _, _ = make_wedge(number, rounded=True)
        again, other, click, _ = make_wedge(number, rounded=True, sample=3)
        assert again == wedge
        assert not np.isin(other.points, cloud.points).any()
        _, same, same_click, _ = make_wedge(number, rounded=True, sample=3)
        assert np.array_equal(same.points, other.points)
        assert np.array_equal(same_click, click)
    found = search(2, "sharp wedges", first=5, jobs=1)
    again = scanned_again(found, "sharp wedges", times=3, jobs=1)
    assert [judged.shape.number for judged in again] == [5, 5, 5, 6, 6, 6]
    assert len({judged.errors.sum() for judged in [*found, *again]}) == 8


def test_what_is_wrong_by_chance_is_told_from_what_is_mostly_wrong() -> None:
    right = judge(("sharp wedges", 0, 0))
    wrong = replace(right, distances=right.distances + 8.0)
    other = replace(right, shape=replace(right.shape, number=1))
    said = by_chance([right, right, wrong, *[replace(wrong, shape=other.shape)] * 2, other])
    assert said == (
        "These 2 wedges scanned 3 times more, with other points: 3 of 6 scans are farther off than "
        "stated; more than half of its scans are with 1 of the wedges: 1."
    )


def test_an_edge_that_is_farther_off_than_stated_is_told() -> None:
    judged = judge(("sharp wedges", 0, 0))
    assert not judged.wrong
    wrong = replace(judged, distances=judged.distances + 8.0, reserve=2.0)
    one = replace(judged, distances=np.append(np.ones(20), 7.5))
    assert wrong.wrong
    assert wrong.elsewhere
    assert one.wrong
    assert not one.elsewhere
    text = wedge_table([judged, wrong, one, replace(judged, distances=np.zeros(0))])
    assert text.count("wedge 0:") == 2
    half = float(np.median(np.concatenate([judged.distances, wrong.distances, one.distances])))
    alone = [
        judged.reserve * judged.distances,
        2.0 * wrong.distances,
        judged.reserve * one.distances,
    ]
    half_alone = float(np.median(np.concatenate(alone)))
    assert half_alone > 1.2 * half
    assert f"median {half:.2f}," in text
    assert f"short edges: {half_alone:.2f}," in text
    assert "4 wedges: 1 refused, 2 farther off than stated, 1 of these somewhere else." in text


def test_a_scan_that_fails_is_no_refusal(monkeypatch) -> None:
    def broken(task: tuple[str, int, int]) -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(wedge_search, "judge", broken)
    with pytest.raises(RuntimeError, match="wedges, number 7"):
        search(1, first=7, jobs=1)
