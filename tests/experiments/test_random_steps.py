# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two edges beside a narrow land: the clouds are what they say, and no edge is stated elsewhere."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.experiments.random_steps import make_step
from freecad_edgescan.experiments.wedge_search import judge, search


def test_no_step_is_found_somewhere_else() -> None:
    found = search(24, "steps", first=1000, jobs=1)
    assert not any(judged.elsewhere for judged in found)
    assert sum(judged.refused for judged in found) < 0.3 * len(found)
    distances = np.concatenate([judged.reserve * judged.distances for judged in found])
    assert 0.9 < np.median(distances) < 1.5
    assert np.percentile(distances, 95) < 3.2


@pytest.mark.parametrize("number", [326, 285])
def test_no_step_is_found_somewhere_else_in_most_of_its_scans(number: int) -> None:
    """A land between two roundings, and one of a pitch between an edge and a rounding."""
    again = [judge(("steps", number, sample)) for sample in range(5)]
    assert sum(judged.elsewhere for judged in again) <= 1


def test_a_step_is_what_it_says() -> None:
    """Round a sharp edge beside a wide land, points lie in two planes that turn by what is said."""
    wide = 0
    for number in range(60):
        step, cloud, _, edges = make_step(number)
        for k, beside in ((0, step.first), (1, step.last)):
            if step.roundings[k] or step.land < 5.0:
                continue
            wide += 1
            off = edges.lines[k].residuals(cloud.points) / step.pitch
            away = np.linalg.norm(off, axis=1)
            ring = off[(away > 2.0) & (away < min(beside, 0.85 * step.land - 0.5))]
            between = ring.mean(axis=0)
            aside = np.cross(edges.lines[k].direction, between)
            turn = np.arctan2(ring @ aside, ring @ between)
            found = np.median(turn[turn > 0.0]) - np.median(turn[turn < 0.0])
            assert np.pi - found == pytest.approx(abs(step.turns[k]), abs=0.06)
    assert wide > 10


def test_a_rounding_takes_its_edge_away_by_what_its_radius_says() -> None:
    for number in range(40):
        step, cloud, click, edges = make_step(number)
        for line, turn, radius in zip(edges.lines[:2], step.turns, step.roundings, strict=True):
            gap = radius * (1.0 / np.cos(0.5 * abs(turn)) - 1.0)
            nearest = np.linalg.norm(line.residuals(cloud.points), axis=1).min() / step.pitch
            assert nearest == pytest.approx(gap, abs=0.35 + 4.0 * step.noise)
        away = [np.linalg.norm(line.residuals(click[None])) for line in edges.lines]
        assert min(away) < 12.0 * step.pitch


def test_the_edge_that_a_chamfer_has_taken_away_is_one_too() -> None:
    for number in range(40):
        step, _, _, edges = make_step(number)
        assert (len(edges.lines) == 3) == (step.turns[0] * step.turns[1] > 0.0)
        if len(edges.lines) == 3:
            # The first face holds its own edge and the chamfer's; so does the last one.
            first, last, chamfered = (line.point for line in edges.lines)
            turns = [
                np.cross(chamfered - first, edges.lines[0].direction),
                np.cross(last - chamfered, edges.lines[0].direction),
            ]
            cosine = turns[0] @ turns[1] / np.linalg.norm(turns[0]) / np.linalg.norm(turns[1])
            assert np.arccos(cosine) == pytest.approx(abs(sum(step.turns)), abs=1e-6)


def test_another_scan_of_a_step_has_other_points() -> None:
    step, cloud, _, _ = make_step(3)
    again, other, _, _ = make_step(3, sample=1)
    assert step == again
    assert not np.isin(other.points, cloud.points).any()
    assert np.array_equal(make_step(3)[1].points, cloud.points)
