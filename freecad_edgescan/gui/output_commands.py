# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that write files: Export and Report."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

from . import preferences
from .command import Command
from .obstacles import no_document, no_shape
from .qt import QtCore, QtGui, QtWidgets
from .recorded_step import object_lines
from .selected import selected_objects
from .translation import translate

__all__ = ["output_commands"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def output_commands() -> list[Command]:
    """All of them, in the order of the toolbar."""
    return [
        Command(
            "EdgeScan_Export",
            QT_TRANSLATE_NOOP("EdgeScan_Export", "Export…"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_Export",
                "Write edges and surfaces as STEP, or edge points with their sigma as CSV, in the "
                "coordinates of the scan. Select what to write, or nothing for everything shown.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_Export", "Select edges or surfaces, or nothing for all"),
            _export,
            no_shape,
        ),
        Command(
            "EdgeScan_Report",
            QT_TRANSLATE_NOOP("EdgeScan_Report", "Report…"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_Report",
                "Write one page about this document: clouds, edges, surfaces, their figures and "
                "pictures. Nothing needs to be selected.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_Report", "Writes a page about this document"),
            _report,
            no_document,
        ),
    ]


def _export(doc: Any) -> None:
    chosen = selected_objects(doc) or [
        item for item in doc.Objects if getattr(item.ViewObject, "Visibility", False)
    ]
    # With those that have none yet, which export_step names: nothing is left out unsaid.
    shapes = [item for item in chosen if hasattr(item, "Shape")]
    edges = [item for item in chosen if hasattr(item, "Sigma")]
    if all(item.Shape.isNull() for item in shapes):
        raise ValueError(
            translate(
                "Nothing with a shape is selected or shown. Select scanned edges or surfaces."
            )
        )
    kinds = [f"{translate('Edges and surfaces')} (*.step)"]
    if edges:
        kinds.append(f"{translate('Edge points with sigma')} (*.csv)")
    path = _ask_for_file(translate("Export"), doc, ";;".join(kinds))
    if path is None:
        return
    if path.suffix.lower() == ".csv":
        call, items = "export_csv", edges
    else:
        call, items = "export_step", shapes
    _run(doc, f"document.{call}({object_lines(items)}, {str(path)!r})")


def _report(doc: Any) -> None:
    path = _ask_for_file(translate("Report"), doc, f"{translate('Web page')} (*.html)")
    if path is None:
        return
    _run(doc, f"document.write_report(doc, {str(path)!r})")
    QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(path)))


def _ask_for_file(title: str, doc: Any, kinds: str) -> Path | None:
    """Where to write, with an ending; None when the user has cancelled."""
    folder = Path(doc.FileName).parent if doc.FileName else Path(preferences.import_folder())
    name, kind = QtWidgets.QFileDialog.getSaveFileName(
        FreeCADGui.getMainWindow(), title, str(folder / doc.Label), kinds
    )
    if not name:
        return None
    path = Path(name)
    if path.suffix.lower() in (".step", ".stp", ".csv", ".html"):
        return path
    ending = (kind or kinds).partition("(*")[2].partition(")")[0]
    return path.with_name(path.name + ending)


def _run(doc: Any, line: str) -> None:
    """Run a recorded line that writes a file and leaves the document as it is."""
    QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        FreeCADGui.doCommand("from freecad_edgescan import document")
        FreeCADGui.doCommand(f"doc = FreeCAD.getDocument({doc.Name!r})")
        FreeCADGui.doCommand(line)
    finally:
        QtWidgets.QApplication.restoreOverrideCursor()
