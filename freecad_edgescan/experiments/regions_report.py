# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well the regions of a network are the faces of a known part."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..scanning.network import Region

__all__ = ["RegionsReport", "regions_report"]

_SAME = 0.8  # of the points that a region or a face holds, both of them hold


@dataclass(frozen=True)
class RegionsReport:
    """Regions beside faces; a face is found where one region is it.

    Attributes
    ----------
    regions, faces, found : how many there are, and how many faces are found
    share : of the points, that lie on faces which are found, 0 … 1
    """

    regions: int
    faces: int
    found: int
    share: float

    def text(self) -> str:
        """One line."""
        return (
            f"{self.regions} regions for {self.faces} faces; {self.found} of these, with "
            f"{100.0 * self.share:.1f} % of the points, are a region each"
        )


def regions_report(regions: Sequence[Region], labels: ArrayLike) -> RegionsReport:
    """Compare regions with the face (n,) of each point; faces that meet smoothly have one number.

    A region is a face when four fifths of the points that either of them holds are in both.
    """
    faces, of_points, sizes = np.unique(labels, return_inverse=True, return_counts=True)
    found = np.zeros(len(faces), dtype=bool)
    for region in regions:
        common = np.bincount(of_points[region.mask], minlength=len(faces))
        found |= common >= _SAME * (sizes + len(region) - common)
    return RegionsReport(
        len(regions), len(faces), int(found.sum()), float(sizes[found].sum() / sizes.sum())
    )
