# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normal equations of neighbouring sections, as each section would have them.

The sections of a path stand a little beside the edge and turned about it, each in its own way. What
a section borrows has to be seen from where it stands itself: in terms of (1, s, (s²+n²)/2, u, n) a
shift and a turn in the section are linear, so that the points themselves are not needed.
"""

from __future__ import annotations

import numpy as np

from ..geometry.frames import turned_along
from .edge_path import EdgePath
from .section import unrolled
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
    return (
        moved_moments(np.roll(own, -step, axis=0), _moves(path, step, reach))
        * (there[:, None, None])
    )


def _moves(path: EdgePath, step: int, reach: float) -> np.ndarray:
    """Matrices (m, 2, 5, 5) from a neighbour's terms to a section's own, for each side."""
    here = path.frames
    order = np.roll(np.arange(len(here)), -step)
    there = here[order]
    along, offset, _ = unrolled(here, np.arange(len(here)), there.origin)
    axes = np.stack([here.sides, here.normals], axis=2)  # (m, side, axis, 3)
    theirs = np.stack([there.sides, there.normals], axis=2)
    turned = turned_along(theirs.reshape(-1, 4, 3), there.tangent, here.tangent)
    turn = np.einsum("mkai,mkbi->mkab", axes, turned.reshape(theirs.shape))
    shift = np.einsum("mkai,mi->mka", axes, offset) / reach
    moves = np.zeros((len(here), 2, 5, 5))
    moves[..., 0, 0] = moves[..., 2, 2] = moves[..., 3, 3] = 1.0
    moves[..., 3, 0] = along[:, None] / reach
    for row, axis in ((1, 0), (4, 1)):
        moves[..., row, 0] = shift[..., axis]
        moves[..., row, 1], moves[..., row, 4] = turn[..., axis, 0], turn[..., axis, 1]
    moves[..., 2, 0] = 0.5 * np.square(shift).sum(axis=-1)
    pulled = np.einsum("mka,mkab->mkb", shift, turn)
    moves[..., 2, 1], moves[..., 2, 4] = pulled[..., 0], pulled[..., 1]
    return moves
