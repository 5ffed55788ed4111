# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a probed scan works with, every value filled in."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .guidelines import LEAST_PITCHES
from .parameters import Compensation, Pattern, ScanParameters, Steering, Tangent
from .safeguards import Safeguards

__all__ = ["ProbeSettings"]


@dataclass(frozen=True)
class ProbeSettings:
    """Parameters of a probed scan; lengths in mm. See `ScanParameters` for their meaning.

    Attributes
    ----------
    least_pitch : below which the edge pitch is not shortened
    approach : (3,) unit vector, from the air into the part
    least_turn : between the two sections of a line, rad, below which there is no edge on it
    """

    amplitude: float
    line_pitch: float
    edge_pitch: float
    tolerance: float
    degree: int
    pattern: Pattern
    tangent: Tangent
    steering: Steering
    compensation: Compensation
    probe_radius: float
    approach: np.ndarray
    prehit_distance: float
    search_distance: float
    chord_height: float | None
    least_pitch: float
    safeguards: Safeguards
    least_turn: float

    @classmethod
    def from_parameters(cls, parameters: ScanParameters, min_angle: float) -> ProbeSettings:
        """Take over parameters in which every value a probed scan needs is given.

        Parameters
        ----------
        min_angle : rad, least turn of an edge; a single line may fall short of it by half
        """
        p = parameters
        return cls(
            amplitude=_given(p.amplitude),
            line_pitch=_given(p.line_pitch),
            edge_pitch=_given(p.edge_pitch),
            tolerance=_given(p.tolerance),
            degree=int(_given(p.degree)),
            pattern=Pattern(p.pattern or Pattern.SQUARE),
            tangent=Tangent(p.tangent or Tangent.POLYNOMIALS),
            steering=Steering(p.steering or Steering.TANGENT),
            compensation=Compensation(p.compensation or Compensation.INTERSECTION),
            probe_radius=float(p.probe_radius or 0.0),
            approach=np.asarray(p.approach, dtype=float),
            prehit_distance=_given(p.prehit_distance),
            search_distance=_given(p.search_distance),
            chord_height=p.chord_height,
            least_pitch=_least_pitch(p),
            safeguards=p.safeguards or Safeguards(),
            least_turn=0.5 * min_angle,
        )

    @property
    def half_line(self) -> float:
        """Length of a line from the edge to its end: A/2, in a zigzag √(ρe² + A²)/2."""
        if self.pattern is Pattern.SQUARE:
            return 0.5 * self.amplitude
        return 0.5 * float(np.hypot(self.edge_pitch, self.amplitude))


def _least_pitch(parameters: ScanParameters) -> float:
    """Below which the edge pitch is not shortened, mm; a machine has no cloud, but a line pitch."""
    if parameters.cloud_pitch is not None:
        return LEAST_PITCHES * parameters.cloud_pitch
    return min(_given(parameters.line_pitch), _given(parameters.edge_pitch))


def _given(value: float | None) -> float:
    if value is None:
        raise TypeError("a parameter of the probed scan has not been filled in")
    return float(value)
