# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was published of the case study: Schreve chapter 7, table 1, and appendix F."""

from __future__ import annotations

__all__ = ["GRIDS", "PUBLISHED_ERRORS", "PUBLISHED_MINUTES", "SEGMENT_DISTANCE", "THINNED_PITCH"]

GRIDS = ((12, 6), (14, 7))
"""Control points along the rails and along the profiles."""

THINNED_PITCH = 5.0
"""mm, of the grid to which the cloud was thinned before surfaces were fitted."""

SEGMENT_DISTANCE = 3.0
"""mm from a base surface within which points belong to it."""

PUBLISHED_ERRORS = {
    (1, (12, 6)): (0.224, 1.183),
    (2, (12, 6)): (0.426, 2.114),
    (1, (14, 7)): (0.224, 1.058),
    (2, (14, 7)): (0.384, 1.632),
}
"""Pipe and grid: average and maximum distance of the points from the blended sweep, mm."""

PUBLISHED_MINUTES = {
    "read the cloud": 15.0,  # copy data into CADLAB and set up CAD database
    "scan edges": 35.0 + 90.0 + 70.0,
    "rails": 20.0,  # join edge sections
    "profiles and base surfaces": 20.0,
    "compensate and segment": 13.0,  # cut point cloud
    "fit swept surfaces": 16.0,
}
"""Steps at the desk, minutes."""
