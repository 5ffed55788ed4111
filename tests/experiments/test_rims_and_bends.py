# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tight bends are scanned without a bias, and the table says what was measured."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.experiments.rims_and_bends import (
    BEND,
    BOX,
    ROUNDED_BOX,
    ExactEdge,
    exact_edge_table,
    measure_exact_edges,
)
from freecad_edgescan.scanning import ScanError


def test_bends_of_three_amplitudes_are_scanned_without_a_bias() -> None:
    """Between sides that turn by 0.7 rad within half an amplitude, too."""
    told = []

    class Listening:
        def update(self, fraction: float, so_far: object) -> bool:
            told.append(fraction)
            return True

    edges = measure_exact_edges((BEND,), Listening())
    assert len(edges) == 6
    for edge in edges:
        assert len(edge.errors) > 3 * 90  # of three halves of a circle of R 30, 1 mm apart
        assert edge.bias < 0.3 * edge.sigma
        assert np.sqrt(np.mean(edge.errors**2)) < 1.5 * np.sqrt(np.mean(edge.sigmas**2))
    assert told == sorted(told) and told[-1] == 1.0


def test_a_measurement_that_is_stopped_keeps_what_is_done() -> None:
    class Impatient:
        def update(self, fraction: float, so_far: object) -> bool:
            return False

    assert len(measure_exact_edges((BEND,), Impatient())) == 1


def test_what_is_not_found_is_no_number(monkeypatch) -> None:
    def nothing(*given, **named):
        raise ScanError("nothing here")

    monkeypatch.setattr("freecad_edgescan.experiments.rims_and_bends.scan_edge", nothing)
    edges = measure_exact_edges((BEND,))
    assert len(edges) == 6
    for edge in edges:
        assert np.isnan([edge.average, edge.maximum, edge.sigma, edge.bias]).all()
    assert exact_edge_table(edges).count("nan") == 6 * 3


@pytest.mark.parametrize(
    ("kind", "title"),
    [
        (BOX, "core box, rim 1"),
        (ROUNDED_BOX, "core box rounded by 0.8, rim 1"),
        (BEND, "bend of R 30, rim 1"),
    ],
)
def test_a_row_of_the_table_says_what_was_measured(kind, title) -> None:
    edge = ExactEdge(kind, "rim 1", np.array([0.01, 0.03]), np.array([0.004, 0.006]), 0.0012, 0.81)
    row = exact_edge_table([edge]).splitlines()[1]
    assert row.startswith(title + " ")
    assert row[39:].split() == ["2", "0.0200", "0.0300", "0.0050", "0.0012", "0.81"]
