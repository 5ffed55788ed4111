# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normal equations of neighbouring sections, as each section would have them.

The sections of a path are turned about the edge, each a little in its own way; far from the edge a
turn of a milliradian is more than the noise. What a section borrows is turned to where it stands
itself: in terms of (1, s, (s²+n²)/2, u, n) that is linear, so that the points themselves are not
needed. How far the sections stand beside the edge is taken to be alike: a shift by what the path's
bend says would be worse than none, for over several sections a small error of the bend is a large
one of the place.
"""

from __future__ import annotations

import numpy as np

from ..geometry.frames import turned_along
from .edge_path import EdgePath
from .normal_equations import moved_moments, sum_stretches

__all__ = ["Neighbours"]


class Neighbours:
    """The neighbours of each of m sections of a path.

    Parameters
    ----------
    path : the sections
    reach : that lengths are divided by, mm
    """

    def __init__(self, path: EdgePath, reach: float) -> None:
        self._path, self._reach = path, reach
        self._known: dict[int, np.ndarray] = {}

    def borrowed(self, own: np.ndarray, step: int, rows: np.ndarray | None = None) -> np.ndarray:
        """Normal equations of the sections a number of steps further.

        Parameters
        ----------
        own : (m, 2, …, 15) of every section, lengths in reaches
        step : to the section that is borrowed from; beyond the ends of an open edge nothing is
        rows : numbers of the sections that borrow; None: all
        """
        which = np.arange(len(own)) if rows is None else rows
        theirs = own[(which + step) % len(own)]
        blocks = theirs.reshape(*theirs.shape[:2], -1, theirs.shape[-1])
        return moved_moments(blocks, self._moves(step)[which]).reshape(theirs.shape)

    def pooled(self, own: np.ndarray, width: int, rows: np.ndarray | None = None) -> np.ndarray:
        """Sum of a section's own normal equations and its neighbours' on each side."""
        total = own if rows is None else own[rows]
        return total + sum(self.borrowed(own, step, rows) for step in self._steps(width))

    def pooled_stretches(self, own: np.ndarray, stretch: np.ndarray, width: int) -> np.ndarray:
        """The same (m, 2, 15) of each section's stretch of blocks, of (m, 2, BLOCKS, 15)."""
        total = sum_stretches(own, stretch)
        for step in self._steps(width):
            theirs = sum_stretches(np.roll(own, -step, axis=0), stretch)
            total = total + moved_moments(theirs[:, :, None], self._moves(step))[:, :, 0]
        return total

    def pooled_pairs(self, own: np.ndarray, width: int) -> np.ndarray:
        """Sum of matrices (m, k, k) over the five terms of both sides and others behind them.

        What is behind them, as a radius, is the same in every section.
        """
        total = own.copy()
        for step in self._steps(width):
            moves = self._moves(step)
            turn = np.zeros_like(own)
            turn[:, :5, :5], turn[:, 5:10, 5:10] = moves[:, 0], moves[:, 1]
            rest = np.arange(10, own.shape[-1])
            turn[:, rest, rest] = moves[:, :1, 0, 0]
            total += turn @ np.roll(own, -step, axis=0) @ np.swapaxes(turn, 1, 2)
        return total

    def _steps(self, width: int) -> list[int]:
        width = min(width, (len(self._path) - 1) // 2)
        return [step for step in range(-width, width + 1) if step]

    def _moves(self, step: int) -> np.ndarray:
        """Matrices (m, 2, 5, 5) from a neighbour's terms to a section's own, for each side.

        Zero where there is no neighbour.
        """
        if step not in self._known:
            self._known[step] = _moves(self._path, step, self._reach)
        return self._known[step]


def _moves(path: EdgePath, step: int, reach: float) -> np.ndarray:
    here = path.frames
    there = here[np.roll(np.arange(len(here)), -step)]
    axes = np.stack([here.sides, here.normals], axis=2)  # (m, side, axis, 3)
    theirs = np.stack([there.sides, there.normals], axis=2)
    turned = turned_along(theirs.reshape(-1, 4, 3), there.tangent, here.tangent)
    turn = np.einsum("mkai,mkbi->mkab", axes, turned.reshape(theirs.shape))
    onward = path.ahead(step)
    moves = np.zeros((len(here), 2, 5, 5))
    moves[..., 0, 0] = moves[..., 2, 2] = moves[..., 3, 3] = 1.0
    moves[..., 3, 0] = np.nan_to_num(onward)[:, None] / reach
    for row, axis in ((1, 0), (4, 1)):
        moves[..., row, 1], moves[..., row, 4] = turn[..., axis, 0], turn[..., axis, 1]
    return moves * np.isfinite(onward)[:, None, None, None]
