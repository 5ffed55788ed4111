# SPDX-License-Identifier: LGPL-2.1-or-later
"""A calculation on arrays beside the window, which stays alive meanwhile.

The function given never touches a document, the screen or anything else of FreeCAD's: it gets
arrays and hands back plain data. Its results arrive in the main thread as Qt signals. Of the
reports on the way only the newest is kept, until the main thread has time to take it: a slow
screen gets fewer of them, and is never behind.
"""

from __future__ import annotations

import time
import traceback
from collections.abc import Callable
from typing import Any

from .qt import QtCore
from .translation import translate

__all__ = ["Background", "running"]

_SHORTEST_INTERVAL = 0.04  # seconds between two reports

_running: set[Background] = set()  # keeps each alive until its thread has ended


class Background(QtCore.QThread):
    """Runs ``calculate(progress=self)`` in a thread of its own, from ``begin`` on.

    Parameters
    ----------
    calculate : called in the thread
    digest : makes of what the calculation reports what the main thread shall take; called in the
        thread too

    Signals
    -------
    advanced() : there is a report to ``take``, at most 25 times a second
    succeeded(result)
    failed(sentence)
    """

    advanced = QtCore.Signal()
    succeeded = QtCore.Signal(object)
    failed = QtCore.Signal(str)

    def __init__(
        self,
        calculate: Callable[..., Any],
        digest: Callable[[Any], Any] = lambda so_far: so_far,
    ) -> None:
        super().__init__()
        self._calculate = calculate
        self._digest = digest
        self._cancelled = False
        self._silent = False
        self._reported = -_SHORTEST_INTERVAL
        self._report: tuple[float, Any] | None = None

    def begin(self) -> None:
        """Start the thread."""
        _let_quit_wait()
        _running.add(self)
        self.finished.connect(self._gone)
        self.start()

    def run(self) -> None:
        """Calculate; Qt calls this in the thread."""
        try:
            result = self._calculate(progress=self)
        except ValueError as error:
            self._tell(self.failed, str(error))
        except Exception as error:  # a fault of ours: the panel stays open, the trace is kept
            traceback.print_exc()
            sentence = translate("The calculation broke off ({kind}: {error}).")
            self._tell(self.failed, sentence.format(kind=type(error).__name__, error=error))
        else:
            self._tell(self.succeeded, result)

    def update(self, fraction: float, so_far: object) -> bool:
        """Report how far it is; False once it is to stop (the ``Progress`` protocol)."""
        now = time.monotonic()
        waited = now - self._reported >= _SHORTEST_INTERVAL
        if waited and self._report is None and not self._silent:
            self._reported = now
            self._report = fraction, self._digest(so_far)
            self._tell(self.advanced)
        return not self._cancelled

    def take(self) -> tuple[float, Any] | None:
        """The newest report: share that is done (nan: unknown) and the digest; None: none."""
        report, self._report = self._report, None
        return report

    def stop(self) -> None:
        """End at the next report; what was found so far is still handed over."""
        self._cancelled = True

    def abandon(self) -> None:
        """End at the next report and hand over nothing. The window need not wait for it."""
        self._cancelled = True
        self._silent = True

    def _tell(self, signal: Any, *values: object) -> None:
        if not self._silent:
            signal.emit(*values)

    def _gone(self) -> None:
        self.wait()  # for the thread's very last steps
        _running.discard(self)


def running() -> int:
    """How many calculations have not ended yet, abandoned ones too."""
    return len(_running)


def _let_quit_wait() -> None:
    """Qt must not destroy a thread that runs: leaving FreeCAD waits for it."""
    if not _quit_waits:
        _quit_waits.append(True)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(_wait_for_all)


_quit_waits: list[bool] = []


def _wait_for_all() -> None:
    for work in list(_running):
        work.abandon()
        work.wait()
