# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces made longer over one of their sides, with a common tangent plane there.

Shetty and White 1991, Curvature-continuous extensions for rational B-spline curves and surfaces
(Computer-Aided Design 23), in the linear form of Schreve appendix H: the extension is ruled. With
λ₀ = -1 and ω = 1 its homogeneous first derivative is the surface's own less τ times the surface,
which changes no derivative of the surface itself: for every τ the first derivatives agree on both
sides, and τ only decides the weights, and with them how far the extension reaches.

Eq. H1.4.a lacks a weight on its left. Table 3 of the appendix comes out with τ = 1; the rule that
is printed with it gives τ = 9 for that surface.
"""

from __future__ import annotations

from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineSurface

__all__ = ["Side", "extend_surface"]

Array = NDArray[np.float64]


class Side(StrEnum):
    """A side of a surface: first or last parameter in u or v."""

    U0 = "u0"
    U1 = "u1"
    V0 = "v0"
    V1 = "v1"

    @property
    def axis(self) -> int:
        """0 for u, 1 for v."""
        return "uv".index(self.value[0])

    @property
    def is_last(self) -> bool:
        """Whether the parameter is the last one there."""
        return self.value[1] == "1"


def extend_surface(
    surface: BSplineSurface, side: Side | str = "u0", ratio: float = 0.25, tau: float | None = None
) -> BSplineSurface:
    """The surface with a ruled extension over one side.

    Parameters
    ----------
    surface : what is extended; it stays what it is over its own parameters
    side : "u0", "u1", "v0" or "v1"
    ratio : float
        Length of the extension's parameter range, relative to that of the surface.
    tau : float, optional
        τ of eq. H1.4.b. Without it Shetty and White's rule: the smallest with which no new weight
        is below that of the surface's second row of poles, so that a surface without weights
        stays one.

    Returns
    -------
    BSplineSurface over the longer range; rational when the surface is, or when `tau` is given
    and not 0.

    Raises
    ------
    ValueError: no such side, a side on which a closed surface meets itself, a ratio that is not
        positive, or a τ with which a weight would not be positive.
    """
    if side not in list(Side):
        raise ValueError(f"A surface has no side {side!r}; choose u0, u1, v0 or v1.")
    side = Side(side)
    if not 0.0 < ratio < np.inf:
        raise ValueError(f"The ratio of the extension is {ratio}; give a positive number.")
    if surface.closed[side.axis]:
        raise ValueError(
            f"The surface is closed in {side.value[0]}, so that its side {side.value} is no rim; "
            "extend another side, or a part of the surface."
        )
    turned = surface.transposed() if side.axis else surface
    turned = turned.reversed(0) if side.is_last else turned
    longer = _extended_at_first_u(turned, ratio, tau)
    longer = _shifted(longer.reversed(0), surface, side.axis) if side.is_last else longer
    return longer.transposed() if side.axis else longer


def _extended_at_first_u(
    surface: BSplineSurface, ratio: float, tau: float | None
) -> BSplineSurface:
    p, knots = surface.degree[0], surface.knots[0]
    first, last = knots[0], knots[-1]
    reach = ratio * (last - first)
    beyond, span = reach, knots[p + 1] - first  # u_2p - u_p and u_2p+1 - u_p+1 of H1.4
    weights = np.ones(surface.poles.shape[:2]) if surface.weights is None else surface.weights
    if tau is None:
        change = p * (weights[1] - weights[0]) * (1.0 / span + 1.0 / beyond)
        tau = float(np.max(change / weights[0]))
    homogeneous = np.concatenate([surface.poles * weights[..., None], weights[..., None]], axis=-1)
    rim, second = homogeneous[0], homogeneous[1]
    new = rim + beyond / p * (tau * rim - p / span * (second - rim))  # H1.4 solved for r - 1
    if not np.all(new[:, 3] > 0.0):
        least = np.max(p / span * (weights[1] / weights[0] - 1.0)) - p / beyond
        raise ValueError(
            f"With τ = {tau:g} a weight of the extension is not positive; take τ above "
            f"{least:.6g}, or a smaller ratio."
        )
    step = new[:, :3] / new[:, 3:] - surface.poles[0]
    share = np.arange(p, 0, -1)[:, None, None]  # H1.6: poles in equal steps on a line
    poles = np.concatenate([surface.poles[0] + share * step, surface.poles])
    longer = np.concatenate([np.broadcast_to(new[:, 3], (p, len(new))), weights])
    own = np.r_[[first - reach] * (p + 1), [first] * p, knots[p + 1 :]]
    polynomial = surface.weights is None and np.allclose(longer, 1.0, rtol=0.0, atol=1e-14)
    return BSplineSurface(
        poles, (own, surface.knots[1]), surface.degree, None if polynomial else longer
    )


def _shifted(longer: BSplineSurface, surface: BSplineSurface, axis: int) -> BSplineSurface:
    """The reversed extension over parameters that begin where the surface's own do."""
    own = surface.knots[axis]
    knots = longer.knots[0] + (own[0] - longer.knots[0][0])
    knots[: len(own) - 1] = own[:-1]  # to the last bit
    return BSplineSurface(longer.poles, (knots, longer.knots[1]), longer.degree, longer.weights)
