# SPDX-License-Identifier: LGPL-2.1-or-later
"""A place given in the unit of the file, where places are in mm."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import numpy as np

from freecad_edgescan.cloud import PointCloud

__all__ = ["told_of_unit"]

_FAR = 1.0  # sizes of the cloud beside it


@contextmanager
def told_of_unit(
    place: Sequence[float] | np.ndarray, cloud: PointCloud, unit: str | None
) -> Iterator[None]:
    """Add to what is refused at a place (3,) far off the cloud that places are in mm.

    Parameters
    ----------
    place : mm
    cloud : brought to mm
    unit : of its file

    Raises
    ------
    ValueError: in place of the one that is raised within.
    """
    try:
        yield
    except ValueError as error:
        low, high = cloud.bounds
        room = _FAR * float(np.max(high - low))
        at = np.asarray(place, dtype=float)
        if unit in (None, "mm") or np.all((at >= low - room) & (at <= high + room)):
            raise
        raise ValueError(f"{error} Places such as --at are in mm, whatever the --unit.") from error
