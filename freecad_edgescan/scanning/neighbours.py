# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normal equations of neighbouring sections, as each section would have them.

The sections of a path are turned about the edge, each a little in its own way. What a section
borrows is turned to where it stands itself: in terms of (1, s, (s²+n²)/2, u, n) that is linear, so
that the points themselves are not needed. How far the sections stand beside the edge is taken to be
alike: a shift by what the path's bend says would be worse than none, for over several sections a
small error of the bend is a large one of the place.
"""

from __future__ import annotations

import numpy as np

from ..geometry.frames import turned_along
from .edge_path import EdgePath
from .side_fit import moved_moments

__all__ = ["borrowed"]


def borrowed(own: np.ndarray, path: EdgePath, step: int, reach: float) -> np.ndarray:
    """Normal equations (m, 2, 15) of the sections a number of steps further.

    Parameters
    ----------
    own : (m, 2, 15) of every section, lengths in reaches
    path : the sections
    step : to the section that is borrowed from; beyond the ends of an open edge nothing is
    reach : mm
    """
    there = np.isfinite(path.ahead(step))
    seen = moved_moments(np.roll(own, -step, axis=0), _moves(path, step, reach))
    return seen * there[:, None, None]


def _moves(path: EdgePath, step: int, reach: float) -> np.ndarray:
    """Matrices (m, 2, 5, 5) from a neighbour's terms to a section's own, for each side."""
    here = path.frames
    there = here[np.roll(np.arange(len(here)), -step)]
    axes = np.stack([here.sides, here.normals], axis=2)  # (m, side, axis, 3)
    theirs = np.stack([there.sides, there.normals], axis=2)
    turned = turned_along(theirs.reshape(-1, 4, 3), there.tangent, here.tangent)
    turn = np.einsum("mkai,mkbi->mkab", axes, turned.reshape(theirs.shape))
    moves = np.zeros((len(here), 2, 5, 5))
    moves[..., 0, 0] = moves[..., 2, 2] = moves[..., 3, 3] = 1.0
    moves[..., 3, 0] = np.nan_to_num(path.ahead(step))[:, None] / reach
    for row, axis in ((1, 0), (4, 1)):
        moves[..., row, 1], moves[..., row, 4] = turn[..., axis, 0], turn[..., axis, 1]
    return moves
