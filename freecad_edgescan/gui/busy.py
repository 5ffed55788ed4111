# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wait for a calculation beside the window, which says what it waits for and can be cancelled."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import FreeCADGui
import numpy as np

from .background import Background
from .message import CancelledError
from .qt import QtCore, QtWidgets
from .translation import translate

__all__ = ["result_of"]

Result = TypeVar("Result")
_PATIENCE = 400  # ms until a dialog appears; nothing else can be done in the window meanwhile


def result_of(calculate: Callable[[Any], Result], title: str) -> Result:
    """Run ``calculate(progress)`` in a thread while the window lives, and hand back its result.

    Parameters
    ----------
    calculate : works on arrays only; it may tell the progress how far it is
    title : what the user waits for

    Raises
    ------
    CancelledError: the user has cancelled.
    Whatever the calculation raises.
    """
    outcome: list[Any] = []

    def run(progress: Background) -> None:
        try:
            outcome.append(calculate(progress))
        except Exception as error:  # raised again in the main thread
            outcome.append(error)

    work = Background(run)
    work.begin()
    if not work.wait(_PATIENCE):
        _Waiting(work, title).wait()
    (result,) = outcome
    if isinstance(result, Exception):
        raise result
    return result  # type: ignore[no-any-return]


class _Waiting(QtCore.QObject):
    """A QObject of the main thread: what the thread reports arrives here, not over there."""

    def __init__(self, work: Background, title: str) -> None:
        super().__init__()
        self._work = work
        self._loop = QtCore.QEventLoop()
        self._dialog = QtWidgets.QProgressDialog(FreeCADGui.getMainWindow())
        self._dialog.setWindowTitle(title)
        self._dialog.setLabelText(title)
        self._dialog.setCancelButtonText(translate("Cancel"))
        self._dialog.setWindowModality(QtCore.Qt.ApplicationModal)
        self._dialog.setMinimumDuration(24 * 3600 * 1000)  # shown below, not by Qt's guess
        self._dialog.setAutoReset(False)
        self._dialog.setAutoClose(False)
        self._dialog.setRange(0, 0)
        self._dialog.canceled.connect(self._cancel)
        work.advanced.connect(self._advance)
        work.finished.connect(self._loop.quit)
        self._advance()  # what was told before anybody listened

    def wait(self) -> None:
        """Until the thread is gone.

        Raises
        ------
        CancelledError: the user has cancelled.
        """
        self._dialog.show()
        if self._work.isRunning():
            self._loop.exec_() if hasattr(self._loop, "exec_") else self._loop.exec()
        self._work.wait()
        cancelled = self._dialog.wasCanceled()
        self._dialog.canceled.disconnect(self._cancel)
        self._dialog.close()
        self._dialog.deleteLater()
        if cancelled:
            raise CancelledError

    def _advance(self) -> None:
        report = self._work.take()
        if report is not None and np.isfinite(report[0]):
            self._dialog.setRange(0, 1000)
            self._dialog.setValue(round(1000 * report[0]))

    def _cancel(self) -> None:
        self._work.stop()
        self._dialog.setLabelText(translate("Stopping…"))
        self._dialog.show()  # nothing else is to be done until it has stopped
