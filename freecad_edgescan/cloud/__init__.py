# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point clouds: reading, writing, statistics, and simulated clouds with known truth."""

from .compensation import compensate_cloud
from .core_box import CoreBox
from .part_of_cloud import PartOfCloud
from .point_cloud import PointCloud, require_surface
from .reading import READABLE_ENDINGS, read_cloud
from .simulated_cloud import SimulatedCloud
from .thinning import thin_cloud
from .torus_object import TorusFace, TorusObject
from .true_edge import TrueEdge
from .writing import WRITABLE_ENDINGS, write_cloud

__all__ = [
    "PartOfCloud",
    "PointCloud",
    "compensate_cloud",
    "thin_cloud",
    "require_surface",
    "read_cloud",
    "write_cloud",
    "READABLE_ENDINGS",
    "WRITABLE_ENDINGS",
    "CoreBox",
    "SimulatedCloud",
    "TorusFace",
    "TorusObject",
    "TrueEdge",
]
