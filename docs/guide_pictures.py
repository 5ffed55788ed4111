# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does in a FreeCAD window what docs/guide.md says, and keeps a picture of each step.

Run by ``docs/make_pictures``. The part is a block with a bent half-pipe, scanned in simulation; it
is clicked where its edges are seen. What is written to EDGESCAN_LOG is printed in the end.
"""

import os
import time
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
import Part
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20 keeps the widgets in QtGui
    QtWidgets = QtGui

FOLDER = Path(os.environ["EDGESCAN_PICTURES"])
LOG = Path(os.environ["EDGESCAN_LOG"])
V = FreeCAD.Vector
RADIUS, WIDTH, LENGTH = 8.0, 75.0, 60.0
STEPS = (
    *("try-it", "import", "cloud", "scan-edge", "preview"),
    *("edge", "boundary", "section", "sweep", "deviation", "all-edges"),
)


def main() -> None:
    """All pictures, in order; the log says what was shown."""
    began = time.perf_counter()
    Gui.activateWorkbench("EdgeScanWorkbench")
    say(f"The workbench opened in {time.perf_counter() - began:.2f} s.")
    arrange_window()
    settle(1.0)

    Gui.runCommand("EdgeScan_TryIt")
    settle(1.0)
    picture("try-it")
    FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)
    settle(0.5)

    doc = import_part()
    (cloud,) = doc.findObjects("Points::Feature")
    picture("cloud")

    left = scan(doc, (20.0, 15.0 + RADIUS, 0.0), "scan-edge", "preview")
    select(left)
    picture("edge")
    right = scan(doc, (20.0, 15.0 - RADIUS, 0.0))
    Gui.runCommand("EdgeScan_ScanBoundary")
    settle(0.5)
    click(doc, (WIDTH, 30.0, 0.0))
    click(doc, (WIDTH - 6.0, 30.0, 0.0))
    wait_until(lambda: button("Ok").isEnabled())
    picture("boundary")
    button("Cancel").click()
    settle(0.5)

    select(cloud, left, right)
    Gui.runCommand("EdgeScan_CloudSection")
    (section,) = (item for item in doc.Objects if hasattr(item, "KindUsed"))
    section.ViewObject.LineWidth = 4.0
    section.ViewObject.LineColor = (0.0, 0.45, 0.70)
    say(f"Profile: {section.KindUsed} of radius {section.Radius.UserString}.")
    select(section)
    picture("section")

    select(section, left)
    Gui.runCommand("EdgeScan_Sweep")
    sweep = doc.Objects[-1]
    cloud.ViewObject.Visibility = False
    sweep.ViewObject.ShapeColor = (0.34, 0.71, 0.91)
    select(sweep)
    Gui.Selection.clearSelection()
    picture("sweep")

    cloud.ViewObject.Visibility = True
    select(cloud, sweep)
    Gui.runCommand("EdgeScan_DeviationMap")
    shown = doc.Objects[-1]
    shown.Reach = 0.2
    doc.recompute()
    say(f"Deviation: {shown.Average.UserString} on average of {shown.PointCount} points.")
    select(shown)
    picture("deviation")

    for item in doc.Objects:
        item.ViewObject.Visibility = item is cloud
    select(cloud)
    Gui.runCommand("EdgeScan_ScanAllEdges")
    settle(0.5)
    wait_until(lambda: button("Ok").isEnabled(), 120.0)
    click(doc, (30.0, 0.0, 0.0))
    picture("all-edges")
    button("Cancel").click()
    settle(0.5)
    FreeCAD.closeDocument(doc.Name)


def arrange_window() -> None:
    """The tree and the 3D view, and nothing else."""
    window = Gui.getMainWindow()
    window.showMaximized()
    for dock in window.findChildren(QtWidgets.QDockWidget):
        dock.setVisible(dock.objectName() in ("Combo View", "Tree view", "Property view", "Model"))
    combo = window.findChild(QtWidgets.QDockWidget, "Combo View")
    if combo is not None:
        window.resizeDocks([combo], [330], QtCore.Qt.Horizontal)


def import_part() -> object:
    """Write the simulated scan to a file, and import it by the command."""
    import freecad_edgescan as es
    from freecad_edgescan import document

    scanned = document.simulate_cloud(block(), pitch=0.45, noise=0.02)
    file = LOG.parent / "half-pipe.ply"
    es.write_cloud(es.PointCloud(scanned.points[scanned.points[:, 2] > -10.5]), file)
    QtWidgets.QFileDialog.getOpenFileNames = lambda *_: ([str(file)], "")
    QtCore.QTimer.singleShot(2500, accept_dialog)
    Gui.runCommand("EdgeScan_ImportCloud")
    doc = FreeCAD.ActiveDocument
    view = Gui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.setCameraOrientation(FreeCAD.Rotation(V(1, 0, 0), 35))
    view.fitAll()
    view.zoomIn()
    Gui.Selection.clearSelection()
    settle(0.5)
    return doc


def accept_dialog() -> None:
    """Press OK in the import dialog."""
    dialog = QtWidgets.QApplication.activeModalWidget()
    picture("import")
    dialog.accept()


def block() -> object:
    """A block into whose upper side a bent half-pipe is sunk."""
    bend = 15.0
    middle = V(35 + bend * 0.5**0.5, 15 + bend * (1 - 0.5**0.5), 0)
    path = Part.Wire(
        [
            Part.makeLine(V(-5, 15, 0), V(35, 15, 0)),
            Part.Arc(V(35, 15, 0), middle, V(50, 30, 0)).toShape(),
            Part.makeLine(V(50, 30, 0), V(50, LENGTH + 5, 0)),
        ]
    )
    ring = Part.Wire(Part.makeCircle(RADIUS, V(-5, 15, 0), V(1, 0, 0)))
    return Part.makeBox(WIDTH, LENGTH, 14, V(0, 0, -14)).cut(path.makePipeShell([ring], True))


def scan(doc: object, place: tuple, asked: str = "", found: str = "") -> object:
    """Scan an edge by the command; pictures before the click and when the edge is there."""
    Gui.runCommand("EdgeScan_ScanEdge")
    settle(0.8)
    if asked:
        picture(asked)
    click(doc, place)
    wait_until(lambda: button("Ok").isEnabled())
    settle(0.5)
    if found:
        picture(found)
    button("Ok").click()
    settle(0.5)
    edge = doc.Objects[-1]
    say(f"{edge.Label}: {edge.Message}")
    return edge


def click(doc: object, place: tuple) -> None:
    """Press and release the left button where a place is seen."""
    view = Gui.getDocument(doc.Name).ActiveView
    name = "getPointOnViewport" if hasattr(view, "getPointOnViewport") else "getPointOnScreen"
    x, y = getattr(view, name)(V(*place))
    area = Gui.getMainWindow().centralWidget().currentSubWindow()
    viewport = area.findChild(QtWidgets.QGraphicsView).viewport()
    ratio = viewport.devicePixelRatioF()
    pixel = QtCore.QPointF(x / ratio, (view.getSize()[1] - y - 1) / ratio)
    none, left = QtCore.Qt.NoButton, QtCore.Qt.LeftButton
    for kind, button, held in (
        (QtCore.QEvent.MouseMove, none, none),
        (QtCore.QEvent.MouseButtonPress, left, left),
        (QtCore.QEvent.MouseButtonRelease, left, none),
    ):
        event = QtGui.QMouseEvent(kind, pixel, button, held, QtCore.Qt.NoModifier)
        QtWidgets.QApplication.sendEvent(viewport, event)
        settle(0.1)


def button(name: str) -> object:
    """OK or Cancel of the open task panel."""
    boxes = Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
    (box,) = (own for own in boxes if own.isVisible())
    return box.button(getattr(QtWidgets.QDialogButtonBox, name))


def select(*items: object) -> None:
    """Select these objects and nothing else."""
    Gui.Selection.clearSelection()
    for item in items:
        Gui.Selection.addSelection(item)


def wait_until(condition: object, seconds: float = 60.0) -> None:
    """Let the window work until a condition holds."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError("the window did not get there in time")
        settle(0.05)


def settle(seconds: float) -> None:
    """Let the window draw and answer."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        time.sleep(0.005)


def picture(step: str) -> None:
    """Keep what the screen shows."""
    settle(0.6)
    number = STEPS.index(step) + 1
    file = FOLDER / f"guide-{number:02d}-{step}.png"
    QtWidgets.QApplication.primaryScreen().grabWindow(0).save(str(file), "png", 1)


def say(sentence: str) -> None:
    """Write a line that is printed in the end."""
    with LOG.open("a", encoding="utf-8") as file:
        file.write(f"{sentence}\n")


def run() -> None:
    """All of it, and FreeCAD's end."""
    try:
        main()
        say(f"{len(STEPS)} pictures are in {FOLDER.name}.")
    except BaseException:
        say(traceback.format_exc())
    os._exit(0)


QtCore.QTimer.singleShot(1500, run)
