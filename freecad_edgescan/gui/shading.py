# SPDX-License-Identifier: LGPL-2.1-or-later
"""Greys that let the shape of a cloud be seen, as if light fell on the surface it lies on."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud

from .picking import Array

__all__ = ["brightness", "shade"]

MOST_POINTS = 500_000  # above, it would take longer than reading the file
_NEIGHBOURS = 9
_CHUNK = 50_000
_DARKEST = 0.35
_LIGHT = np.array([0.4, -0.5, 0.77])


def shade(clouds: list[Any]) -> None:
    """Give cloud objects a property Color with their shading, and show it, unless too large."""
    for cloud in clouds:
        _shade_one(cloud)


def _shade_one(cloud: Any) -> None:
    numbers = document.point_cloud(cloud)
    if len(numbers) > MOST_POINTS or len(numbers) <= _NEIGHBOURS or hasattr(cloud, "Color"):
        return
    cloud.addProperty("App::PropertyColorList", "Color", "Cloud", "Shading of the points", 1 + 4)
    cloud.Color = [(float(grey),) * 3 for grey in brightness(numbers)]
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
