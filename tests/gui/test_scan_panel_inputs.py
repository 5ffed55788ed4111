# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clicks, gates and parameters of the scan panel, and what they lead to."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

from freecad_edgescan.document.scan_inputs import ScanInputs  # noqa: E402
from freecad_edgescan.gui.picked_places import PickedPlaces, Way  # noqa: E402
from freecad_edgescan.gui.scan_job import ScanJob  # noqa: E402
from freecad_edgescan.scanning import Gate, ScanError, Start, Stop  # noqa: E402

from .conftest import roof  # noqa: E402

SLOPE = 0.8


def on_the_roof(x: float, y: float) -> tuple[float, float, float]:
    return (x, y, 5.0 - SLOPE * abs(x))


def ends_along(edge: Any) -> tuple[float, float]:
    """From where to where along the ridge an edge object reaches."""
    y = [point.y for point in edge.Points]
    return min(y), max(y)


def test_a_second_click_is_a_gate_when_that_is_chosen(window: Any) -> None:
    window.open_panel()
    window.panel.form.choose_way(Way.TO_A_GATE)
    window.click(on_the_roof(0.3, -8.0))
    window.found()
    assert "end" in window.sentence
    window.click(on_the_roof(0.3, 6.0))
    window.wait_until(lambda: "OK keeps this edge" in window.sentence)
    window.ok()
    (edge,) = window.edges
    low, high = ends_along(edge)
    assert edge.UseGate
    assert low == pytest.approx(-8.0, abs=0.6)
    assert high == pytest.approx(6.0, abs=0.6)


def test_three_clicks_are_a_start_and_two_more_a_gate(window: Any) -> None:
    window.view.viewTop()
    window.view.fitAll()
    window.settle()
    window.open_panel()
    window.panel.form.choose_way(Way.START_AND_GATE)
    for number, place in enumerate([(4.0, -8.0), (-4.0, -8.0), (4.0, -4.0)], start=1):
        assert window.sentence.startswith(f"{number} of 3")
        window.click(on_the_roof(*place))
    window.found()
    assert window.sentence.startswith("Gate, 1 of 2")
    window.click(on_the_roof(4.0, 6.0))
    window.click(on_the_roof(-4.0, 6.0))
    window.wait_until(lambda: "OK keeps this edge" in window.sentence)
    window.picture("scan_edge_start_and_gate")
    window.ok()
    (edge,) = window.edges
    low, high = ends_along(edge)
    assert edge.Stops == ["START", "GATE"]
    assert low == pytest.approx(-8.0, abs=0.6)
    assert high == pytest.approx(6.0, abs=0.6)
    assert FreeCAD.Vector(edge.Across).x == pytest.approx(-1.0, abs=0.1)


def test_three_clicks_that_tell_no_direction_are_refused_with_a_sentence(window: Any) -> None:
    window.open_panel()
    window.panel.form.choose_way(Way.START_AND_GATE)
    for _ in range(3):
        window.click(on_the_roof(4.0, -8.0))
    assert "no length" in window.sentence
    assert not window.button("Ok").isEnabled()


def test_every_parameter_shows_its_value_and_why(window: Any) -> None:
    window.open_panel()
    window.click(on_the_roof(0.3, 2.0))
    window.found()
    row = window.panel.form.parameters.row("edge_pitch")
    assert not row.own and row.editor.isReadOnly()
    assert "cloud pitch" in row.reason.text()
    assert row.value() == pytest.approx(2 * 0.25, rel=0.1)


def test_a_changed_parameter_scans_the_preview_again_and_reset_takes_it_back(window: Any) -> None:
    window.open_panel()
    window.click(on_the_roof(0.3, 2.0))
    window.found()
    automatic = window.panel._found.edge
    row = window.panel.form.parameters.row("edge_pitch")
    row.tick.click()
    row.box.widget.setProperty("rawValue", 2.0)
    window.wait_until(lambda: not window.button("Ok").isEnabled())
    window.found()
    assert window.panel._found.edge.parameters.edge_pitch == 2.0
    assert len(window.panel._found.edge) < len(automatic) / 3
    window.panel.form.tabs.setCurrentIndex(1)
    window.picture("scan_edge_parameters")
    window.panel.form.parameters._reset.click()
    window.wait_until(lambda: not window.button("Ok").isEnabled())
    window.found()
    assert not row.own
    assert np.array_equal(window.panel._found.edge.points, automatic.points)


