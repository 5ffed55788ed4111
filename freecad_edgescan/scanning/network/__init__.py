# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges of a cloud at once, and how they are connected."""

from .edge_network import EdgeNetwork
from .find_edges import find_edges
from .regions import Region

__all__ = ["EdgeNetwork", "Region", "find_edges"]
