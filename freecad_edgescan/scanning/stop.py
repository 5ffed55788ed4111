# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why a walk along an edge ended."""

from __future__ import annotations

from enum import StrEnum


class Stop(StrEnum):
    """Reason for the end of an edge; the value is what a person reads."""

    START = "at the start that was given"
    GATE = "passed the gate"
    CLOSED = "came back to its own start"
    CORNER = "reached a corner"
    CLOUD_END = "reached the end of the cloud"
    SMOOTH = "came to where the two sides are one smooth surface"
    LOST = "lost the edge"
    LIMIT = "reached the largest number of edge points"
    CANCELLED = "was cancelled"
    COLLISION = "collided"
    REPEATED_POINT = "touched the same point twice"
    OFF_OBJECT = "left the object"
    NO_EDGE = "found no edge on a scan line"
    TOO_FEW_POINTS = "had too few points on a scan line"
    CMM_FAILED = "stopped because the measuring machine failed"

    def __str__(self) -> str:
        """Return the short name, as in tables."""
        return self.name


# Ends at which the sides go on.
GIVEN_ENDS = (Stop.START, Stop.GATE, Stop.CLOSED, Stop.CANCELLED)