def test_a_value_that_cannot_work_is_answered_by_a_sentence_and_can_be_mended(window: Any) -> None:
    window.open_panel()
    window.click(on_the_roof(0.3, 2.0))
    window.found()
    row = window.panel.form.parameters.row("edge_pitch")
    row.tick.click()
    row.box.widget.setProperty("rawValue", 0.05)
    window.wait_until(lambda: "below the cloud pitch" in window.sentence)
    assert not window.button("Ok").isEnabled()
    row.box.widget.setProperty("rawValue", 1.0)
    window.found()
    window.ok()
    assert window.edges[0].EdgePitch.Value == 1.0


def test_a_probed_scan_can_be_chosen(window: Any) -> None:
    window.open_panel()
    form = window.panel.form.parameters
    form._method.setCurrentIndex(1)
    window.click(on_the_roof(0.3, 2.0))
    window.found()
    assert form.row("degree").reason.text()
    window.ok()
    (edge,) = window.edges
    assert edge.Method == "probe"
    assert np.abs([(p.x, p.z - 5.0) for p in edge.Points]).max() < 0.1


def test_stop_here_keeps_what_is_there_and_can_be_had_again(
    window: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    from freecad_edgescan.gui.background import Background
    from freecad_edgescan.gui.scan_edge_panel import ScanEdgePanel

    show, update, stopped = ScanEdgePanel.show_report, Background.update, threading.Event()

    def show_and_stop(panel: Any, edge: Any) -> None:
        show(panel, edge)
        panel.form.stop.click()
        stopped.set()

    def report_and_wait(work: Any, fraction: float, so_far: object) -> bool:
        update(work, fraction, so_far)
        stopped.wait(10.0)  # the walk is quicker than a hand
        return bool(update(work, fraction, so_far))

    monkeypatch.setattr(ScanEdgePanel, "show_report", show_and_stop)
    monkeypatch.setattr(Background, "update", report_and_wait)
    window.open_panel()
    window.click(on_the_roof(0.3, 0.0))
    window.found()
    assert "gate" in window.sentence
    window.ok()
    (edge,) = window.edges
    points = [tuple(point) for point in edge.Points]
    assert 3 <= len(points) < 40
    edge.InputHash = ""
    edge.touch()
    window.doc.recompute()
    assert [tuple(point) for point in edge.Points] == points


def test_opening_the_panel_is_no_change_of_parameters(
    window: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun: list[Any] = []
    run = ScanJob.__call__
    monkeypatch.setattr(
        ScanJob, "__call__", lambda job, progress: begun.append(job) or run(job, progress)
    )
    window.open_panel()
    window.click(on_the_roof(0.3, 0.0))
    window.found()
    window.pass_time(0.6)  # longer than a change of a parameter waits for the next one
    assert len(begun) == 1


class StopsAfter:
    """A progress that cancels after some updates."""

    def __init__(self, patience: int) -> None:
        self.patience = patience

    def update(self, fraction: float, so_far: object) -> bool:
        self.patience -= 1
        return self.patience > 0


@pytest.mark.parametrize("patience", [1, 3, 4])
def test_wherever_a_scan_is_stopped_its_inputs_lead_to_the_same_edge(patience: int) -> None:
    from freecad_edgescan.cloud import PointCloud

    cloud = PointCloud(roof())
    inputs = ScanInputs(np.array([0.3, 5.0, 5.0]))
    found = ScanJob(cloud, inputs)(StopsAfter(patience))
    assert found.stopped
    assert Stop.GATE in found.edge.stops
    again = ScanJob(cloud, found.inputs)(StopsAfter(1000))
    assert np.array_equal(again.edge.points, found.edge.points)


def test_places_are_what_the_clicks_say() -> None:
    places = PickedPlaces(Way.START_AND_GATE)
    for point in np.eye(3):
        assert places.at is None
        places.add(point)
    assert isinstance(places.at, Start) and places.gate is None
    places.add(np.zeros(3))
    places.add(np.ones(3))
    assert isinstance(places.gate, Gate)
    places.add(np.ones(3))
    assert places.at is None and len(places.points) == 1


def test_the_same_place_twice_is_no_gate() -> None:
    places = PickedPlaces(Way.START_AND_GATE)
    for point in [*np.eye(3), np.zeros(3), np.zeros(3)]:
        places.add(point)
    with pytest.raises(ScanError, match="no length"):
        _ = places.gate
