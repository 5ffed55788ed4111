# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main states of the window look as they did when somebody last looked at them.

The pictures guard the layout only; numbers are tested elsewhere, against the truth. Each version of
FreeCAD has its own, in ``pictures``. ``EDGESCAN_NEW_PICTURES=1 ./edgescan test
tests/gui/test_pictures.py`` takes them anew: look at each, and commit them by themselves.
With ``EDGESCAN_PICTURES=FOLDER`` what the tests see is kept there.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.cloud import PointCloud  # noqa: E402
from freecad_edgescan.gui import preferences, scan_edge_panel, thinned_clouds  # noqa: E402
from freecad_edgescan.gui.qt import QtCore, QtGui, QtWidgets  # noqa: E402
from freecad_edgescan.gui.scan_job import ScanJob  # noqa: E402
from freecad_edgescan.gui.try_it import GUIDE_NAME  # noqa: E402
from freecad_edgescan.scanning import scan_edge  # noqa: E402

from .conftest import SLOPE, roof  # noqa: E402
from .screen_pictures import (  # noqa: E402
    Picture,
    least_alike,
    of_the_screen,
    picture_of,
    read_picture,
    write_picture,
)

VERSION = ".".join(FreeCAD.Version()[:2])
REFERENCES = Path(__file__).with_name("pictures") / VERSION
ALIKE = 0.35  # see the tests of what is noticed, and what is not
FONT = "DejaVu Sans"
VIEW = "User parameter:BaseApp/Preferences/View"
ON_THE_RIDGE = (0.0, 2.0, 5.0)
V = FreeCAD.Vector


@pytest.fixture(scope="module")
def still(workbench: Any) -> Iterator[None]:
    """The window as the pictures show it: its own font, the same docks, nothing that moves."""
    app, main = QtWidgets.QApplication.instance(), Gui.getMainWindow()
    font, flash, docks = app.font(), app.cursorFlashTime(), main.saveState()
    wanted, look = QtGui.QFont(FONT, 9), FreeCAD.ParamGet(VIEW)
    if not QtGui.QFontInfo(wanted).exactMatch():
        pytest.skip(f"the pictures were taken with the font {FONT}, which is not installed")
    app.setFont(wanted)
    app.setCursorFlashTime(0)
    QtGui.QCursor.setPos(0, 0)
    for dock in main.findChildren(QtWidgets.QDockWidget):
        dock.setVisible(dock.objectName() in ("Combo View", "Tasks", "Model"))
    for bar in main.findChildren(QtWidgets.QToolBar):  # whose rows depend on the commands
        bar.hide()
    main.showNormal()
    main.setGeometry(0, 0, 1200, 900)
    for name, plain in (("Gradient", False), ("Simple", True)):
        look.SetBool(name, plain)
    yield
    look.RemBool("Gradient")
    look.RemBool("Simple")
    app.setFont(font)
    app.setCursorFlashTime(flash)
    main.restoreState(docks)
    main.showMaximized()


@pytest.fixture
def scene(still: None, window: Any, monkeypatch: pytest.MonkeyPatch) -> Any:
    """The roof, with room for a panel at its left.

    Of its points, which are no layout and make large files, next to none are drawn.
    """
    monkeypatch.setattr(thinned_clouds, "MOST_POINTS", 1)
    main = Gui.getMainWindow()
    docks = [dock for dock in main.findChildren(QtWidgets.QDockWidget) if dock.isVisible()]
    main.resizeDocks(docks, [340] * len(docks), QtCore.Qt.Horizontal)
    window.settle()
    window.view.fitAll()
    window.settle()
    return window


