# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress of a task that is one of several equal parts."""

from __future__ import annotations

from ..scanning import Progress

__all__ = ["PartialProgress"]


class PartialProgress:
    """Tells a whole task's progress how far one of its parts is.

    Parameters
    ----------
    whole : told; None: nobody is
    number : of the part, from 0
    of : number of parts
    """

    def __init__(self, whole: Progress | None, number: int, of: int) -> None:
        self.whole, self.number, self.of = whole, number, of

    def update(self, fraction: float, so_far: object) -> bool:
        """Tell the whole; False once it is cancelled."""
        if self.whole is None:
            return True
        share = (self.number + fraction) / self.of
        return self.whole.update(share, f"part {self.number + 1} of {self.of}")
