# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surfaces printed in the dissertation: extended ones, and those of one edge.

Schreve appendix H, tables 1 to 3: a rational surface, and its extensions by AutoCAD and by Shetty
and White's method. Table 1's knots in v lack one 2 for its five poles. Appendix I, tables 1 to 4:
base surfaces and fitted surfaces of both sides of test 2S1.11; four entries have lost a comma and
are mended here.
"""

from __future__ import annotations

from enum import Enum

import numpy as np

from ..geometry import BSplineSurface
from .doe_design import published_table

__all__ = ["PublishedSurface", "published_surface"]

_ROUND = [0, 0, 0, 0, 0.197, 0.403, 0.598, 0.804, 1, 1, 1, 1]
_BASE = ([0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1], [0, 0, 0, 0, 0.5, 1, 1, 1, 1])
_LONGER = ([0, 0, 0, 0, 1, 1, 1, 1], [0, 0, 0, 0, 0.2, 0.2, 0.2, 0.6, 1, 1, 1, 1])


class PublishedSurface(Enum):
    """Which of the printed surfaces; the value is its table and name in it."""

    ORIGINAL = ("appendix_h.csv", "original")
    EXTENDED_BY_AUTOCAD = ("appendix_h.csv", "autocad")
    EXTENDED_BY_SHETTY_AND_WHITE = ("appendix_h.csv", "shetty_white")
    OUTER_BASE = ("appendix_i.csv", "base_outer")
    INNER_BASE = ("appendix_i.csv", "base_inner")
    OUTER = ("appendix_i.csv", "outer")
    INNER = ("appendix_i.csv", "inner")


_KNOTS = {
    PublishedSurface.ORIGINAL: ([0, 0, 0, 0, 1, 1, 1, 1], [0, 0, 0, 0, 1, 2, 2, 2, 2]),
    PublishedSurface.EXTENDED_BY_AUTOCAD: _LONGER,
    PublishedSurface.EXTENDED_BY_SHETTY_AND_WHITE: _LONGER,
    PublishedSurface.OUTER_BASE: _BASE,
    PublishedSurface.INNER_BASE: _BASE,
    PublishedSurface.OUTER: (_ROUND, [0, 0, 0, 0, 0.106, 0.312, 0.522, 0.745, 1, 1, 1, 1]),
    PublishedSurface.INNER: (_ROUND, [0, 0, 0, 0, 0.138, 0.339, 0.550, 0.769, 1, 1, 1, 1]),
}


def published_surface(which: PublishedSurface) -> BSplineSurface:
    """One of the printed bicubic surfaces, mm; those of appendix I have no weights but 1."""
    table, name = which.value
    rows = [row for row in published_table(table) if row["surface"] == name]
    shape = tuple(max(int(row[index]) for row in rows) + 1 for index in ("i", "j"))
    values = np.zeros((*shape, 4))
    for row in rows:
        entry = [float(row[column]) for column in ("x_mm", "y_mm", "z_mm", "weight")]
        values[int(row["i"]), int(row["j"])] = entry
    u, v = (np.array(knots, dtype=float) for knots in _KNOTS[which])
    weights = None if np.all(values[..., 3] == 1.0) else values[..., 3]
    return BSplineSurface(values[..., :3], (u, v), (3, 3), weights)