def the_middle(window: Any) -> Picture:
    """The panel and the 3D view: what is between menu and status bar."""
    for note in QtWidgets.QApplication.topLevelWidgets():
        if note.windowType() == QtCore.Qt.ToolTip:  # FreeCAD 1.0 shows what was reported so
            note.hide()
    main = Gui.getMainWindow()
    views = main.centralWidget().geometry()
    part = QtCore.QRect(0, views.y(), main.width(), views.height())
    seen: list[Picture] = []

    def nothing_moves() -> bool:
        seen.append(of_the_screen(main, part))
        return len(seen) > 3 and all(np.array_equal(seen[-1], seen[k]) for k in (-2, -3))

    window.pass_time(0.2)
    window.wait_until(nothing_moves)
    return seen[-1]


class Held(ScanJob):
    """A scan that has come as far as fifteen edge points, and waits."""

    def __call__(self, progress: Any) -> Any:
        kept: list[Any] = []

        class Until:
            def update(self, _: float, so_far: Any) -> bool:
                kept.append(so_far)
                return len(so_far.points) < 15

        scan_edge(self.cloud, at=self.inputs.at, progress=Until())
        while progress.update(float("nan"), kept[-1]):
            time.sleep(0.01)
        raise AssertionError("nobody waits for this")


def before_the_click(window: Any) -> Picture:
    window.open_panel()
    return the_middle(window)


def while_it_walks(window: Any, monkeypatch: pytest.MonkeyPatch) -> Picture:
    monkeypatch.setattr(scan_edge_panel, "ScanJob", Held)
    window.open_panel()
    window.click(ON_THE_RIDGE)
    window.wait_until(lambda: len(window.panel._display.preview.edge.points) >= 15)
    return the_middle(window)


def with_the_evidence(window: Any) -> Picture:
    window.open_panel()
    window.click(ON_THE_RIDGE)
    window.found()
    return the_middle(window)


def with_parameters(window: Any) -> Picture:
    with_the_evidence(window)
    window.panel.form.tabs.setCurrentIndex(1)
    return the_middle(window)


def recommended(window: Any) -> Picture:
    Gui.runCommand("EdgeScan_RecommendParameters")
    window.settle()
    window.click(ON_THE_RIDGE)
    window.found()
    return the_middle(window)


def scan_a_box(window: Any) -> None:
    """A box in place of the roof."""
    window.doc.removeObject(window.cloud.Name)
    box = Part.makeBox(20, 16, 12)
    document.make_cloud(window.doc, document.simulate_cloud(box, pitch=0.8, noise=0.01))
    window.doc.recompute()
    window.view.fitAll()
    window.settle()


def a_boundary(window: Any) -> Picture:
    scan_a_box(window)
    Gui.runCommand("EdgeScan_ScanBoundary")
    window.settle()
    window.click((10.0, 0.2, 12.0))
    window.click((10.0, 8.0, 12.0))
    window.found()
    return the_middle(window)


def all_edges(window: Any) -> Picture:
    scan_a_box(window)
    Gui.runCommand("EdgeScan_ScanAllEdges")
    window.found()
    window.click((10.0, 0.0, 12.0))
    return the_middle(window)


def a_deviation_map(window: Any) -> Picture:
    side = window.doc.addObject("Part::Feature", "Side")
    low = 5.0 - 10.0 * SLOPE
    corners = [V(0, -15, 5), V(10, -15, low), V(10, 15, low), V(0, 15, 5)]
    side.Shape = Part.Face(Part.makePolygon([*corners, corners[0]]))
    thin = document.make_thinned_cloud(window.doc, window.cloud, pitch=0.8)
    document.make_deviation_map(window.doc, thin, side)
    window.doc.recompute()
    for item in (window.cloud, thin, side):
        item.ViewObject.Visibility = False
    Gui.Selection.clearSelection()
    return the_middle(window)


def the_guide(window: Any) -> Picture:
    Gui.runCommand("EdgeScan_TryIt")
    window.settle()
    guide = Gui.getMainWindow().findChild(QtWidgets.QFrame, GUIDE_NAME)
    picture = of_the_screen(guide, guide.rect())
    guide.finish.click()
    FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)
    return picture


