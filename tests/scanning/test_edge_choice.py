# SPDX-License-Identifier: LGPL-2.1-or-later
"""Choosing among the edges of a box: by figures, by hand, and again when it is scanned anew."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.scanning.each_edge import scan_each
from freecad_edgescan.scanning.edge_choice import (
    EdgeChoice,
    nearest_edges,
    turn_of,
)

SIZE = np.array([24.0, 18.0, 12.0])
PITCH = 0.5
TOP_FRONT = np.array([12.0, 0.0, 12.0])  # the middle of an edge along x


@pytest.fixture(scope="module")
def network(strewn_box: Callable[..., es.PointCloud]) -> es.EdgeNetwork:
    return es.find_edges(strewn_box(SIZE, PITCH, 0.1 * PITCH, 0))


@pytest.fixture(scope="module")
def scanned_anew(strewn_box: Callable[..., es.PointCloud]) -> es.EdgeNetwork:
    return es.find_edges(strewn_box(SIZE, PITCH, 0.1 * PITCH, 1))


def lengths(network: es.EdgeNetwork) -> list[float]:
    """True lengths of the edges of a network."""
    return sorted(float(SIZE[np.ptp(edge.points, axis=0).argmax()]) for edge in network.edges)


def test_nothing_asked_for_keeps_all_edges(network: es.EdgeNetwork) -> None:
    assert lengths(network) == [12.0] * 4 + [18.0] * 4 + [24.0] * 4
    assert EdgeChoice().of(network) is network


def test_short_edges_are_left_out_and_the_others_stay_where_they_are(
    network: es.EdgeNetwork,
) -> None:
    part = EdgeChoice(min_length=14.0).of(network)
    assert lengths(part) == [18.0] * 4 + [24.0] * 4
    assert all(edge in network.edges for edge in part.edges)
    assert len(part.corners) == 8
    assert "8 of 12" in part.message


def test_turn_and_sigma_leave_out_edges_too(network: es.EdgeNetwork) -> None:
    turns = [turn_of(edge) for edge in network.edges]
    assert np.degrees(turns) == pytest.approx(90.0, abs=1.0)
    assert not EdgeChoice(min_angle=1.7).mask(network.edges, PITCH).any()
    sigma = np.array([np.median(edge.sigma) for edge in network.edges])
    mask = EdgeChoice(max_sigma=float(np.median(sigma))).mask(network.edges, PITCH)
    assert np.array_equal(mask, sigma <= np.median(sigma)) and 0 < mask.sum() < 12


def test_corners_of_a_part_are_those_in_which_its_edges_end(network: es.EdgeNetwork) -> None:
    number = int(nearest_edges(network.edges, TOP_FRONT, PITCH)[0])
    part = network.part(np.arange(len(network)) == number)
    assert part.ends == ((0, 1),) or part.ends == ((1, 0),)
    found = part.corners[np.argsort(part.corners[:, 0])]
    assert np.abs(found - [[0.0, 0.0, 12.0], [24.0, 0.0, 12.0]]).max() < PITCH
    assert part.corner_covariance.shape == (2, 3, 3) and len(part.passing) == 2


def test_an_edge_dropped_by_hand_is_gone_also_when_the_part_is_scanned_anew(
    network: es.EdgeNetwork, scanned_anew: es.EdgeNetwork
) -> None:
    number = int(nearest_edges(network.edges, TOP_FRONT, PITCH)[0])
    choice = EdgeChoice().toggled(network.edges, number, PITCH)
    for every in (network, scanned_anew):
        part = choice.of(every)
        assert len(part) == 11
        assert len(nearest_edges(part.edges, TOP_FRONT, PITCH)) == 0


def test_two_clicks_change_nothing_and_a_click_outweighs_the_figures(
    network: es.EdgeNetwork,
) -> None:
    edges = network.edges
    number = int(nearest_edges(edges, TOP_FRONT, PITCH)[0])
    once = EdgeChoice().toggled(edges, number, PITCH)
    twice = once.toggled(edges, number, PITCH)
    assert (len(once.dropped), len(twice.dropped), len(twice.kept)) == (1, 0, 0)
    only_one = EdgeChoice(min_length=100.0).toggled(edges, number, PITCH)
    assert np.flatnonzero(only_one.mask(edges, PITCH)).tolist() == [number]
    assert not only_one.toggled(edges, number, PITCH).mask(edges, PITCH).any()


def test_a_place_on_no_edge_means_none(network: es.EdgeNetwork) -> None:
    beside = TOP_FRONT + np.array([0.0, 5.0, 0.0])
    assert EdgeChoice(dropped=beside[None]).of(network) is network
    assert len(nearest_edges((), TOP_FRONT, PITCH)) == 0


def test_every_edge_scanned_by_itself_is_the_true_one(network: es.EdgeNetwork) -> None:
    scanned = scan_each(network.cloud, network.edges)
    assert len(scanned) == 12
    place, first = scanned[0]
    assert np.array_equal(es.scan_edge(network.cloud, at=place).points, first.points)
    for _, edge in scanned:
        away = np.sort(np.minimum(np.abs(edge.points), np.abs(edge.points - SIZE)), axis=1)
        assert np.hypot(away[:, 0], away[:, 1]).max() < PITCH


def test_an_edge_in_two_parts_is_scanned_once(network: es.EdgeNetwork) -> None:
    number = int(nearest_edges(network.edges, TOP_FRONT, PITCH)[0])
    edge = network.edges[number]
    assert len(scan_each(network.cloud, [edge, edge.reversed()])) == 1


def test_scanning_each_edge_can_be_cancelled(network: es.EdgeNetwork) -> None:
    class Cancelling:
        def update(self, fraction: float, so_far: object) -> bool:
            return len(so_far) < 2  # type: ignore[arg-type]

    assert len(scan_each(network.cloud, network.edges, Cancelling())) == 2
