# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edge error to expect of a probed scan with certain parameters, before it is made."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .error_model import model_error, noise_error
from .surroundings import Surroundings

__all__ = ["ExpectedError", "expected_error"]


@dataclass(frozen=True)
class ExpectedError:
    """What an edge point will be off, mm; infinite where no edge point can be made.

    Attributes
    ----------
    model_bias : because the line sections are no polynomials, and contacts lie too early
    noise_error : standard deviation, because their points scatter
    """

    model_bias: float
    noise_error: float

    @property
    def total(self) -> float:
        """Root mean square of both, mm."""
        return float(np.hypot(self.model_bias, self.noise_error))


def expected_error(
    around: Surroundings,
    amplitude: float,
    line_pitch: float,
    degree: int,
    early: float = 0.0,
) -> ExpectedError:
    """Expect an error from what is known round an edge.

    Parameters
    ----------
    around : what is known about part, probe and cloud
    amplitude, line_pitch : A and ρ_L, mm
    degree : of the line sections
    early : mm, how far outside of the surfaces contacts lie on the average
    """
    section, fillet, probe = around.radii
    length = around.line_section(amplitude)
    points = int(length / line_pitch + 1e-9)  # where a line is split, its point is not used
    if points <= degree:
        return ExpectedError(np.inf, np.inf)
    sigma = around.noise_level / np.sqrt(3.0)
    bias = float(model_error(degree, length, section, around.angle, fillet, probe))
    bias += early / float(np.sin(0.5 * around.angle))  # both sides, along their bisector
    noise = noise_error(
        degree, points, (points - 1) * line_pitch, section, around.angle, fillet, probe, sigma
    )
    return ExpectedError(*(value if np.isfinite(value) else np.inf for value in (bias, noise)))