def the_import_dialog(window: Any) -> Picture:
    from freecad_edgescan.gui.import_dialog import ImportDialog

    dialog = ImportDialog({Path("roof.xyz"): PointCloud(roof() + np.array([5e6, 0.0, 0.0]))})
    return grabbed(dialog)


def the_preferences(window: Any) -> Picture:
    return grabbed(Gui.PySideUic.loadUi(str(preferences.PAGE)))


def grabbed(widget: Any) -> Picture:
    """A widget by itself."""
    widget.ensurePolished()
    widget.adjustSize()
    picture = picture_of(widget.grab().toImage())
    widget.deleteLater()
    return picture


def assert_looks_as_it_did(name: str, seen: Picture, folder: Path) -> None:
    """Compare with the reference; or write it, when new ones are wanted.

    Parameters
    ----------
    folder : where what is seen is kept, unless another one is named
    """
    reference = REFERENCES / f"{name}.png"
    kept = Path(os.environ.get("EDGESCAN_PICTURES") or folder) / f"{VERSION}-{name}.png"
    write_picture(seen, kept)
    if os.environ.get("EDGESCAN_NEW_PICTURES"):
        write_picture(seen, reference)
    if not REFERENCES.is_dir():
        pytest.skip(f"there are no pictures of FreeCAD {VERSION}")
    assert least_alike(seen, read_picture(reference)) > ALIKE, (
        f"compare {kept.resolve()} with {reference}; docs/figures.md says how to renew it"
    )


STATES: list[Callable[..., Picture]] = [
    *(before_the_click, with_the_evidence, with_parameters, recommended, a_boundary),
    *(all_edges, a_deviation_map, the_guide, the_import_dialog, the_preferences),
]


@pytest.mark.parametrize("state", STATES, ids=lambda state: state.__name__)
def test_a_state_looks_as_it_did(
    scene: Any, state: Callable[[Any], Picture], tmp_path: Path
) -> None:
    assert_looks_as_it_did(state.__name__, state(scene), tmp_path)


def test_a_walk_looks_as_it_did(
    scene: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    assert_looks_as_it_did("while_it_walks", while_it_walks(scene, monkeypatch), tmp_path)


def test_a_missing_button_is_noticed(scene: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = while_it_walks(scene, monkeypatch)
    assert least_alike(the_middle(scene), whole) > ALIKE
    scene.panel.form.stop.hide()
    assert least_alike(the_middle(scene), whole) < ALIKE
    scene.panel.form.stop.show()
    assert least_alike(the_middle(scene), whole) > ALIKE


def test_a_missing_field_and_a_moved_label_are_noticed(scene: Any) -> None:
    whole = with_parameters(scene)
    form = scene.panel.form
    form._way.hide()
    assert least_alike(the_middle(scene), whole) < ALIKE
    form._way.show()
    assert least_alike(the_middle(scene), whole) > ALIKE
    form._figures.setIndent(30)
    assert least_alike(the_middle(scene), whole) < ALIKE


def test_other_digits_are_not_noticed(scene: Any) -> None:
    whole = with_the_evidence(scene)
    label = scene.panel.form._figures
    label.setText(label.text().replace("1.", "4.").replace("02", "18"))
    assert ALIKE < least_alike(the_middle(scene), whole) < 1.0


def test_a_moved_legend_is_noticed(scene: Any) -> None:
    whole = a_deviation_map(scene)
    shown = scene.doc.getObject("DeviationMap")
    legend = shown.ViewObject.Proxy.legend
    legend.show(True, 1)
    assert least_alike(the_middle(scene), whole) < ALIKE
    legend.show(True, 0)
    assert least_alike(the_middle(scene), whole) > ALIKE
    legend.show(False)
    assert least_alike(the_middle(scene), whole) < ALIKE


def test_likeness_is_one_of_the_same_and_none_of_other_sizes() -> None:
    random = np.random.default_rng(0).random((60, 80))
    assert least_alike(random, random) == pytest.approx(1.0)
    assert least_alike(random, random[:, ::-1]) < 0.2
    assert least_alike(random, random[:50]) == 0.0
