# SPDX-License-Identifier: LGPL-2.1-or-later
"""A real FreeCAD window with a small cloud in it, and hands that click and type."""

from __future__ import annotations

import os
import sys
import time
import weakref
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

try:
    import FreeCAD
    import FreeCADGui as Gui
    from pivy import coin  # noqa: F401, lets Python see the view's scene

    Gui.getMainWindow()
    from freecad_edgescan.gui.qt import QtCore, QtGui, QtWidgets
    from freecad_edgescan.gui.single_shot import call_later
except (ImportError, AttributeError):  # no FreeCAD window
    collect_ignore_glob = ["test_*.py", "all_edges"]

SLOPE = 0.8  # both sides of the roof fall by this for each mm
HALF_LENGTH = 15.0


def roof(noise: float = 0.01, pitch: float = 0.25) -> np.ndarray:
    """Two slanting sides that meet in a ridge: the line x = 0, z = 5, y from -15 to 15."""
    random = np.random.default_rng(7)
    count = int(30 * 20 * np.hypot(1, SLOPE) / pitch**2)
    x, y = random.uniform(-10, 10, count), random.uniform(-HALF_LENGTH, HALF_LENGTH, count)
    points = np.column_stack([x, y, 5.0 - SLOPE * np.abs(x)])
    normal = np.column_stack([SLOPE * np.sign(x), np.zeros(count), np.ones(count)])
    normal /= np.hypot(1, SLOPE)
    return points + normal * random.normal(0, noise, (count, 1))


