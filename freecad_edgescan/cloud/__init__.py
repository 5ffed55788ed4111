# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point clouds: reading, writing, statistics, and simulated clouds with known truth."""

from .point_cloud import PointCloud, require_surface
from .simulated_cloud import SimulatedCloud
from .torus_object import TorusFace, TorusObject
from .true_edge import TrueEdge

__all__ = [
    "PointCloud",
    "require_surface",
    "SimulatedCloud",
    "TorusFace",
    "TorusObject",
    "TrueEdge",
]
