# SPDX-License-Identifier: LGPL-2.1-or-later
"""Experiments: what the method achieves, measured; arrays and tables out."""

from .cloud_picture import draw_cloud
from .edge_picture import draw_edges
from .error_picture import draw_errors
from .section_picture import draw_section
from .speed import Speed, measure_speed

__all__ = ["Speed", "draw_cloud", "draw_edges", "draw_errors", "draw_section", "measure_speed"]
