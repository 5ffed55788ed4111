# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much larger sigma is stated where the points of an edge err together.

Along a long edge some points are far off and most are near, and half of them lie within 1.18 of
their standard deviations. The points of a short edge share what they were fitted to: one edge in
twenty is off by 2.45 of its standard deviations as a whole, and nothing along it shows that. Sigma
answers for the whole edge: it is stated so that the root mean square of the distances along an edge
is above 2.5 of them for one edge in ten thousand.
"""

from __future__ import annotations

import numpy as np
from scipy.stats import chi2

__all__ = ["reserve"]

_MOST, _CERTAINLY = 2.5, 1.0 - 1e-4


def reserve(independent: float) -> float:
    """What the standard deviations of an edge's points are multiplied with, 1 or more.

    Parameters
    ----------
    independent : number of independent errors in the edge's points, each in both directions
        across the edge; 1 or more

    Notes
    -----
    The mean of k squared distances is χ² with 2 k degrees of freedom, over k. From 7 independent
    errors on nothing is added.
    """
    largest = np.sqrt(chi2.ppf(_CERTAINLY, 2.0 * independent) / independent)
    return max(1.0, float(largest) / _MOST)
