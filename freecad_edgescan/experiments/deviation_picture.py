# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of how far points are from surfaces: in colour where they lie, and as histogram."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .figures import new_figure, save_figure
from .relief import view_axes

__all__ = ["draw_deviations"]

Array = NDArray[np.float64]

_WIDTH = 11.0  # inches
_BINS = 81
_FULL = 99.5  # percent of the absolute deviations that the colours tell apart


def draw_deviations(
    panels: Mapping[str, tuple[Array, Array]],
    path: str | Path,
    view: ArrayLike = (0.0, 0.0, 1.0),
    limit: float | None = None,
) -> None:
    """Draw points in the colour of their deviation, one panel beside its histogram for each title.

    Parameters
    ----------
    panels : for each title points (n, 3) and their signed deviations (n,), mm
    path : picture file; its ending (.png, .svg, .pdf) chooses the format
    view : (3,) direction from the part towards the viewer
    limit : mm, deviation of the strongest colours; None: 99.5 % of all deviations are below

    Raises
    ------
    ValueError: no point, matplotlib is missing, or does not know the ending.
    """
    every = np.concatenate([np.abs(own) for _, own in panels.values()] or [np.zeros(0)])
    if not len(every):
        raise ValueError(f"There is no point whose deviation could be drawn in {path}.")
    reach = float(np.percentile(every, _FULL)) if limit is None else limit
    reach = reach or 1e-3
    right, up, _ = view_axes(view)
    seen = {title: points @ np.array([right, up]).T for title, (points, _) in panels.items()}
    spread = np.ptp(np.concatenate(list(seen.values())), axis=0)
    tall = 0.72 * _WIDTH * max(0.2, float(spread[1] / spread[0]))
    figure = new_figure(path, _WIDTH, tall * len(panels) + 0.4)
    grid = figure.add_gridspec(len(panels), 2, width_ratios=[3.2, 1.0])
    for row, (title, (_, deviation)) in enumerate(panels.items()):
        axes = figure.add_subplot(grid[row, 0])
        drawn = axes.scatter(
            *seen[title].T, c=deviation, s=1.5, lw=0, cmap="RdBu_r", vmin=-reach, vmax=reach,
            rasterized=True,
        )  # fmt: skip
        axes.set_aspect("equal")
        axes.set_facecolor("0.85")
        axes.set_title(
            f"{title}: {np.abs(deviation).mean():.3f} mm on average, "
            f"{np.abs(deviation).max():.3f} mm at most",
            fontsize="medium", loc="left",
        )  # fmt: skip
        figure.colorbar(drawn, ax=axes, label="deviation, mm", fraction=0.03, extend="both")
        bars = figure.add_subplot(grid[row, 1])
        bars.hist(np.clip(deviation, -reach, reach), _BINS, range=(-reach, reach), color="0.4")
        bars.set_yticks([])
        bars.set_xlabel("deviation, mm")
    save_figure(figure, path)
