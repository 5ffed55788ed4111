# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which points of two rails face each other.

Rails round a bend are not equally long, so that equal shares of their lengths drift apart. Points
face each other when the chord between them makes equal angles with both rails, as where a circle
touches both: c·(t₁ + t₂) = 0 with the chord c and the unit tangents t. At the rails' ends, which
the profiles hold together, the pairing returns to them within about one chord's length.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline, PchipInterpolator

from ..geometry import BSplineCurve

__all__ = ["RailPairing"]

Array = NDArray[np.float64]

_STATIONS = 200
_SEARCHED = 2000


class RailPairing:
    """Parameters of two rails (each over [0, 1]) as functions of a common share in [0, 1].

    The share grows with the mean of the lengths along the two rails.
    """

    def __init__(self, first: BSplineCurve, second: BSplineCurve) -> None:
        u = np.linspace(0.0, 1.0, _STATIONS + 1)
        one = first.parameters_at_length(u * first.length()) if first.length() > 0.0 else u
        other = _facing(first, second, one)
        length = (u * first.length() + _lengths(second, other)) / 2
        share = length / length[-1]
        smooth = CubicSpline(share, np.stack([one, other], axis=1))
        dense = np.diff(smooth(np.linspace(0.0, 1.0, 4 * _STATIONS)), axis=0)
        if not np.all(dense > 0.0):
            smooth = PchipInterpolator(share, np.stack([one, other], axis=1))
        self._spline = smooth

    def __call__(self, share: Array, order: int = 0) -> tuple[Array, Array]:
        """Parameters of the first and the second rail, or their derivatives by the share."""
        both = self._spline(share, order)
        if order == 0:
            both = np.clip(both, 0.0, 1.0)
        return both[..., 0], both[..., 1]


def _lengths(curve: BSplineCurve, u: Array) -> Array:
    fine = np.linspace(0.0, 1.0, 4 * _SEARCHED)
    step = np.linalg.norm(np.diff(curve.evaluate(fine), axis=0), axis=1)
    return np.interp(u, fine, np.append(0.0, np.cumsum(step)))


def _facing(first: BSplineCurve, second: BSplineCurve, at: Array) -> Array:
    """Increasing parameters of the second rail that face those of the first, ends to ends."""
    fine = second.parameters_at_length(np.linspace(0.0, second.length(), _SEARCHED))
    points, tangents = second.evaluate(fine), second.tangent(fine)
    chord = points - first.evaluate(at)[:, None]
    slope = np.einsum("mki,mki->mk", chord, first.tangent(at)[:, None] + tangents)
    width = np.linalg.norm(chord, axis=2)
    crossing = (slope[:, :-1] <= 0.0) & (slope[:, 1:] > 0.0)
    # where rails come by again, the other rail is near once more, far along it
    shares = np.linspace(0.0, 1.0, len(at))[:, None] - np.linspace(0.0, 1.0, _SEARCHED)
    along = np.abs(shares) * second.length()
    near = np.where(crossing, (width + along)[:, :-1], np.inf)
    place = np.argmin(near, axis=1)
    rows = np.arange(len(at))
    found = np.isfinite(near[rows, place])
    before, after = slope[rows, place], slope[rows, place + 1]
    share = before / np.where(found, before - after, 1.0)
    other = fine[place] + share * (fine[place + 1] - fine[place])
    # facing places beyond the ends, as if the rail went on straight with the first one beside it
    length = second.length()
    for column, end, sign in ((0, 0.0, 1.0), (-1, 1.0, -1.0)):
        beyond = ~found & (sign * slope[:, column] >= 0.0)
        other[beyond] = end - slope[beyond, column] / 2.0 / length
        found |= beyond
    if found.sum() < 2:
        return at
    other = np.interp(at, at[found], other[found])
    # back to the common ends within about a chord's length
    reach = float(np.median(width.min(axis=1)))
    decay = np.exp(-3.0 * np.stack([at, 1.0 - at]) * length / max(reach, 1e-9 * length))
    other = other - other[0] * decay[0] + (1.0 - other[-1]) * decay[1]
    other[[0, -1]] = 0.0, 1.0
    return _increasing(np.clip(other, 0.0, 1.0))


def _increasing(values: Array) -> Array:
    """Values that do not decrease are made to increase by a little everywhere."""
    values = np.maximum.accumulate(values)
    ramp = np.linspace(0.0, 1.0, len(values))
    return (1.0 - 1e-3) * values + 1e-3 * ramp
