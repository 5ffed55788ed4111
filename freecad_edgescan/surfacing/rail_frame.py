# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a profile is along its rails: the affine frame that carries it.

Between two rails the frame's first axis is the chord from the first rail to the second, its second
axis runs along both, and all axes are as long as the chord: the profile turns with the rails and
scales between them. Along one rail the frame turns as little as possible about it and keeps its
size.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from ..geometry import BSplineCurve
from ..geometry.frames import cross, orthonormalise, rotation_minimising_frames

__all__ = ["OneRailFrame", "two_rail_frame"]

Array = NDArray[np.float64]

_SAMPLES = 1000


def two_rail_frame(first: Array, second: Array, along: Array) -> Array:
    """Matrices (m, 3, 3) whose columns are the axes, mm.

    Parameters
    ----------
    first, second : (m, 3) points of the rails
    along : (m, 3) direction of the rails there, the derivative of the points between them
    """
    chord = second - first
    length = np.linalg.norm(chord, axis=-1, keepdims=True)
    across = chord / length
    onwards = orthonormalise(across, along)
    return np.stack([chord, length * onwards, length * cross(across, onwards)], axis=-1)


class OneRailFrame:
    """Rotation-minimising frames (m, 3, 3) along a rail over [0, 1], columns are the axes."""

    def __init__(self, rail: BSplineCurve) -> None:
        u = np.linspace(0.0, 1.0, _SAMPLES + 1)
        frames = rotation_minimising_frames(rail.evaluate(u), rail.tangent(u))
        self._rail, self._second = rail, CubicSpline(u, frames[:, 1])

    def __call__(self, u: Array) -> Array:
        """Frames at parameters (m,)."""
        tangent = self._rail.tangent(u)
        second = orthonormalise(tangent, self._second(u))
        return np.stack([second, tangent, cross(second, tangent)], axis=-1)
