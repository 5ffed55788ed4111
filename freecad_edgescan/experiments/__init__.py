# SPDX-License-Identifier: LGPL-2.1-or-later
"""Experiments: what the method achieves, measured; arrays and tables out."""

from .cloud_picture import draw_cloud
from .doe import run_doe
from .doe_result import DoeResult, DoeRun
from .edge_picture import draw_edges
from .error_picture import draw_errors
from .section_picture import draw_section
from .speed import Speed, measure_speed

__all__ = [
    "DoeResult",
    "DoeRun",
    "Speed",
    "draw_cloud",
    "draw_edges",
    "draw_errors",
    "draw_section",
    "measure_speed",
    "run_doe",
]
