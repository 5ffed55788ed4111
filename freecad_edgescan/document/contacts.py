# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places where a probe of a simulated scan touches a shape."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .nurbs_face import NurbsFace

__all__ = ["Contacts"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Contacts:
    """Candidates for points of a simulated cloud.

    Attributes
    ----------
    centres : (n, 3) centres of the probe, mm; on the surface itself for a probe without a radius
    normals : (n, 3) unit vectors from the touched place to the centre
    labels : (n,) number of the face
    """

    centres: Array
    normals: Array
    labels: NDArray[np.intp]

    def __len__(self) -> int:
        return len(self.centres)

    def taken(self, which: NDArray) -> Contacts:
        """Only the contacts with these numbers or under this mask."""
        return Contacts(self.centres[which], self.normals[which], self.labels[which])

    @classmethod
    def join(cls, parts: Sequence[Contacts]) -> Contacts:
        """Several sets as one."""
        return cls(
            np.vstack([np.zeros((0, 3)), *(part.centres for part in parts)]),
            np.vstack([np.zeros((0, 3)), *(part.normals for part in parts)]),
            np.concatenate([np.zeros(0, dtype=np.intp), *(part.labels for part in parts)]),
        )

    @classmethod
    def on_face(
        cls,
        face: NurbsFace,
        label: int,
        density: float,
        radius: float,
        rng: np.random.Generator,
    ) -> Contacts:
        """Random contacts on one face, so many per mm² of the surface the centres lie on."""
        if not len(face.triangles):
            return cls.join([])
        growth = 1.0
        if radius > 0.0:
            tried = face.locate(_on_triangles(face.triangles, 200, rng))[0]
            growth = 1.2 * float(face.offset_growth(tried, radius).max())
        count = rng.poisson(density * growth * _areas(face.triangles).sum())
        uv, place, normal = face.locate(_on_triangles(face.triangles, count, rng))
        if radius > 0.0:
            kept = rng.random(count) * growth <= face.offset_growth(uv, radius)
            place, normal = place[kept], normal[kept]
        labels = np.full(len(place), label, dtype=np.intp)
        return cls(place + radius * normal, normal, labels)


def _areas(triangles: Array) -> Array:
    first, second = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    return np.linalg.norm(np.cross(first, second), axis=1) / 2.0


def _on_triangles(triangles: Array, count: int, rng: np.random.Generator) -> Array:
    """Uniformly random points on triangles."""
    area = np.cumsum(_areas(triangles))
    chosen = np.searchsorted(area, rng.random(count) * area[-1], side="right")
    chosen = np.minimum(chosen, len(triangles) - 1)
    share = rng.random((count, 2))
    share = np.where(share.sum(axis=1, keepdims=True) > 1.0, 1.0 - share, share)
    corner = triangles[chosen]
    return (
        corner[:, 0]
        + share[:, :1] * (corner[:, 1] - corner[:, 0])
        + share[:, 1:] * (corner[:, 2] - corner[:, 0])
    )
