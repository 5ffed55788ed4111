# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that make clouds from something else: simulated, compensated and thinned ones."""

from __future__ import annotations

from typing import Any

import FreeCAD

from .command import Command
from .obstacles import no_cloud, panel_open
from .recorded_step import object_line, run_as_one_step
from .selected import chosen_cloud
from .translation import count_text, translate

__all__ = ["cloud_commands"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def cloud_commands() -> list[Command]:
    """All of them, in the order of the toolbar."""
    return [
        Command(
            "EdgeScan_SimulatedCloud",
            QT_TRANSLATE_NOOP("EdgeScan_SimulatedCloud", "Simulated cloud…"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_SimulatedCloud",
                "Scan a part without a scanner, with the pitch, noise and probe you choose. Select "
                "an object with faces, or nothing to scan the core box of the case study.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_SimulatedCloud", "Select a part, or nothing"),
            _simulate,
            panel_open,
        ),
        Command(
            "EdgeScan_CompensateCloud",
            QT_TRANSLATE_NOOP("EdgeScan_CompensateCloud", "Compensate cloud"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_CompensateCloud",
                "Move the centres of a probing ball onto the part they touched. Select a cloud "
                "whose ProbeRadius is set.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_CompensateCloud", "Select a cloud of probe centres"),
            _compensate,
            no_cloud,
        ),
        Command(
            "EdgeScan_ThinCloud",
            QT_TRANSLATE_NOOP("EdgeScan_ThinCloud", "Thin cloud…"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_ThinCloud",
                "Keep fewer points, evenly spread over the surface. Select a cloud.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_ThinCloud", "Select a cloud"),
            _thin,
            no_cloud,
        ),
    ]


def _simulate(doc: Any) -> None:
    from .shown import fit_view, select_only
    from .simulated_cloud_dialog import SimulatedCloudDialog

    dialog = SimulatedCloudDialog(doc)
    if not dialog.asked():
        return
    import FreeCADGui

    is_new = doc is None
    if is_new:
        FreeCADGui.doCommand('FreeCAD.newDocument("Scan")')
        doc = FreeCAD.ActiveDocument
    from .cloud_looks import dress_clouds
    from .qt import QtCore, QtWidgets

    QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        made = run_as_one_step(doc, translate("Simulated cloud"), [dialog.line()], dress_clouds)
    except BaseException:
        if is_new:
            FreeCAD.closeDocument(doc.Name)
        raise
    finally:
        QtWidgets.QApplication.restoreOverrideCursor()
    select_only(made)
    fit_view(doc)


def _compensate(doc: Any) -> None:
    cloud = chosen_cloud(doc)
    line = f"document.make_compensated_cloud(doc, {object_line(cloud)})"
    _make_instead(cloud, translate("Compensate cloud"), line)


def _thin(doc: Any) -> None:
    from freecad_edgescan import document

    from .busy import result_of
    from .form_dialog import FormDialog
    from .length_field import length_field, length_in

    cloud = chosen_cloud(doc)
    numbers = document.point_cloud(cloud)
    title = translate("Thin cloud")
    pitch_now = result_of(lambda _: numbers.pitch, title)
    dialog = FormDialog(
        title,
        "EdgeScan_ThinCloud",
        translate(
            "{label} has {count} points. A pitch twice that of the cloud keeps a quarter of them. "
            "Edges are found best in the full cloud."
        ).format(label=cloud.Label, count=count_text(len(numbers))),
    )
    dialog.setObjectName("EdgeScanThinCloud")
    field = dialog.add(
        translate("&Pitch:"),
        length_field(2.0 * pitch_now, translate("One point stays for each pitch² of surface.")),
    )
    if not dialog.asked():
        return
    pitch = length_in(field)
    _make_instead(
        cloud, title, f"document.make_thinned_cloud(doc, {object_line(cloud)}, {pitch!r})"
    )


def _make_instead(cloud: Any, title: str, line: str) -> None:
    """Make a cloud by a recorded line, and hide the one it comes from."""
    from .compute_beside import computing_beside

    run_as_one_step(cloud.Document, title, [line], computing_beside(title))
    cloud.ViewObject.Visibility = False