class Window:
    """FreeCAD's main window with one document, and what a person does with it."""

    def __init__(self, doc: Any, panels: list[Any]) -> None:
        self.doc = doc
        self.panels = panels
        self.view = Gui.getDocument(doc.Name).ActiveView

    @property
    def edges(self) -> list[Any]:
        """Scanned edges in the document."""
        return [
            o for o in self.doc.Objects if "ScannedEdge" in type(getattr(o, "Proxy", 0)).__name__
        ]

    @property
    def viewport(self) -> Any:
        """The widget the 3D view is drawn in."""
        # view.graphicsView() may answer the widget of a document that was closed before.
        area = Gui.getMainWindow().centralWidget().currentSubWindow()
        return area.findChild(QtWidgets.QGraphicsView).viewport()

    @property
    def panel(self) -> Any:
        """The panel that was opened last."""
        return self.panels[-1]()

    @property
    def sentence(self) -> str:
        """What the panel says at its top."""
        return self.panel.form.sentence

    @property
    def cloud(self) -> Any:
        """The roof's cloud."""
        return self.doc.findObjects("Points::Feature")[0]

    def open_panel(self) -> None:
        """Start the command Scan edge, and wait until a click is answered at once."""
        Gui.runCommand("EdgeScan_ScanEdge")
        self.settle()
        self.wait_until(lambda: self.panel._clicks.ready)

    def found(self) -> None:
        """Wait for the edge."""
        self.wait_until(lambda: self.button("Ok").isEnabled())

    def ok(self) -> None:
        """Press OK and wait until the panel has gone."""
        self.button("Ok").click()
        self.wait_until(lambda: not Gui.Control.activeDialog())
        self.settle()

    def button(self, name: str) -> Any:
        """OK or Cancel of the open panel."""
        # Not searched for among the widgets: PySide would keep what it finds alive in Python,
        # and hand it out again for a later widget at the same address.
        return self.panel.buttons.button(getattr(QtWidgets.QDialogButtonBox, name))

    def settle(self) -> None:
        """Let the window handle what has come in, and what follows from that at once."""
        for _ in range(3):
            handled: list[bool] = []
            call_later(lambda seen=handled: seen.append(True))
            self.wait_until(lambda seen=handled: bool(seen))

    def pass_time(self, seconds: float) -> None:
        """Let the window do what it does after a while."""
        end = time.monotonic() + seconds
        self.wait_until(lambda: time.monotonic() > end)

    def wait_until(self, condition: Callable[[], bool], seconds: float = 60.0) -> None:
        """Let the window do what it does until something is so."""
        end = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < end, "the window did not get there in time"
            QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
            time.sleep(0.002)

    def pixel_of(self, point: tuple[float, float, float]) -> tuple[int, int]:
        """Where a point is seen, counted from the lower left corner."""
        name = "getPointOnViewport" if hasattr(self.view, "getPointOnViewport") else None
        x, y = getattr(self.view, name or "getPointOnScreen")(FreeCAD.Vector(*point))
        return round(x), round(y)

    def click_pixel(self, x: int, y: int, ctrl: bool = False) -> None:
        """Press and release the left mouse button, counted from the lower left corner."""
        ratio = self.viewport.devicePixelRatioF()
        height = self.view.getSize()[1]
        place = QtCore.QPointF(x / ratio, (height - y - 1) / ratio)
        keys = QtCore.Qt.ControlModifier if ctrl else QtCore.Qt.NoModifier
        left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
        for kind, button, held in (
            (QtCore.QEvent.MouseMove, none, none),
            (QtCore.QEvent.MouseButtonPress, left, left),
            (QtCore.QEvent.MouseButtonRelease, left, none),
        ):
            event = QtGui.QMouseEvent(kind, place, button, held, keys)
            QtWidgets.QApplication.sendEvent(self.viewport, event)
            self.settle()

    def click(self, point: tuple[float, float, float]) -> None:
        """Click where a point is seen."""
        self.click_pixel(*self.pixel_of(point))

    def hover(self, point: tuple[float, float, float]) -> None:
        """Move the mouse over a place."""
        x, y = self.pixel_of(point)
        ratio = self.viewport.devicePixelRatioF()
        place = QtCore.QPointF(x / ratio, (self.view.getSize()[1] - y - 1) / ratio)
        none = QtCore.Qt.NoButton
        event = QtGui.QMouseEvent(QtCore.QEvent.MouseMove, place, none, none, QtCore.Qt.NoModifier)
        QtWidgets.QApplication.sendEvent(self.viewport, event)
        self.pass_time(0.1)  # the panel looks what is under the mouse only so often

    def press_escape(self) -> None:
        """Press Esc over the 3D view."""
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            event = QtGui.QKeyEvent(kind, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
            QtWidgets.QApplication.sendEvent(self.viewport, event)
            self.settle()

    def close_dock(self) -> None:
        """Press the cross of the dock the panel is in; another panel may come into it later."""
        self.settle()
        dock = self.panel.form
        while not isinstance(dock, QtWidgets.QDockWidget):
            dock = dock.parentWidget()
        dock.close()
        call_later(dock.show, 500)

    @property
    def threads(self) -> int:
        """Threads that run Python now.

        Those of Qt count, too; what `threading` still lists of them when they are gone does not.
        """
        return len(sys._current_frames())

    def trace(self) -> tuple[object, ...]:
        """All that a cancelled command must leave as it was."""
        return (
            sorted(o.Name for o in self.doc.Objects),
            self.doc.UndoCount,
            self.view.getSceneGraph().getNumChildren(),
            self.view.getSceneGraph().getField("selectionRole").getValue(),
            [o.ViewObject.SwitchNode.whichChild.getValue() for o in self.doc.Objects],
            [o.ViewObject.Visibility for o in self.doc.Objects],
        )

    def picture(self, name: str) -> None:
        """Keep a picture of the whole window, when a folder for pictures is named."""
        folder = os.environ.get("EDGESCAN_PICTURES")
        if folder:
            self.pass_time(0.3)
            Path(folder).mkdir(parents=True, exist_ok=True)
            screen = QtWidgets.QApplication.primaryScreen()
            screen.grabWindow(0).save(str(Path(folder) / f"{name}.png"))


@pytest.fixture(scope="session")
def workbench() -> Any:
    """The EdgeScan workbench, open."""
    Gui.activateWorkbench("EdgeScanWorkbench")
    Gui.getMainWindow().showMaximized()
    return Gui.activeWorkbench()


@pytest.fixture(autouse=True)
def problems(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Sentences of the message boxes, which do not wait for anybody here."""
    said: list[str] = []
    monkeypatch.setattr(
        QtWidgets.QMessageBox, "warning", lambda _parent, _title, text, *_: said.append(text)
    )
    return said


@pytest.fixture
def panels(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Weak references to the panels that are opened."""
    from freecad_edgescan.gui.view_panel import ViewPanel

    opened: list[Any] = []
    begin = ViewPanel.__init__

    def note(panel: Any, *given: Any) -> None:
        begin(panel, *given)
        opened.append(weakref.ref(panel))

    monkeypatch.setattr(ViewPanel, "__init__", note)
    return opened


@pytest.fixture(scope="session")
def roof_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The roof's points."""
    path = tmp_path_factory.mktemp("roof") / "roof.xyz"
    np.savetxt(path, roof())
    return path


@pytest.fixture(scope="module")
def roof_document(workbench: Any) -> Iterator[Callable[[], Any]]:
    """Gives an empty document; tests of a module share it and its 3D view, which is slow to make.

    A test that saves it or closes it has it for itself.
    """
    name = "Roof"

    def close() -> None:
        if name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(name)

    def empty() -> Any:
        if name in FreeCAD.listDocuments():
            doc = FreeCAD.getDocument(name)
            if not doc.FileName:
                while doc.Objects:  # one may take others along
                    doc.removeObject(doc.Objects[0].Name)
                doc.clearUndos()
                return doc
            close()
        return FreeCAD.newDocument(name)

    yield empty
    close()


@pytest.fixture
def no_document(workbench: Any) -> None:
    """No document is open, as when FreeCAD has just started."""
    for name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


@pytest.fixture
def window(
    roof_document: Callable[[], Any], panels: list[Any], roof_file: Path
) -> Iterator[Window]:
    """A document that shows the roof from above, slantwise."""
    from freecad_edgescan import document

    doc = roof_document()
    document.make_cloud(doc, str(roof_file))
    doc.recompute()
    doc.clearUndos()
    window = Window(doc, panels)
    window.view.setAnimationEnabled(False)
    window.view.setCameraType("Orthographic")
    window.view.viewIsometric()
    window.view.fitAll()
    window.settle()
    yield window
    if window.panels and window.panel is not None:
        window.panel.close()
    if Gui.Control.activeDialog():
        Gui.Control.closeDialog()
    Gui.Selection.clearSelection()
    window.settle()
