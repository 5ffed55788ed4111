# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smallest error an unbiased edge point of a torus object can have (Gauss–Markov).

What an edge point is made of is fixed: the points that the simulation put on the two faces, not on
the rounding, half an edge pitch to both sides along the edge and half an amplitude across it. On
each face they tell a circular section of unknown centre and radius; how the faces run along the
edge is known. Their noise is independent, and only its part along the normal counts. Least squares
is then the best there is, and its variance at the edge the bound.

An estimate may fall below where it shares points, or curvature, with those of its neighbours.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..cloud import SimulatedCloud
from .doe_design import Trial

__all__ = ["edge_bound"]

Array = NDArray[np.float64]

_BEGIN, _END = 0.1, np.pi - 0.1  # rad, where the scans of the experiments begin and end
_FACES = ("outer", "inner")


def edge_bound(trial: Trial, cloud: SimulatedCloud) -> float:
    """Root mean square distance of edge points from the edge that no unbiased estimate beats, mm.

    Parameters
    ----------
    trial : the object and how it is scanned; edge points lie one edge pitch apart
    cloud : of the object, with its labels

    Returns
    -------
    √ of the mean over the edge points of (v₁ + v₂) / sin²θ, with the variance v of each face's
    position at the edge, σ² [(JᵀJ)⁻¹]₁₁, regressors 1, sin φ, 1 − cos φ of the section angle φ
    from the edge's foot, and σ² = η²/3. Infinite where a face has fewer than three points.
    """
    step = trial.edge_pitch / trial.edge_radius
    azimuth = np.arctan2(cloud.points[:, 1], cloud.points[:, 0])
    station = np.round((azimuth - _BEGIN) / step).astype(np.int64)
    count = int((_END - _BEGIN) / step) + 1
    rho, z = np.hypot(cloud.points[:, 0], cloud.points[:, 1]), cloud.points[:, 2]
    edge = np.array([trial.edge_radius, -trial.section_radius])
    faces = {face.name: face for face in trial.object.faces(trial.amplitude / 2)}
    centres = {
        name: np.array([faces[name].major_radius, faces[name].centre_height]) for name in _FACES
    }
    normals = [(centres[name] - edge) / np.linalg.norm(centres[name] - edge) for name in _FACES]
    meeting = edge + trial.probe_radius * sum(normals) / (1.0 + normals[0] @ normals[1])
    near = np.hypot(rho - meeting[0], z - meeting[1]) <= trial.amplitude / 2
    near &= (station >= 0) & (station < count)
    total = np.zeros(count)
    for name in _FACES:
        mine = near & (cloud.labels == cloud.face_names.index(name))
        centre = centres[name]
        foot = np.arctan2(edge[1] - centre[1], edge[0] - centre[0])
        turn = np.arctan2(z[mine] - centre[1], rho[mine] - centre[0]) - foot
        terms = np.stack([np.ones_like(turn), np.sin(turn), 1.0 - np.cos(turn)], axis=1)
        total += _leverages(terms, station[mine], count)
    variance = trial.noise**2 / 3.0 * total / np.sin(trial.angle) ** 2
    return float(np.sqrt(variance.mean()))


def _leverages(terms: Array, station: NDArray[np.int64], count: int) -> Array:
    """[(JᵀJ)⁻¹]₁₁ of the rows (n, 3) of each station, (count,)."""
    products = np.einsum("ni,nj->nij", terms, terms).reshape(-1, 9)
    normal = np.stack([np.bincount(station, p, count) for p in products.T], axis=1)
    known = np.bincount(station, minlength=count) >= 3
    matrices = np.where(known[:, None, None], normal.reshape(-1, 3, 3), np.eye(3))
    return np.where(known, np.linalg.inv(matrices)[:, 0, 0], np.inf)
