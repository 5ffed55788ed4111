# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cloud, and its point, that a person means who clicks in a 3D view."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from freecad_edgescan.cloud import PointCloud

from .picking import Array, front_hit, nearest_to_ray
from .thinned_clouds import is_shown
from .view_ray import view_ray

__all__ = ["Picked", "clicked_cloud", "visible_clouds"]

_WIDER = 3.0  # a click that meets nothing is tried again with this many times the pick radius


@dataclass(frozen=True)
class Picked:
    """A point that was clicked on: the cloud as object and as numbers, and the place (3,), mm."""

    item: Any
    numbers: PointCloud
    point: Array


def visible_clouds(doc: Any) -> list[Any]:
    """Point clouds of a document that can be seen and hold points."""
    return [
        item
        for item in doc.Objects
        if item.isDerivedFrom("Points::Feature") and is_shown(item) and item.Points.CountPoints
    ]


def clicked_cloud(
    view: Any, position: tuple[int, int], clouds: Sequence[tuple[Any, PointCloud]]
) -> Picked | None:
    """What is clicked on at a pixel from the lower left corner; None: no cloud.

    Parameters
    ----------
    clouds : objects with their numbers
    """
    ray = view_ray(view, position)
    for seen in (ray, ray.widened(_WIDER)):
        hits = [nearest_to_ray(numbers.tree, seen, 1.5 * numbers.pitch) for _, numbers in clouds]
        front = front_hit(hits)
        hit = None if front is None else hits[front]
        if front is not None and hit is not None:
            item, numbers = clouds[front]
            return Picked(item, numbers, numbers.points[hit.index])
    return None
