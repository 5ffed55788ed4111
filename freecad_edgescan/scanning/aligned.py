# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections that a walk has left out of line, moved to where each sees its sides.

Neighbouring sections decide together because an edge runs through all of them alike. A walk that
took a rounding for a side here and there has left them beside the edge by more than the noise, now
more and now less. Summed, their points scatter by it: no long stretch looks smooth then, and where
neighbours have not the same points, a few blocks seem to move the edge.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .edge_path import EdgePath
from .section import SectionPoints
from .side_fit import SideFits

__all__ = ["in_line"]

_OUT_OF_LINE = 0.1  # variance between the sections in that of the points about the sides


def in_line(
    points: SectionPoints, used: np.ndarray, pooled: SideFits, path: EdgePath
) -> tuple[SectionPoints, EdgePath] | None:
    """Points and path with each section where its neighbours stand; None where they all do.

    Parameters
    ----------
    points : of all sections
    used : (n,) bool, which of them are the sides'
    pooled : the sides as neighbours have decided them
    """
    inside = used & pooled.within(points)
    own, shape = points[inside], pooled.variance.shape
    cell = 2 * own.owner + own.side
    count = np.maximum(np.bincount(cell, minlength=2 * len(path)), 1).reshape(shape)
    total = np.bincount(cell, weights=pooled.residuals(own), minlength=2 * len(path))
    beside = total.reshape(shape) / count
    # What the sections' means scatter beyond chance, each as often as it has points.
    variance = pooled.variance * pooled.reach**2
    between = np.sum(count * np.square(beside) - variance, axis=0)
    if np.all(between <= _OUT_OF_LINE * np.sum(count * variance, axis=0)):
        return None
    frames, normals = path.frames, path.frames.normals
    gram = np.einsum("mai,mbi->mab", normals, normals)
    move = np.einsum("mki,mkl,ml->mi", normals, np.linalg.inv(gram), beside)
    owner, side, gone = points.owner, points.side, move[points.owner]
    moved = replace(
        points,
        away=points.away - np.einsum("ni,ni->n", frames.sides[owner, side], gone),
        height=points.height - np.einsum("ni,ni->n", normals[owner, side], gone),
    )
    return moved, replace(path, frames=replace(frames, origin=frames.origin + move))
