# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a cloud supports a surface, and in words where it does not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import label

from ..geometry import BSplineSurface
from ..geometry.place_text import place_text

__all__ = ["dense_enough", "said_of_support", "supported_share"]

Array = NDArray[np.float64]

_SPARSE = 0.1  # of the median density of the patches that hold any points
_MEASURED = 5  # places on a patch in either direction, for its area


def dense_enough(count: NDArray, knots: tuple[Array, Array]) -> NDArray[np.bool_]:
    """Which patches (ku, kv) between knots hold points about as densely as the others."""
    area = np.multiply.outer(*(np.diff(np.unique(own)) for own in knots))
    density = count / area
    filled = density[density > 0.0]
    return np.asarray(density > _SPARSE * np.median(filled)) if len(filled) else count > 0


def supported_share(surface: BSplineSurface, supported: NDArray[np.bool_]) -> float:
    """Share of a surface's area that lies in its supported patches (ku, kv), 0 to 1."""
    area = _areas(surface)
    return float(area[supported].sum() / area.sum())


def said_of_support(surface: BSplineSurface, supported: NDArray[np.bool_], instead: str) -> str:
    """How much of a surface the cloud does not support, and where most of that lies.

    Parameters
    ----------
    surface : of the fit
    supported : (ku, kv) bool, which of its patches hold points enough
    instead : what decides there
    """
    if supported.all():
        return ""
    area = _areas(surface)
    pieces, count = label(~supported)
    sizes = [float(area[pieces == number].sum()) for number in range(1, count + 1)]
    rows, columns = np.nonzero(pieces == 1 + int(np.argmax(sizes)))
    u, v = surface.patches.breaks
    limits = u[rows.min()], u[rows.max() + 1], v[columns.min()], v[columns.max() + 1]
    # a patch of the piece itself: the middle of its limits may be supported
    middle = np.argmin(np.hypot(rows - rows.mean(), columns - columns.mean()))
    row, column = rows[middle], columns[middle]
    place = surface.evaluate((u[row] + u[row + 1]) / 2, (v[column] + v[column + 1]) / 2)
    missing = int((~supported).sum())
    share = 100.0 * (1.0 - supported_share(surface, supported))
    where = place_text(place)
    return (
        f"The cloud does not support {missing} of the surface's {supported.size} patches, "
        f"{max(share, 1.0):.0f} % of its area, the largest piece from u = {limits[0]:.3g} to "
        f"{limits[1]:.3g} and v = {limits[2]:.3g} to {limits[3]:.3g}, near ({where}); {instead}."
    )


def _areas(surface: BSplineSurface) -> Array:
    """Areas (ku, kv) of the patches, mm², from small quadrilaterals."""
    u, v = (
        np.interp(np.arange((len(own) - 1) * _MEASURED + 1) / _MEASURED, np.arange(len(own)), own)
        for own in surface.patches.breaks
    )
    grid = surface.evaluate(u[:, None], v)
    one, other = grid[1:, 1:] - grid[:-1, :-1], grid[1:, :-1] - grid[:-1, 1:]
    small = 0.5 * np.linalg.norm(np.cross(one, other), axis=2)
    patches = surface.patches.shape
    return np.asarray(small.reshape(patches[0], _MEASURED, patches[1], _MEASURED).sum(axis=(1, 3)))
