# SPDX-License-Identifier: LGPL-2.1-or-later
"""A virtual measuring machine that touches the torus object, not a cloud of it (Schreve 3.2)."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, pi

import numpy as np

from ..cloud.torus_object import APPROACH, AZIMUTHS, TorusFace, TorusObject
from ..geometry.ray_torus import ray_torus
from .errors import ScanError

__all__ = ["AnalyticCmm"]

_REACH = 1.2  # rad of a section, that the faces reach from the edge at most
_AT_START = 1e-9  # mm: what lies nearer to the start of a movement has been left
_RIM = 1e-9  # rad, by which faces overlap where they meet


class AnalyticCmm:
    """A machine whose contacts are exact (a `Cmm`).

    Parameters
    ----------
    torus : what is touched; with a probe radius the answers are ball centres
    noise : level η, mm: each coordinate of a contact gets a uniform error in [−η, η]
    seed : for ``numpy.random.default_rng``

    Raises
    ------
    ScanError: not a TorusObject, or a noise that is no length.
    """

    def __init__(
        self,
        torus: TorusObject,
        noise: float = 0.0,
        seed: int | Sequence[int] | None = None,
    ) -> None:
        if not isinstance(torus, TorusObject):
            raise ScanError(
                f"An AnalyticCmm touches a TorusObject and was given {type(torus).__name__}."
            )
        if not (isinstance(noise, int | float | np.number) and isfinite(noise) and noise >= 0.0):
            raise ScanError(f"The noise of the machine is {noise!r}; give 0 or a length in mm.")
        self.torus, self.noise = torus, float(noise)
        self.probe_radius = torus.probe_radius
        self.approach = np.array(APPROACH)
        self.faces = _largest_faces(torus)
        self._random = np.random.default_rng(seed)

    def move(self, start: np.ndarray, end: np.ndarray) -> np.ndarray | None:
        """Travel without measuring; where it collides, or None (see `Cmm.move`)."""
        way = end - start
        length = float(np.sqrt(way @ way))
        return self._first(start, way / length, length) if length > 0.0 else None

    def touch(
        self,
        start: np.ndarray,
        direction: np.ndarray,
        prehit_distance: float,
        search_distance: float,
    ) -> np.ndarray | None:
        """Search along a line; the contact, or None (see `Cmm.touch`)."""
        return self._first(start, direction, prehit_distance + search_distance)

    def _first(self, start: np.ndarray, way: np.ndarray, farthest: float) -> np.ndarray | None:
        met = farthest
        found = False
        for face in self.faces:
            stations, v, azimuth = ray_torus(
                start, way, face.major_radius, face.section_radius, face.centre_height
            )
            on_face = (v - face.v0) % (2.0 * pi) <= face.v1 - face.v0 + _RIM
            on_face |= (face.v0 - v) % (2.0 * pi) <= _RIM
            # The object is a little more than half a turn long.
            turned = (azimuth - AZIMUTHS[0]) % (2.0 * pi)
            on_face &= turned <= AZIMUTHS[1] - AZIMUTHS[0]
            good = stations[on_face & (stations > _AT_START) & (stations <= met)]
            if len(good):
                met, found = float(good.min()), True
        if not found:
            return None
        contact = start + met * way
        if self.noise:
            contact = contact + self._random.uniform(-self.noise, self.noise, 3)
        return np.asarray(contact)


def _largest_faces(torus: TorusObject) -> tuple[TorusFace, ...]:
    """The faces, as far from the edge as the object allows."""
    reach = _REACH * (torus.section_radius - torus.probe_radius)
    while True:
        try:
            return torus.faces(reach)
        except ValueError:
            reach *= 0.9
