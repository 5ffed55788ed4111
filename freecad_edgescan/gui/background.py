# SPDX-License-Identifier: LGPL-2.1-or-later
"""A calculation on arrays beside the window, which stays alive meanwhile.

The function given never touches a document, the screen or anything else of FreeCAD's: it gets
arrays and hands back plain data. Its results arrive in the main thread as Qt signals.
"""

from __future__ import annotations

import time
import traceback
from collections.abc import Callable
from typing import Any

from .qt import QtCore

__all__ = ["Background"]

_SHORTEST_INTERVAL = 0.04  # seconds between two reports


class Background(QtCore.QThread):
    """Runs ``calculate(progress=self)`` in a thread of its own.

    Signals
    -------
    advanced(fraction, so_far) : how far it is, at most 25 times a second
    succeeded(result)
    failed(sentence)
    """

    advanced = QtCore.Signal(float, object)
    succeeded = QtCore.Signal(object)
    failed = QtCore.Signal(str)

    def __init__(self, calculate: Callable[..., Any], parent: Any = None) -> None:
        super().__init__(parent)
        self._calculate = calculate
        self._cancelled = False
        self._silent = False
        self._reported = 0.0

    def run(self) -> None:
        """Calculate; Qt calls this in the thread."""
        try:
            result = self._calculate(progress=self)
        except ValueError as error:
            self._tell(self.failed, str(error))
        except Exception as error:  # a fault of ours: the panel stays open, the trace is kept
            traceback.print_exc()
            self._tell(self.failed, f"The calculation broke off ({type(error).__name__}: {error}).")
        else:
            self._tell(self.succeeded, result)

    def update(self, fraction: float, so_far: object) -> bool:
        """Report how far it is; False once it is to stop (the ``Progress`` protocol)."""
        now = time.monotonic()
        if now - self._reported >= _SHORTEST_INTERVAL:
            self._reported = now
            self._tell(self.advanced, fraction, so_far)
        return not self._cancelled

    def stop(self) -> None:
        """End at the next report; what was found so far is still handed over."""
        self._cancelled = True

    def abandon(self) -> None:
        """End at the next report, hand over nothing, and wait until the thread is gone."""
        self._cancelled = True
        self._silent = True
        self.wait()

    def _tell(self, signal: Any, *values: object) -> None:
        if not self._silent:
            signal.emit(*values)
