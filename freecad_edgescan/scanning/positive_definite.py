# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inverses of many small symmetric positive definite matrices at once.

LAPACK inverts one matrix after the other, and some builds of OpenBLAS wake their threads for each
of them, which takes up to a thousand times as long as inverting it. Here each step is done to all
matrices together, by numpy alone.
"""

from __future__ import annotations

import numpy as np

__all__ = ["inverses"]


def inverses(matrices: np.ndarray) -> np.ndarray:
    """Inverses (…, k, k) of symmetric positive definite matrices (…, k, k).

    By Gauss-Jordan elimination on the diagonal, which needs no other pivots for such matrices
    (Higham, Accuracy and Stability of Numerical Algorithms, 2002, 14.4).
    """
    # Rows and columns first, so that what is done to all matrices is done to neighbours in memory.
    left = np.array(np.moveaxis(matrices, (-2, -1), (0, 1)), dtype=float, order="C")
    for k in range(len(left)):
        pivot = 1.0 / left[k, k]
        column, row = left[:, k].copy(), left[k] * pivot
        left -= column[:, None] * row
        left[k], left[:, k] = row, -column * pivot
        left[k, k] = pivot
    return np.moveaxis(left, (0, 1), (-2, -1))
