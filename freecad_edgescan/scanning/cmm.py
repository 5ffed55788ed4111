# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a probed scan needs of a coordinate measuring machine, real or virtual.

Two movements are enough (Schreve 3.1.3): one that only travels, and one that measures. A driver
of a real machine that offers them can stand wherever a virtual machine stands.
"""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np

__all__ = ["Cmm"]


@runtime_checkable
class Cmm(Protocol):
    """A machine that touches a part.

    Attributes
    ----------
    probe_radius : mm; above 0 the machine answers with the centre of its ball, at 0 with points
        of the surface
    approach : (3,) unit vector, the direction its probe points to, from the air into the part
    """

    probe_radius: float
    approach: np.ndarray

    def move(self, start: np.ndarray, end: np.ndarray) -> np.ndarray | None:
        """Travel in a straight line without measuring.

        Parameters
        ----------
        start : (3,) mm, where the machine stands
        end : (3,) mm, where it is to go

        Returns
        -------
        None when the way is free; otherwise (3,) mm, where it collided and stands now.
        """
        ...

    def touch(
        self,
        start: np.ndarray,
        direction: np.ndarray,
        prehit_distance: float,
        search_distance: float,
    ) -> np.ndarray | None:
        """Travel along a search line until something is touched, and back into the air.

        After a contact the machine goes back along the search line by the prehit distance, but
        not beyond the start, and stands there; when nothing was touched, it goes back to the start.

        Parameters
        ----------
        start : (3,) mm, where the machine stands. Before the first touch of a scan nobody knows
            where it is: it has to come to this place by itself
        direction : (3,) unit vector of the search line
        prehit_distance : mm from the start to where the part is expected
        search_distance : mm to go on behind that before the search is given up

        Returns
        -------
        (3,) mm, the contact; None when nothing was touched.
        """
        ...
