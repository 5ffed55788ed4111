# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the lines of a probed scan have shown about a rounding, one after the other.

On a sharp edge the point at which a line is split lies on one of its sides; on a rounding it lies
beside both. A single line may miss a small rounding between two contacts; several in sequence make
it known that there is none. Then contacts are taken closer to the edge, which see more.
"""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["MISSED", "UNKNOWN", "Sharpness"]

MISSED = 0.1  # line pitches that a split point lies off the sides, on a rounding that was missed
_ROUNDED = 0.02  # line pitches that it lies off them, at least, on any rounding
_LINES_TO_KNOW = 6  # in sequence without a rounding
_LOOK_AGAIN = 24  # lines after it turned out that a rounding had been missed


@dataclass(frozen=True)
class Sharpness:
    """What is known of an edge up to one line.

    Attributes
    ----------
    lines : in sequence that showed no rounding
    waiting : lines before they count again, after they were mistaken
    """

    lines: int = 0
    waiting: int = 0

    @property
    def known(self) -> bool:
        """Whether the edge is known to have no rounding."""
        return self.lines >= _LINES_TO_KNOW

    def after(self, off: float) -> Sharpness:
        """With one more line, whose split point lies some line pitches off its sides."""
        if self.known and off > MISSED:
            # Only contacts so close to the edge have shown it; others would miss it again.
            return Sharpness(0, _LOOK_AGAIN)
        if self.waiting:
            return Sharpness(0, self.waiting - 1)
        return Sharpness(self.lines + 1 if off <= _ROUNDED else 0)


UNKNOWN = Sharpness()
"""Before the first line."""
