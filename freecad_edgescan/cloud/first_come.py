# SPDX-License-Identifier: LGPL-2.1-or-later
"""First come, first served: who of many is taken when some stand in each other's way.

All are gone through at once: whoever is the first of its neighbourhood is taken, its neighbours go,
and so on (Luby 1986, A simple parallel algorithm for the maximal independent set problem). The
result is that of going through them one by one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .progress import Progress

__all__ = ["first_come"]


def first_come(
    rank: NDArray[np.intp],
    one: NDArray[np.intp],
    other: NDArray[np.intp],
    progress: Progress | None = None,
) -> NDArray[np.bool_]:
    """Which of many (n,) are taken when each in turn is, unless a neighbour was before.

    Parameters
    ----------
    rank : (n,) when each one's turn is, all different
    one, other : (k,) pairs of neighbours
    progress : told the share that is decided; where it answers False, of those who are not decided
        by then only those without open neighbours are taken
    """
    taken, open_ = np.zeros(len(rank), dtype=bool), np.ones(len(rank), dtype=bool)
    while len(one):
        # those whose every open neighbour comes later
        waits = np.zeros(len(rank), dtype=bool)
        later = rank[one] > rank[other]
        waits[one[later]] = True
        waits[other[~later]] = True
        taken |= open_ & ~waits
        gone = np.zeros(len(rank), dtype=bool)
        gone[one[taken[other]]] = True
        gone[other[taken[one]]] = True
        open_ &= ~(taken | gone)
        still = open_[one] & open_[other]
        one, other = one[still], other[still]
        if progress is not None and not progress.update(1.0 - float(open_.mean()), None):
            open_[one] = open_[other] = False
            break
    return taken | open_
