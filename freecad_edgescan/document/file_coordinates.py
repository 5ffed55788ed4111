# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places in the coordinates of a cloud's file, where those of the document are meant."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..scanning import Gate, Start
from .bridge import Array, origin_of

__all__ = ["refuse_file_coordinates"]


def refuse_file_coordinates(cloud: Any, *places: Array | Start | Gate | None) -> None:
    """Refuse places that lie where a cloud was before it was moved near the origin.

    Parameters
    ----------
    cloud : Points::Feature; one whose Origin is zero was not moved
    places : (3,) mm, or what begins at one; None is none

    Raises
    ------
    ValueError: a place that is nearer to the Origin than to zero, near which the cloud is now.
    """
    origin = origin_of(cloud)
    for place in places if origin.any() else ():
        if place is None:
            continue
        point = np.asarray(getattr(place, "point", place), dtype=float)
        if np.linalg.norm(point - origin) < np.linalg.norm(point):
            raise ValueError(
                f"The place ({_exact(point)}) is in the coordinates of the file, but the cloud "
                f"{cloud.Label!r} was moved near the document's origin: subtract the cloud's "
                f"Origin, ({_exact(origin)}), which gives ({_exact(point - origin)})."
            )


def _exact(point: Array) -> str:
    """All digits that count, which far away are more than four."""
    return ", ".join(f"{value:.3f}".rstrip("0").rstrip(".") for value in point)
