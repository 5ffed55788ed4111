# SPDX-License-Identifier: LGPL-2.1-or-later
"""The test object of the published experiments: two tori that meet in a circular edge.

Schreve appendix G. In a half-plane through the z axis the object is two arcs of radius R that
meet under the angle θ at the edge (x, -R). The air is inside the tubes, so that two concave faces
meet in a convex edge of material; a rounding of radius R_f has its centre in the material.

A ball of radius R_p that touches the object has its centre on two tori of section radius R - R_p
and a rounding torus of section radius R_f + R_p, all with unchanged centres. The rounding spans
2φ (eq. 5.2.1.1), so that it is df = 2φ(R_p + R_f) long.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .simulated_cloud import SimulatedCloud, add_noise
from .true_edge import TrueEdge

__all__ = ["TorusFace", "TorusObject"]

Array = NDArray[np.float64]

AZIMUTHS = (-0.1, np.pi + 0.1)  # rad, where the object begins and ends
FACE_NAMES = ("outer", "inner", "rounding")
CHORD_ERROR = 1e-6  # mm, of the true edge's polyline
APPROACH = (0.0, 0.0, -1.0)


@dataclass(frozen=True)
class TorusFace:
    """Part of a torus round the z axis: (ρ, z) = (a + r cos v, b + r sin v).

    Attributes
    ----------
    name : outer, inner or rounding
    centre_height : b, mm
    major_radius : a, mm; may be negative (then the section's centre lies beyond the axis)
    section_radius : r, mm
    v0, v1 : rad, range of the section angle v, v0 < v1
    air_inside : whether the air is on the section centre's side
    """

    name: str
    centre_height: float
    major_radius: float
    section_radius: float
    v0: float
    v1: float
    air_inside: bool

    def points(self, v: ArrayLike, azimuth: ArrayLike) -> Array:
        """Points (..., 3) at section angle and azimuth, mm."""
        v, azimuth = np.asarray(v, dtype=float), np.asarray(azimuth, dtype=float)
        rho = self.major_radius + self.section_radius * np.cos(v)
        z = self.centre_height + self.section_radius * np.sin(v)
        return np.stack(
            np.broadcast_arrays(rho * np.cos(azimuth), rho * np.sin(azimuth), z), axis=-1
        )


@dataclass(frozen=True)
class TorusObject:
    """Two intersecting tori with an optional rounding, touched by a ball (Schreve appendix G).

    Parameters
    ----------
    section_radius : R, mm, of both tori
    edge_radius : x, mm, of the edge circle, which lies at the height -R
    angle : θ, rad, of the wedge of material at the edge, in (0, π)
    fillet_radius : R_f, mm, of the rounding; 0 for a sharp edge
    probe_radius : R_p, mm; above 0 the faces and clouds are those of the ball's centre

    Raises
    ------
    ValueError: values that make no such object.
    """

    section_radius: float
    edge_radius: float
    angle: float
    fillet_radius: float = 0.0
    probe_radius: float = 0.0

    def __post_init__(self) -> None:
        for name, value in (("section", self.section_radius), ("edge", self.edge_radius)):
            if not 0.0 < value < np.inf:
                raise ValueError(f"The {name} radius is {value} mm; give a positive number.")
        for name, value in (("fillet", self.fillet_radius), ("probe", self.probe_radius)):
            if not 0.0 <= value < np.inf:
                raise ValueError(f"The {name} radius is {value} mm; give 0 or a positive number.")
        if not 0.0 < self.angle < np.pi:
            raise ValueError(
                f"The angle is {self.angle} rad; give one between 0 and π (not degrees)."
            )
        if self.probe_radius >= self.section_radius:
            raise ValueError(
                f"A ball of radius {self.probe_radius} mm does not fit into tubes of radius "
                f"{self.section_radius} mm; give a smaller probe radius."
            )

    @property
    def rounding_length(self) -> float:
        """What a scan line across the edge spends on the rounding: df = 2φ(R_p + R_f), mm."""
        return self._rounding_span * (self.fillet_radius + self.probe_radius)

    @property
    def edges(self) -> tuple[TrueEdge, ...]:
        """The sharp edge, before rounding and probing: half a circle of radius x."""
        return (self._edge,)

    def faces(self, amplitude: float) -> tuple[TorusFace, ...]:
        """The tori the ball's centre moves on: outer, inner and (unless sharp) rounding.

        Parameters
        ----------
        amplitude : float
            How far outer and inner reach beyond the rounding along the surface, mm.

        Raises
        ------
        ValueError: an amplitude for which the object would close or cross the z axis.
        """
        reach = _positive("amplitude", amplitude)
        big, theta, tilt = self.section_radius, self.angle, self._tilt
        radius = big - self.probe_radius
        low, high = 1.5 * np.pi + tilt, 2.5 * np.pi - theta - tilt
        turn = reach / radius
        second = (big * np.cos(np.pi - theta) - big, self.edge_radius - big * np.sin(theta))
        inner = TorusFace("inner", *second, radius, high - turn, high, True)
        outer = TorusFace("outer", 0.0, self.edge_radius, radius, low, low + turn, True)
        if turn > 1.5 * np.pi or _smallest_rho(inner) <= 0.0 or _smallest_rho(outer) <= 0.0:
            raise ValueError(
                f"A face cannot reach {reach:g} mm from the edge with a section radius of "
                f"{radius:g} mm and an edge radius of {self.edge_radius:g} mm; take a smaller "
                "amplitude."
            )
        if self.fillet_radius + self.probe_radius == 0.0:
            return outer, inner
        hypotenuse = big + self.fillet_radius
        rounding = TorusFace(
            "rounding",
            -hypotenuse * float(np.cos(tilt)),
            self.edge_radius + hypotenuse * float(np.sin(tilt)),
            self.fillet_radius + self.probe_radius,
            low - np.pi,
            high - np.pi,
            False,
        )
        return outer, inner, rounding

    def cloud(
        self,
        pitch: float,
        amplitude: float,
        noise: float = 0.0,
        seed: int | Sequence[int] = 0,
    ) -> SimulatedCloud:
        """Points at even spacing over the three tori, from azimuth -0.1 to π + 0.1.

        Parameters
        ----------
        pitch : float
            ρ_c, mm, spacing along the section and round the z axis.
        amplitude : float
            A, mm, of the scan lines meant; each side reaches A/2 + 4ρ_c beyond the rounding.
        noise : float
            Level η, mm: each coordinate gets an independent uniform error in [-η, η].
        seed : int or sequence of int
            Anything ``numpy.random.default_rng`` takes.

        Raises
        ------
        ValueError: a pitch or amplitude that is not positive, or too large for the object.
        """
        _positive("pitch", pitch)
        reach = _positive("amplitude", amplitude) / 2 + 4 * pitch
        faces = self.faces(reach)
        half = self.rounding_length / 2 + reach
        rows = (np.arange(np.floor(2 * half / pitch)) + 0.5) * pitch - half
        points, labels = [], []
        for along in rows:
            face, v = self._section(along, faces)
            torus = faces[face]
            step = pitch / (torus.major_radius + torus.section_radius * np.cos(v))
            azimuth = np.arange(AZIMUTHS[0], AZIMUTHS[1], step)
            points.append(torus.points(v, azimuth))
            labels.append(np.full(len(azimuth), face))
        return SimulatedCloud(
            add_noise(np.vstack(points), noise, seed),
            np.concatenate(labels),
            FACE_NAMES[: len(faces)],
            self.edges,
            self.probe_radius,
            APPROACH,
        )

    def start(self, amplitude: float, azimuth: float = 0.1) -> tuple[Array, Array, Array]:
        """Where a scan starts: on the outer face, A/2 along the surface from the edge.

        Returns
        -------
        point (3,) mm, and the unit directions across the edge (tangent to the face, towards the
        edge) and along it (towards growing azimuth).
        """
        faces = self.faces(_positive("amplitude", amplitude))
        face, v = self._section(amplitude / 2, faces)
        point = faces[face].points(v, azimuth)
        outwards = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
        along = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
        across = np.sin(v) * outwards - np.array([0.0, 0.0, np.cos(v)])
        return point, across if faces[face].air_inside else -across, along

    def gate(self, amplitude: float, azimuth: float = np.pi - 0.1) -> tuple[Array, Array]:
        """Where a scan ends: point (3,) mm A/2 from the edge, unit direction to the z axis."""
        point, _, along = self.start(amplitude, azimuth)
        return point, np.array([-along[1], along[0], 0.0])

    @property
    def _tilt(self) -> float:
        """α (eq. G2.2), rad, seen from a tube's centre: between edge and rounding centre."""
        return float(np.pi / 2 - self._rounding_span / 2 - self.angle / 2)

    @property
    def _rounding_span(self) -> float:
        """2φ (eq. 5.2.1.1), rad."""
        share = self.section_radius / (self.section_radius + self.fillet_radius)
        return 2 * float(np.arcsin(share * np.cos(self.angle / 2)))

    def _section(self, along: float, faces: tuple[TorusFace, ...]) -> tuple[int, float]:
        """Face and section angle at a length along the section, from the middle, outer > 0."""
        outer, inner = faces[:2]
        beyond = abs(along) - self.rounding_length / 2
        if beyond < 0.0:
            rounding = faces[2]
            middle = (rounding.v0 + rounding.v1) / 2
            return 2, middle - along / rounding.section_radius
        if along > 0.0:
            return 0, outer.v0 + beyond / outer.section_radius
        return 1, inner.v1 - beyond / inner.section_radius

    @cached_property
    def _edge(self) -> TrueEdge:
        step = np.sqrt(8 * CHORD_ERROR / self.edge_radius)
        count = int(np.ceil((AZIMUTHS[1] - AZIMUTHS[0]) / step)) + 1
        azimuth = np.linspace(*AZIMUTHS, count)
        x, y, zero = np.cos(azimuth), np.sin(azimuth), np.zeros(count)
        return TrueEdge(
            "edge",
            np.column_stack(
                [self.edge_radius * x, self.edge_radius * y, zero - self.section_radius]
            ),
            np.column_stack([-y, x, zero]),
            np.asarray(self.angle),
            convex=True,
        )


def _smallest_rho(face: TorusFace) -> float:
    """Smallest distance of a face from the z axis, mm."""
    through = np.pi * np.arange(np.ceil(face.v0 / np.pi), np.floor(face.v1 / np.pi) + 1)
    v = np.concatenate([[face.v0, face.v1], through])
    return float((face.major_radius + face.section_radius * np.cos(v)).min())


def _positive(name: str, value: float) -> float:
    if not 0.0 < value < np.inf:
        raise ValueError(f"The {name} is {value} mm; give a positive number.")
    return float(value)
