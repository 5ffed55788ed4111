# SPDX-License-Identifier: LGPL-2.1-or-later
"""The least-squares surface through points with parameters, over knots that are given.

Not the surface itself but its displacement from the base surface is solved for, and a little of
the displacement's energy is kept low: where the cloud says nothing the base surface goes
on. Parameters are corrected to the closest points of the surface (Hoschek 1988, Intrinsic
parametrization for approximation), and the poles solved anew.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineSurface
from ..geometry.surface_interpolation import interpolated_surface
from .displacement_energy import displacement_energy
from .fit_result import SurfaceFit, said_of_outside, signed_deviation
from .parameterised import Parameterised
from .seam import Unrolled
from .support import dense_enough, said_of_support
from .tensor_system import TensorSystem

if TYPE_CHECKING:
    from ..scanning import Progress

__all__ = ["surface_through"]

Array = NDArray[np.float64]


def surface_through(
    given: Parameterised,
    base: BSplineSurface,
    knots: tuple[Array, Array],
    degree: tuple[int, int],
    corrections: int,
    smoothing: float,
    progress: Progress | None = None,
) -> SurfaceFit:
    """The surface whose distances to the points are smallest; see `fit_surface`."""
    nu, nv = (len(k) - p - 1 for k, p in zip(knots, degree, strict=True))
    on = ~given.outside
    if on.sum() < nu * nv:
        raise ValueError(
            f"{nu} × {nv} control points need at least {nu * nv} points, and only {on.sum()} of "
            f"the {len(on)} lie over the base surface; give more points, or fewer control points."
        )
    unrolled = Unrolled(base, knots, degree)
    wide = unrolled.wide_knots
    start = interpolated_surface(unrolled.shape(), wide, degree)
    energy = displacement_energy(wide, degree, _mean_size(start))
    x, u, v = given.points[on], given.u[on], given.v[on]
    for correction in range(corrections + 1):
        rows, at_u, at_v = unrolled.repeated(u, v)
        system = TensorSystem(at_u, at_v, x[rows] - start.evaluate(at_u, at_v), wide, degree)
        surface = unrolled.rolled_up(start.poles + system.solve(energy, smoothing))
        u, v, distance = surface.closest(x, start=(u, v))
        last = correction == corrections
        if not last and progress is None:
            continue
        fit = _measured(
            surface,
            given,
            u,
            v,
            distance,
            dense_enough(unrolled.inner(system.points_of_patch), knots),
        )
        if progress and not progress.update((correction + 1) / (corrections + 1), fit):
            break
    return fit


def _measured(
    surface: BSplineSurface,
    given: Parameterised,
    u: Array,
    v: Array,
    distance: Array,
    supported: NDArray[np.bool_],
) -> SurfaceFit:
    """The result: fitted points have their feet already, those outside get theirs."""
    on, off = ~given.outside, given.outside
    parameters = given.u.copy(), given.v.copy()
    lengths = np.empty(len(on))
    parameters[0][on], parameters[1][on], lengths[on] = u, v, distance
    if off.any():
        feet = surface.closest(given.points[off], start=(given.u[off], given.v[off]))
        parameters[0][off], parameters[1][off], lengths[off] = feet
    deviation = signed_deviation(surface, given.points, *parameters, lengths)
    said = (
        said_of_outside(given.outside),
        said_of_support(surface, supported, "there it follows the base surface"),
    )
    message = " ".join(filter(None, said))
    return SurfaceFit(surface, deviation, parameters, given.outside, supported, message)


def _mean_size(surface: BSplineSurface) -> tuple[float, float]:
    """Mean lengths of the surface's curves in u and in v, by their chords, mm."""
    (u0, u1), (v0, v1) = surface.parameter_range
    grid = surface.evaluate(np.linspace(u0, u1, 20)[:, None], np.linspace(v0, v1, 20))
    lengths = [
        float(np.linalg.norm(np.diff(grid, axis=axis), axis=2).sum(axis=axis).mean())
        for axis in (0, 1)
    ]
    return lengths[0], lengths[1]
