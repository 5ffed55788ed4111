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
_PATIENCE = 400  # ms until a dialog appears


def result_of(calculate: Callable[[Any], Result], title: str) -> Result:
    """Run ``calculate(progress)`` in a thread while the window lives, and hand back its result.

    Parameters
    ----------
    calculate : works on arrays only; it may tell the progress how far it is
    title : what the user waits for

    Raises
    ------
    ValueError: of the calculation.
    CancelledError: the user has cancelled.
    """
    waiting = _Waiting(calculate, title)
    waiting.wait()
    if waiting.cancelled:
        raise CancelledError
    if waiting.problem:
        raise ValueError(waiting.problem)
    return waiting.result  # type: ignore[no-any-return]


class _Waiting(QtCore.QObject):
    """A QObject of the main thread: what the thread reports arrives here, not over there."""

    def __init__(self, calculate: Callable[[Any], Any], title: str) -> None:
        super().__init__()
        self.result: Any = None
        self.problem = ""
        self.cancelled = False
        self._loop = QtCore.QEventLoop()
        self._dialog = QtWidgets.QProgressDialog(FreeCADGui.getMainWindow())
        self._dialog.setWindowTitle(title)
        self._dialog.setLabelText(title)
        self._dialog.setCancelButtonText(translate("Cancel"))
        self._dialog.setWindowModality(QtCore.Qt.ApplicationModal)
        self._dialog.setMinimumDuration(24 * 3600 * 1000)  # shown below, when it is time
        self._dialog.setAutoReset(False)
        self._dialog.setRange(0, 0)
        self._dialog.canceled.connect(self._cancel)
        self._patience = QtCore.QTimer(self)
        self._patience.setSingleShot(True)
        self._patience.timeout.connect(self._dialog.show)
        self._work = Background(lambda progress: calculate(progress))
        self._work.advanced.connect(self._advance)
        self._work.succeeded.connect(self._succeed)
        self._work.failed.connect(self._fail)

    def wait(self) -> None:
        """Until the calculation is done or cancelled; the thread is gone then."""
        self._patience.start(_PATIENCE)
        self._work.start()
        self._loop.exec_() if hasattr(self._loop, "exec_") else self._loop.exec()
        self._patience.stop()
        self._work.abandon()
        self._dialog.canceled.disconnect(self._cancel)
        self._dialog.close()
        self._dialog.deleteLater()

    def _advance(self, fraction: float, _so_far: object) -> None:
        if np.isfinite(fraction):
            self._dialog.setRange(0, 1000)
            self._dialog.setValue(round(1000 * fraction))

    def _succeed(self, result: Any) -> None:
        self.result = result
        self._loop.quit()

    def _fail(self, sentence: str) -> None:
        self.problem = sentence
        self._loop.quit()

    def _cancel(self) -> None:
        self.cancelled = True
        self._loop.quit()
