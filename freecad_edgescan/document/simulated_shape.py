# SPDX-License-Identifier: LGPL-2.1-or-later
"""A simulated scan of any shape: points of known density and noise on its exact faces.

1. Candidates come from the faces' triangles, uniformly by area, and are moved onto the exact
   surfaces. With a probe radius they become centres of a rolling ball.
2. In random order, a candidate closer than half a pitch to one accepted before is refused, until
   the density is one point per pitch².
3. Each point gets its noise along its normal.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..cloud.simulated_cloud import SimulatedCloud
from .contacts import Contacts
from .given_numbers import length_or_zero, positive_length, whole_number
from .nurbs_face import NurbsFace
from .rolling_ball import ball_contacts, without_collisions
from .sharp_edges import true_edges

__all__ = ["simulate_cloud"]

Array = NDArray[np.float64]

_SURPLUS = 1.8  # candidates for each point wanted: refusing the close ones takes about 40 %
_CHORD = 0.03  # of the pitch
_MIN_ANGLE = 0.26


def simulate_cloud(
    shape: Any, pitch: float, noise: float, probe_radius: float = 0.0, seed: int = 0
) -> SimulatedCloud:
    """Scan a shape without a scanner.

    Parameters
    ----------
    shape : Part.Shape
        Solid, shell, face or a compound of them, mm; outward is where its faces look.
    pitch : float
        One point for each pitch² of surface, mm; none closer than half a pitch (before noise).
    noise : float
        Standard deviation along the normal, mm.
    probe_radius : float
        Above 0 the points are the centres of a ball of this radius rolling over the shape, mm:
        rounded round convex edges and corners, absent where the ball would touch another face.
    seed : int
        The same seed gives the same cloud.

    Returns
    -------
    SimulatedCloud with ``labels`` (n,), the number (from 0) of each point's face in ``shape.Faces``
    (that of the nearer face for a ball on an edge), and ``edges``, ``true_edges(shape, 0.26)``.

    Raises
    ------
    ValueError: no faces; a pitch that is not positive, or so large that fewer than 20 points are
        left; a negative noise, probe radius or seed; a ball that fits nowhere.
    """
    _check(shape, pitch, noise, probe_radius, seed)
    rng = np.random.default_rng(seed)
    density = _SURPLUS / pitch**2
    exact = shape.copy(True, False)
    faces = [NurbsFace(face, _CHORD * pitch) for face in exact.Faces]
    edges = true_edges(exact, _MIN_ANGLE)
    if probe_radius > 0.0:
        contacts = ball_contacts(exact, faces, edges, density, probe_radius, rng)
        contacts = without_collisions(contacts, faces, pitch, probe_radius)
        if len(contacts) == 0:
            raise ValueError(
                f"A ball of radius {probe_radius:g} mm fits nowhere on this shape; "
                "give a smaller probe radius."
            )
    else:
        contacts = Contacts.join(
            [Contacts.on_face(face, label, density, 0.0, rng) for label, face in enumerate(faces)]
        )
    contacts = contacts.taken(rng.permutation(len(contacts)))
    wanted = round(len(contacts) / _SURPLUS)
    if wanted < 20:
        raise ValueError(
            f"A pitch of {pitch:g} mm leaves only {wanted} points on this shape; "
            "give a smaller pitch."
        )
    contacts = contacts.taken(_spread(contacts.centres, pitch / 2.0)[:wanted])
    points = contacts.centres + rng.normal(0.0, noise, len(contacts))[:, None] * contacts.normals
    return SimulatedCloud(
        points,
        labels=contacts.labels,
        face_names=[f"Face{number + 1}" for number in range(len(faces))],
        edges=edges,
        probe_radius=float(probe_radius),
    )


def _check(shape: Any, pitch: float, noise: float, probe_radius: float, seed: int) -> None:
    if shape.isNull() or not shape.Faces:
        raise ValueError("The shape has no faces to scan; give a solid, a shell or a face.")
    positive_length("pitch", pitch)
    length_or_zero("noise", noise)
    length_or_zero("probe radius", probe_radius)
    whole_number("seed", seed, 0)


def _spread(points: Array, distance: float) -> NDArray[np.intp]:
    """Numbers of the points that are accepted, first come first served, at least this far apart.

    The result is that of going through the points one by one; the rounds only do it at once.
    """
    first, second = cKDTree(points).query_pairs(distance, output_type="ndarray").T
    open_ = np.ones(len(points), dtype=bool)
    accepted = np.zeros(len(points), dtype=bool)
    while np.any(open_):
        free = open_.copy()
        free[second] = False
        accepted |= free
        open_ &= ~free
        open_[second[free[first]]] = False
        pending = open_[first] & open_[second]
        first, second = first[pending], second[pending]
    return np.flatnonzero(accepted)
