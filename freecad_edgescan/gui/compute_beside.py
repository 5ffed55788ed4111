# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects that a command has made, computed while the window stays alive and may cancel."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCADGui

from freecad_edgescan.document.computed_object import ComputedProxy, Task, write_computed

from .background import Background
from .qt import QtCore, QtWidgets

__all__ = ["CancelledByUserError", "computing_beside"]

_SILENT = 500  # ms before a dialog is worth showing


class CancelledByUserError(Exception):
    """The user has cancelled what a command was doing; there is nothing to say about it."""


def computing_beside(title: str) -> Callable[[list[Any]], None]:
    """What computes new objects, for `run_as_one_step`; the recompute after it has nothing to do.

    Parameters
    ----------
    title : of the dialog

    Raises
    ------
    ValueError: an object cannot be computed; the text says why.
    CancelledByUserError
    """

    def compute(made: list[Any]) -> None:
        for item in made:
            proxy = getattr(item, "Proxy", None)
            ready = not any("Touched" in source.State for source in item.OutList)
            if isinstance(proxy, ComputedProxy) and proxy.PLAIN and ready:
                write_computed(item, _computed(proxy.task(item), title))

    return compute


def _computed(task: Task, title: str) -> Any:
    """The result of a task that runs in a thread; with a dialog when it takes its time."""
    outcome: list[Any] = []

    def calculate(progress: Background) -> None:
        try:
            outcome.append(task(progress))
        except Exception as error:  # raised again in the main thread
            outcome.append(error)

    work = Background(calculate)
    work.start()
    if not work.wait(_SILENT):
        _watch(work, title)
    (result,) = outcome
    if isinstance(result, Exception):
        raise result
    return result


def _watch(work: Background, title: str) -> None:
    """Show how far the work is until it ends."""
    dialog = QtWidgets.QProgressDialog(f"{title} …", "Cancel", 0, 100, FreeCADGui.getMainWindow())
    dialog.setWindowTitle(title)
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setAutoReset(False)
    dialog.setAutoClose(False)
    dialog.setMinimumDuration(0)
    loop = QtCore.QEventLoop()

    def advance(fraction: float, _so_far: object) -> None:
        if fraction == fraction:  # nan: nobody knows
            dialog.setValue(int(100 * fraction))

    def stop() -> None:
        work.stop()
        dialog.setLabelText(f"{title}: stopping …")
        dialog.show()  # nothing else is to be done until it has stopped

    work.advanced.connect(advance)
    work.finished.connect(loop.quit)
    dialog.canceled.connect(stop)
    dialog.show()
    if work.isRunning():
        run = getattr(loop, "exec", None) or loop.exec_
        run()
    work.wait()
    cancelled = dialog.wasCanceled()
    dialog.hide()
    dialog.deleteLater()
    if cancelled:
        raise CancelledByUserError
