# SPDX-License-Identifier: LGPL-2.1-or-later
"""How new clouds look: the size of their points, and greys that let their shape be seen."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.declared_properties import Declared, Role, declare

from . import preferences
from .picking import Array

__all__ = ["brightness", "dress_clouds", "shade"]

MOST_POINTS = 500_000  # above, shading would take longer than reading the file
_COLOUR = Declared("ColorList", "Color", "Cloud", "Shading of the points", Role.HIDDEN_RESULT)
_NEIGHBOURS = 9
_CHUNK = 50_000
_DARKEST = 0.35
_LIGHT = np.array([0.4, -0.5, 0.77])


def dress_clouds(clouds: list[Any]) -> None:
    """Give cloud objects the user's point size, and their shading where it is wanted."""
    for cloud in clouds:
        cloud.ViewObject.PointSize = float(preferences.point_size())
        shade(cloud)


def shade(cloud: Any) -> None:
    """Give a cloud a property Color with its shading, and show it.

    Not when it has that already, is too large, or the user does not want it.
    """
    count = cloud.Points.CountPoints
    known = len(getattr(cloud, "Color", ()))
    if not preferences.shades_clouds() or not _NEIGHBOURS < count <= MOST_POINTS or known == count:
        return
    declare(cloud, (_COLOUR,))
    cloud.Color = [(float(grey),) * 3 for grey in brightness(document.point_cloud(cloud))]
    cloud.ViewObject.DisplayMode = "Color"


def brightness(cloud: PointCloud) -> Array:
    """Brightness of each point, (n,), from 0.35 to 1; a surface and its back are alike."""
    grey = np.empty(len(cloud))
    for begin in range(0, len(cloud), _CHUNK):
        some = slice(begin, begin + _CHUNK)
        near = cloud.points[cloud.tree.query(cloud.points[some], _NEIGHBOURS)[1]]
        away = near - near.mean(axis=1, keepdims=True)
        normals = np.linalg.eigh(np.einsum("nki,nkj->nij", away, away))[1][:, :, 0]
        grey[some] = np.abs(normals @ (_LIGHT / np.linalg.norm(_LIGHT)))
    return _DARKEST + (1.0 - _DARKEST) * grey
