# SPDX-License-Identifier: LGPL-2.1-or-later
"""Import cloud: point clouds from files into the document."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD
import FreeCADGui

from . import preferences
from .command import Command
from .obstacles import panel_open
from .qt import QtWidgets
from .recorded_step import run_as_one_step
from .shown import fit_view, select_only
from .translation import translate

if TYPE_CHECKING:
    from freecad_edgescan.cloud import PointCloud

__all__ = ["import_cloud_command", "import_clouds"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

ENDINGS = ("xyz", "txt", "asc", "csv", "ply", "pcd", "e57", "stl", "obj")


def import_cloud_command() -> Command:
    """The command EdgeScan_ImportCloud."""
    return Command(
        "EdgeScan_ImportCloud",
        QT_TRANSLATE_NOOP("EdgeScan_ImportCloud", "Import cloud…"),
        QT_TRANSLATE_NOOP(
            "EdgeScan_ImportCloud",
            "Import point clouds from files (xyz, txt, asc, csv, ply, pcd, e57, stl, obj). "
            "Nothing needs to be selected.",
        ),
        QT_TRANSLATE_NOOP("EdgeScan_ImportCloud", "Choose one or more cloud files"),
        _ask_and_import,
        panel_open,
    )


def _ask_and_import(_doc: Any) -> None:
    patterns = " ".join(f"*.{ending} *.{ending.upper()}" for ending in ENDINGS)
    names, _ = QtWidgets.QFileDialog.getOpenFileNames(
        FreeCADGui.getMainWindow(),
        translate("Import cloud"),
        preferences.import_folder(),
        f"{translate('Point clouds')} ({patterns});;{translate('All files')} (*)",
    )
    if not names:
        return
    paths = [Path(name) for name in names]
    preferences.remember_import_folder(str(paths[0].resolve().parent))
    clouds = _read(paths)
    from .import_dialog import ImportDialog

    dialog = ImportDialog(clouds)
    if dialog.asked():
        import_clouds(clouds, dialog.unit, dialog.probe_radius, dialog.near_origin)


def _read(paths: list[Path]) -> dict[Path, PointCloud]:
    """Read files: beside the window where our own readers can.

    Raises
    ------
    ValueError: a file that cannot be read.
    CancelledError: the user has cancelled.
    """
    import warnings

    from freecad_edgescan.document.cloud_source import needs_freecad, read_source

    from .busy import result_of

    clouds = {}
    for path in paths:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*were left out")
            if needs_freecad(path):
                clouds[path] = read_source(path)
                continue
            title = translate("Reading {name}…").format(name=path.name)
            clouds[path] = result_of(partial(read_source, path), title)
    return clouds


def import_clouds(
    clouds: Mapping[Path, PointCloud],
    unit: str = "mm",
    probe_radius: float = 0.0,
    near_origin: bool = True,
) -> list[Any]:
    """Put files that were read into the active document, or a new one, in one undo step.

    Parameters
    ----------
    clouds : what is in the files
    unit : of their numbers
    probe_radius : mm, above 0 when they hold centres of a ball
    near_origin : move clouds that lie far away

    Raises
    ------
    ValueError: numbers that cannot work. Then nothing is imported.
    """
    from freecad_edgescan.document.cloud_source import already_read

    from .cloud_looks import dress_clouds

    doc = FreeCAD.ActiveDocument
    is_new = doc is None
    if is_new:
        FreeCADGui.doCommand('FreeCAD.newDocument("Scan")')
        doc = FreeCAD.ActiveDocument
    given = "" if unit == "mm" else f", unit={unit!r}"
    given += f", probe_radius={probe_radius!r}" if probe_radius else ""
    given += "" if near_origin else ", near_origin=False"
    lines = [f"document.make_cloud(doc, {str(path)!r}{given})" for path in clouds]
    try:
        with already_read(clouds):
            made = run_as_one_step(doc, translate("Import cloud"), lines, dress_clouds)
    except BaseException:
        if is_new:
            FreeCAD.closeDocument(doc.Name)
        raise
    select_only(made)
    fit_view(doc)
    return made
