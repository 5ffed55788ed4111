# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress on a terminal: one line that is rewritten; Ctrl-C keeps what was found so far."""

from __future__ import annotations

import math
import re
import signal
import sys
import threading
from contextlib import suppress
from time import monotonic
from types import FrameType
from typing import Any

__all__ = ["TerminalProgress", "exit_code", "tell"]


_ARGUMENT = re.compile(r"\b(method|unit)='(\w+)'")  # as it is given in Python


def tell(sentence: str) -> None:
    """Say a sentence on stderr; silent where nobody reads it any more.

    Where it advises to give an argument, as the functions do that raise it, an option is named.
    """
    with suppress(BrokenPipeError):
        typed = _ARGUMENT.sub(r"--\1 \2", sentence)
        print(f"edgescan: {typed}", file=sys.stderr, flush=True)


class TerminalProgress:
    """Tells stderr how far a task is, and cancels it gently on the first Ctrl-C.

    On a terminal one line is rewritten several times a second; elsewhere (a log file) a line is
    written every few seconds. A second Ctrl-C stops at once.
    """

    def __init__(self, task: str) -> None:
        self.task = task
        self.cancelled = False
        self._rewrites = sys.stderr.isatty()
        self._pause = 0.15 if self._rewrites else 5.0
        self._told = monotonic()
        self._width = 0
        self._handler: Any = None

    def __enter__(self) -> TerminalProgress:
        if threading.current_thread() is threading.main_thread():
            self._handler = signal.signal(signal.SIGINT, self._cancel)
        return self

    def __exit__(self, *_: object) -> None:
        self.clear()
        if self._handler is not None:
            signal.signal(signal.SIGINT, self._handler)

    def update(self, fraction: float, so_far: object) -> bool:
        """Tell the share that is done and what there is so far; False once Ctrl-C was pressed."""
        if monotonic() - self._told >= self._pause:
            self._told = monotonic()
            news = ", ".join(filter(None, (_share(fraction), _amount(so_far))))
            self._write(": ".join(filter(None, (self.task, news))))
        return not self.cancelled

    def clear(self) -> None:
        """Take the line off the terminal again."""
        if self._rewrites and self._width:
            self._put("\r" + " " * self._width + "\r")
            self._width = 0

    def _write(self, line: str) -> None:
        if self._rewrites:
            self._put("\r" + line.ljust(self._width))
            self._width = len(line)
        else:
            self._put(line + "\n")

    @staticmethod
    def _put(text: str) -> None:
        with suppress(BrokenPipeError):  # a task goes on when nobody watches it
            sys.stderr.write(text)
            sys.stderr.flush()

    def _cancel(self, number: int, frame: FrameType | None) -> None:
        if self.cancelled:
            raise KeyboardInterrupt
        self.cancelled = True


def exit_code(progress: TerminalProgress, found: bool = True) -> int:
    """0, or what a shell expects after Ctrl-C, which is told whether anything was found before."""
    if not progress.cancelled:
        return 0
    kept = "what was found so far is kept" if found else "nothing was complete yet"
    tell(f"stopped; {kept}.")
    return 130


def _share(fraction: float) -> str:
    return "" if math.isnan(fraction) else f"{100 * fraction:.0f} %"


def _amount(so_far: object) -> str:
    if isinstance(so_far, str):
        return so_far
    points = getattr(so_far, "points", None)
    return "" if points is None else f"{len(points)} edge points"
