# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cloud, and its point, that a person means who clicks in a 3D view."""

from __future__ import annotations

from typing import Any

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud

from .picking import Array, front_hit, nearest_to_ray
from .view_ray import view_ray

__all__ = ["clicked_cloud", "visible_clouds"]

_WIDER = 3.0  # a click that meets nothing is tried again with this many times the pick radius


def visible_clouds(doc: Any) -> list[Any]:
    """Point clouds of a document that are shown."""
    return [
        item
        for item in doc.Objects
        if item.isDerivedFrom("Points::Feature")
        and item.ViewObject.Visibility
        and item.Points.CountPoints
    ]


def clicked_cloud(
    view: Any, position: tuple[int, int], clouds: list[Any]
) -> tuple[Any, PointCloud, Array] | None:
    """The cloud under a pixel as object and as numbers, and the point (3,); None: there is none."""
    ray = view_ray(view, position)
    numbers = [document.point_cloud(item) for item in clouds]
    for seen in (ray, ray.widened(_WIDER)):
        hits = [nearest_to_ray(cloud.tree, seen, 1.5 * cloud.pitch) for cloud in numbers]
        front = front_hit(hits)
        hit = None if front is None else hits[front]
        if front is not None and hit is not None:
            return clouds[front], numbers[front], numbers[front].points[hit.index]
    return None
