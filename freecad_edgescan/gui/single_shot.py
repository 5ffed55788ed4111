# SPDX-License-Identifier: LGPL-2.1-or-later
"""Timers that, once started, call back once.

They are made in Python. ``QTimer.singleShot`` makes its timer in C++ and looks for what Python
knows at its address, where PySide may still remember a widget that FreeCAD has deleted. FreeCAD
0.20 was seen to crash within it, once in many thousand calls.
"""

from __future__ import annotations

from typing import Any

from .qt import QtCore

__all__ = ["call_later", "single_shot"]


def single_shot(parent: Any, milliseconds: int, answer: Any) -> Any:
    """Make one; starting it again before it has called back puts that off.

    Parameters
    ----------
    parent : QObject it goes with
    milliseconds : from its start until it calls back
    answer : slot or signal
    """
    timer = QtCore.QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(milliseconds)
    timer.timeout.connect(answer)
    return timer


def call_later(answer: Any, milliseconds: int = 0) -> None:
    """Call back once; with 0 ms, when the window has handled what has come in already.

    Parameters
    ----------
    answer : called without arguments
    milliseconds : until then
    """
    timer = single_shot(QtCore.QCoreApplication.instance(), milliseconds, answer)
    timer.timeout.connect(timer.deleteLater)
    timer.start()
