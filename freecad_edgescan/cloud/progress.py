# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who is told how far a task is, and who may cancel it."""

from __future__ import annotations

from typing import Protocol

__all__ = ["Progress", "Stage"]


class Progress(Protocol):
    """Anything that has ``update``; False cancels, and what was found so far is kept."""

    def update(self, fraction: float, so_far: object) -> bool:
        """Take note of the share that is done (0 … 1, nan when unknown); answer False to cancel."""
        ...


class Stage:
    """Progress of one stage of a task, told as that of the whole task.

    Parameters
    ----------
    whole : told; None: nobody is
    begin, end : shares of the whole task at which the stage begins and ends

    Attributes
    ----------
    cancelled : whether the whole was cancelled at one of its updates
    """

    def __init__(self, whole: Progress | None, begin: float, end: float) -> None:
        self.whole, self.begin, self.end = whole, begin, end
        self.cancelled = False

    def update(self, fraction: float, so_far: object) -> bool:
        """Tell the whole; False once it is cancelled."""
        share = self.begin + fraction * (self.end - self.begin)
        if self.whole is not None and not self.whole.update(share, so_far):
            self.cancelled = True
        return not self.cancelled
