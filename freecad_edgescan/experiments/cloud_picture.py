# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a cloud alone, from three sides, in the part's own coordinates."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from ..cloud import PointCloud
from .edge_picture import draw_on
from .figures import new_figure, save_figure
from .relief import relief

__all__ = ["draw_cloud"]

_LONGEST = 11.0  # inches, of the two widths or heights together
# Inches, for what is written beside both views, and above and beneath both of them.
_BESIDE, _BENEATH, _APART = 1.6, 2.2, 0.12
_THINNEST = 0.15  # share of the longest extent that the picture of a thin one gets

# Where, and from which direction; the axes to the right and upwards are the part's own there.
_VIEWS = (
    ((0, 0), (0, 0, 1), "x", "y", "from above, against z"),
    ((1, 0), (0, -1, 0), "x", "z", "from the front, along y"),
    ((1, 1), (1, 0, 0), "y", "z", "from the right, against x"),
)


def draw_cloud(cloud: PointCloud, path: str | Path) -> None:
    """Draw a cloud along the three axes, so that the place of an edge can be read off.

    Above x and y, below x and z, beside it y and z: each place has its third coordinate in the
    next view, straight below or beside.

    Parameters
    ----------
    cloud : PointCloud
    path : str or Path
        Picture file; its ending (.png, .svg, .pdf) chooses the format.

    Raises
    ------
    ValueError: matplotlib is missing, or does not know the ending.
    """
    x, y, z = np.maximum(cloud.size, _THINNEST * cloud.size.max())
    scale = _LONGEST / max(x + y, y + z)
    figure = new_figure(path, scale * (x + y) + _BESIDE, scale * (y + z) + _BENEATH)
    figure.get_layout_engine().set(h_pad=_APART)
    grid = figure.add_gridspec(2, 2, width_ratios=(x, y), height_ratios=(y, z))
    for place, direction, right, up, title in _VIEWS:
        axes = figure.add_subplot(grid[place])
        draw_on(axes, relief(cloud.points, cloud.pitch, direction), ())
        _label(axes, right, up, title)
    save_figure(figure, path)


def _label(axes: Any, right: str, up: str, title: str) -> None:
    axes.set(title=title, xlabel=f"{right}, mm", ylabel=f"{up}, mm")
    axes.ticklabel_format(useOffset=False, style="plain")
    axes.minorticks_on()
    axes.grid(which="major", color="C0", lw=0.6, alpha=0.6)
    axes.grid(which="minor", color="C0", lw=0.3, alpha=0.3)
