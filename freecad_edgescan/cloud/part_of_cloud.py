# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cloud made of points of another one, which knows which points they were."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .point_cloud import PointCloud

__all__ = ["PartOfCloud"]


class PartOfCloud(PointCloud):
    """Points that were kept of another cloud, moved or not.

    Parameters
    ----------
    points, probe_radius, approach : as for ``PointCloud``; all points finite
    kept : (n,) bool, for each of the other cloud's points whether this one holds it; in its order
    message : what a person should know

    Raises
    ------
    ValueError: a mask that does not hold as many points as there are.
    """

    kept: NDArray[np.bool_]
    message: str

    def __init__(
        self,
        points: ArrayLike,
        kept: ArrayLike,
        probe_radius: float = 0.0,
        approach: ArrayLike | None = None,
        message: str = "",
    ) -> None:
        super().__init__(points, probe_radius, approach)
        mask = np.array(kept, dtype=bool)
        if self.dropped or mask.ndim != 1 or np.count_nonzero(mask) != len(self):
            raise ValueError(
                f"The mask keeps {np.count_nonzero(mask)} points, but there are {len(self)} finite "
                "ones; give one point for each that is kept."
            )
        mask.setflags(write=False)
        object.__setattr__(self, "kept", mask)
        object.__setattr__(self, "message", message)
