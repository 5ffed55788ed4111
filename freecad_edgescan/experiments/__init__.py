# SPDX-License-Identifier: LGPL-2.1-or-later
"""Experiments: what the method achieves, measured; arrays and tables out."""

from .edge_picture import draw_edges
from .speed import Speed, measure_speed

__all__ = ["Speed", "draw_edges", "measure_speed"]
