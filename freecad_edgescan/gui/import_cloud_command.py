# SPDX-License-Identifier: LGPL-2.1-or-later
"""Import cloud: point clouds from files into the document."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .icons import icon_path
from .message import problems_shown
from .qt import QtCore, QtWidgets
from .recorded_step import run_as_one_step
from .shading import shade
from .shown import fit_view, select_only

__all__ = ["ImportCloudCommand", "import_clouds"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

ENDINGS = ("xyz", "txt", "asc", "csv", "ply", "pcd", "e57", "stl", "obj")
_FOLDER = "ImportFolder"


class ImportCloudCommand:
    """The command EdgeScan_ImportCloud."""

    def GetResources(self) -> dict[str, str]:
        """Icon, menu text and tooltip."""
        return {
            "Pixmap": icon_path("EdgeScan_ImportCloud"),
            "MenuText": QT_TRANSLATE_NOOP("EdgeScan_ImportCloud", "Import cloud…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "EdgeScan_ImportCloud",
                "Import point clouds from files (xyz, txt, asc, csv, ply, pcd, e57, stl, obj). "
                "Nothing needs to be selected.",
            ),
        }

    def IsActive(self) -> bool:
        """Always, also without a document."""
        return not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Ask for files and import them."""
        settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/EdgeScan")
        patterns = " ".join(f"*.{ending} *.{ending.upper()}" for ending in ENDINGS)
        paths, _ = QtWidgets.QFileDialog.getOpenFileNames(
            FreeCADGui.getMainWindow(),
            "Import cloud",
            settings.GetString(_FOLDER, ""),
            f"Point clouds ({patterns});;All files (*)",
        )
        if not paths:
            return
        settings.SetString(_FOLDER, QtCore.QFileInfo(paths[0]).absolutePath())
        with problems_shown("Import cloud"):
            import_clouds(paths)


def import_clouds(paths: list[str]) -> list[Any]:
    """Import files into the active document, or a new one, in one undo step.

    Raises
    ------
    ValueError, OSError: a file that cannot be read. Then nothing is imported.
    """
    doc = FreeCAD.ActiveDocument
    is_new = doc is None
    if is_new:
        FreeCADGui.doCommand('FreeCAD.newDocument("Scan")')
        doc = FreeCAD.ActiveDocument
    QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    progress = FreeCAD.Base.ProgressIndicator()
    progress.start("Importing clouds…", len(paths) + 1)
    try:
        progress.next()
        made = run_as_one_step(
            doc,
            "Import cloud",
            [f"document.make_cloud(doc, {path!r})" for path in paths],
            shade,
        )
    except BaseException:
        if is_new:
            FreeCAD.closeDocument(doc.Name)
        raise
    finally:
        progress.stop()
        QtWidgets.QApplication.restoreOverrideCursor()
    select_only(made)
    fit_view(doc)
    return made
