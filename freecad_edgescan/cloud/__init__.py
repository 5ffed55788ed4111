# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point clouds: reading, writing, statistics, and simulated clouds with known truth."""

from .point_cloud import PointCloud, require_surface

__all__ = ["PointCloud", "require_surface"]
