# SPDX-License-Identifier: LGPL-2.1-or-later
"""A timer that, once started, calls back once."""

from __future__ import annotations

from typing import Any

from .qt import QtCore

__all__ = ["single_shot"]


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
