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
    outcome: dict[str, Any] = {}
    dialog = QtWidgets.QProgressDialog(FreeCADGui.getMainWindow())
    dialog.setWindowTitle(title)
    dialog.setLabelText(title)
    dialog.setCancelButtonText(translate("Cancel"))
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(_PATIENCE)
    dialog.setAutoReset(False)
    dialog.setRange(0, 0)
    work = Background(lambda progress: calculate(progress))
    loop = QtCore.QEventLoop()

    def advance(fraction: float, _so_far: object) -> None:
        if np.isfinite(fraction):
            dialog.setRange(0, 1000)
            dialog.setValue(round(1000 * fraction))

    work.advanced.connect(advance)
    work.succeeded.connect(lambda result: outcome.update(result=result))
    work.failed.connect(lambda sentence: outcome.update(problem=sentence))
    work.finished.connect(loop.quit)
    dialog.canceled.connect(loop.quit)
    work.start()
    loop.exec_() if hasattr(loop, "exec_") else loop.exec()
    cancelled = dialog.wasCanceled()
    if cancelled:
        work.abandon()
    else:
        work.wait()
        QtWidgets.QApplication.processEvents()  # the result may still be on its way
    dialog.close()
    dialog.deleteLater()
    if cancelled:
        raise CancelledError
    if "problem" in outcome:
        raise ValueError(outcome["problem"])
    return outcome["result"]  # type: ignore[no-any-return]
