# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an object's ``execute`` tells FreeCAD that its inputs cannot work, in one sentence.

FreeCAD marks an object invalid only when an exception leaves ``execute``, and prints its Python
trace, which says nothing to a user whose input was refused. It gets the trace by Python's own
printer, which heeds ``sys.tracebacklimit``; so that is 0 while FreeCAD holds the exception.
"""

from __future__ import annotations

import sys

__all__ = ["RefusalError"]


class RefusalError(ValueError):
    """An input cannot work. Raise it last in ``execute``, and keep it nowhere.

    While one exists no trace is printed by anybody; FreeCAD drops it as soon as it has its text.
    """

    def __init__(self, sentence: str) -> None:
        super().__init__(sentence)
        self._limit = getattr(sys, "tracebacklimit", None)
        sys.tracebacklimit = 0

    def __del__(self) -> None:
        if self._limit is not None:
            sys.tracebacklimit = self._limit
        elif hasattr(sys, "tracebacklimit"):
            del sys.tracebacklimit
