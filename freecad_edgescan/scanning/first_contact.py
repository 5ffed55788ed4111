# SPDX-License-Identifier: LGPL-2.1-or-later
"""How early a virtual probe touches, that takes the first of all points within its pitch.

Of several points that scatter normally about a surface the first one lies outside of it, and
scatters less than any one of them: as the largest of several standard normal numbers does.
"""

from __future__ import annotations

import numpy as np

__all__ = ["first_of_several"]

_POINTS = (1, 2, 3, 4, 5, 7, 10, 20)
_EARLY = (0.0, 0.564, 0.846, 1.029, 1.163, 1.352, 1.539, 1.867)
_SCATTER = (1.0, 0.826, 0.748, 0.701, 0.669, 0.626, 0.587, 0.525)


def first_of_several(corridor: float, pitch: float) -> tuple[float, float]:
    """How early the first point lies on the average, and how much it scatters, in noise.

    Parameters
    ----------
    corridor : how far from the search line points are touched, mm
    pitch : of the cloud, mm
    """
    points = np.pi * (corridor / pitch) ** 2
    early, scatter = (float(np.interp(points, _POINTS, row)) for row in (_EARLY, _SCATTER))
    return early, scatter
