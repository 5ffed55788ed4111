# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scanned box, and the network of its edges."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import FreeCADGui as Gui
import numpy as np
import Part
import pytest

import freecad_edgescan as es
from freecad_edgescan import document
from freecad_edgescan.document.network_search import NetworkSearch, keep_network

from .steps import PITCH, SIZE, found, networks


@pytest.fixture(scope="module")
def box_points() -> Any:
    return document.simulate_cloud(Part.makeBox(*SIZE), PITCH, 0.05).points


@pytest.fixture(scope="module")
def box_network(box_points: Any) -> es.EdgeNetwork:
    """Its edges, found once; points of documents have single precision."""
    return es.find_edges(es.PointCloud(box_points.astype(np.float32)))


@pytest.fixture
def box(window: Any, box_points: Any) -> Any:
    """A scanned box in place of the roof, whose edges nobody has looked for."""
    window.doc.UndoMode = 1
    window.doc.removeObject(window.cloud.Name)
    document.make_cloud(window.doc, box_points)
    window.doc.recompute()
    window.doc.clearUndos()
    window.view.fitAll()
    window.settle()
    return window


@pytest.fixture
def known(box: Any, box_network: es.EdgeNetwork) -> Any:
    """The same box, whose edges were found before, so that no test waits for that."""
    numbers = document.point_cloud(box.cloud)
    assert np.array_equal(numbers.points, box_network.cloud.points)
    keep_network(NetworkSearch(), replace(box_network, cloud=numbers))
    return box


@pytest.fixture
def recorded(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Lines that FreeCAD records."""
    lines: list[str] = []
    run = Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (lines.append(line), run(line)))
    return lines


@pytest.fixture
def network(known: Any) -> Any:
    found(known)
    known.ok()
    return networks(known)[0]
