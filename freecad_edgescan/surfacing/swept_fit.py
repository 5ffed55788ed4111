# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept surfaces fitted to a segment of a cloud: rails and profiles move, the intent stays.

Schreve 6.6.3, for both models: the base sweep gives the points their parameters; rails and profiles
are fitted, with knots where those of the base bend, and the parameters corrected to the fitted
sweep.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud.progress import Stage
from ..geometry import BSplineSurface
from ..geometry.plain_number import plain
from .blend_fit import BlendFit
from .even_error_knots import even_error_knots
from .fit_result import SurfaceFit, said_of_outside, signed_deviation
from .parameterised import Parameterised, beyond_the_rim, parameterised
from .pole_count import some_of
from .rotate_fit import RotateFit
from .support import dense_enough, said_of_support
from .swept_surface import SweepModel, SweptSurface

if TYPE_CHECKING:
    from ..scanning import Progress

__all__ = ["SweptFit", "compare_sweep_models", "fit_swept_surface"]

Array = NDArray[np.float64]

_ROUNDS = {SweepModel.BLEND: 3, SweepModel.ROTATE: 8}
_ENOUGH = 1e-3  # relative change of the rms at which the rounds end
_SHORTER = (0.3, 0.1, 0.0)  # shares of a step that are tried when the whole leads astray
_SAMPLES = 600  # of the base's curves, from which the knots are chosen
_SHARE = 0.1  # of the points' rms: the surface's own tolerance against the sweep


@dataclass(frozen=True, eq=False)
class SweptFit(SurfaceFit):
    """A fitted sweep: `sweep` with its rails and profiles, and `surface`, the B-spline of it."""

    sweep: SweptSurface | None = None


def fit_swept_surface(
    points: ArrayLike,
    base: SweptSurface,
    control_points: tuple[int, int] = (14, 7),
    progress: Progress | None = None,
) -> SweptFit:
    """The sweep of the base's model that fits points best.

    Parameters
    ----------
    points : (n, 3) array
        Points of the segment in mm, compensated for the probe.
    base : SweptSurface
        Two rails and profiles near the points.
    control_points : two int
        Number of poles of each rail and of each profile.
    progress : object with ``update(fraction, so_far) -> bool``, optional
        Told the fit so far, measured at some of the points; when it answers False that is the
        result.

    Returns
    -------
    SweptFit; deviations are those from its surface, which follows the sweep within a tenth of
    their rms.

    Raises
    ------
    ValueError: a base with one rail, fewer points than unknowns, or too few control points.
    """
    if len(base.rails) != 2:
        raise ValueError("Only sweeps along two rails are fitted; give the base a second rail.")
    for name, count in zip(("rails", "profiles"), control_points, strict=True):
        if count < 4:
            raise ValueError(f"{count} control points are too few for the {name}; give 4 or more.")
    surface = base.to_bspline(1e-2)
    given = parameterised(points, surface, progress and Stage(progress, 0.0, 0.2))
    poles = 2 * control_points[0] + len(base.profiles) * (control_points[1] - 2)
    on = int((~given.outside).sum())
    if on < 3 * poles:
        raise ValueError(
            f"Rails and profiles of {control_points[0]} and {control_points[1]} control points "
            f"need at least {3 * poles} points, and only {on} of the {len(given.u)} lie over the "
            "base surface; give more points, or fewer control points."
        )
    knots = _knots(base, control_points)
    fit: BlendFit | RotateFit
    fit = BlendFit(base, *knots) if base.model is SweepModel.BLEND else RotateFit(base, *knots)
    some = some_of(given)
    kept = ~some.outside
    x = some.points[kept]
    feet = _feet(fit.sweep, x, some.u[kept], some.v[kept])
    rounds = _ROUNDS[base.model]
    for number in range(rounds):
        before = feet.rms
        feet = _improved(fit, x, feet)
        if progress:
            so_far = _measured(fit.sweep, feet.surface, some, knots, "")
            if not progress.update(0.2 + 0.7 * (number + 1) / rounds, so_far):
                return so_far
        if before - feet.rms <= _ENOUGH * before and number > 0:
            break
    return _measured(fit.sweep, feet.surface, given, knots, fit.sweep.message)


def _knots(base: SweptSurface, poles: tuple[int, int]) -> tuple[Array, Array]:
    """Knots for the rails and for the profiles, denser where they bend."""
    share = np.linspace(0.0, 1.0, _SAMPLES)
    rails = np.concatenate([base.evaluate(share, v) for v in (0.0, 1.0)], axis=1)
    local = np.concatenate(list(base.local_profiles(share)), axis=1)
    return (
        even_error_knots(share, rails, poles[0], 3),
        even_error_knots(share, local, poles[1], 3),
    )


def compare_sweep_models(
    points: ArrayLike,
    base: SweptSurface,
    control_points: tuple[int, int] = (14, 7),
    progress: Progress | None = None,
) -> dict[SweepModel, SweptFit]:
    """Both models fitted to the same points, the better one first, and its message says so.

    Parameters and errors are those of `fit_swept_surface`; the base has two profiles. When progress
    answers False during the first fit, there is no second one.
    """
    fits: dict[SweepModel, SweptFit] = {}
    for number, model in enumerate(SweepModel):
        own = SweptSurface(base.rails, base.profiles, model, largest_gap=base.largest_gap)
        half = Stage(progress, 0.5 * number, 0.5 * (number + 1))
        fits[model] = fit_swept_surface(points, own, control_points, progress and half)
        if half.cancelled and number == 0:
            return fits
    pairs = sorted(fits.items(), key=lambda pair: pair[1].rms)
    (better, first), (other, second) = pairs
    said = (
        f"The {better} model explains the points better: {plain(first.average, 3)} mm on average, "
        f"against {plain(second.average, 3)} mm of the {other} model."
    )
    return {better: replace(first, message=f"{said} {first.message}".strip()), other: second}


@dataclass(frozen=True, eq=False)
class _Feet:
    """A sweep's surface, the parameters of the points' feet on it, and the rms distance."""

    surface: BSplineSurface
    u: Array
    v: Array
    rms: float


def _feet(sweep: SweptSurface, points: Array, u: Array, v: Array) -> _Feet:
    rough = sweep.evaluate(u, v) - points
    surface = sweep.to_bspline(max(_SHARE * float(np.sqrt(np.mean(rough**2))), 1e-6))
    u, v, distance = surface.closest(points, start=(u, v))
    return _Feet(surface, u, v, float(np.sqrt(np.mean(distance**2))))


def _improved(fit: BlendFit | RotateFit, points: Array, feet: _Feet) -> _Feet:
    """The feet after one round; a step of the rotating fit that leads astray is shortened."""
    if isinstance(fit, BlendFit):
        fit.improve(points, feet.u, feet.v)
        return _feet(fit.sweep, points, feet.u, feet.v)
    fit.improve(points, feet.u, feet.v, feet.surface.normal(feet.u, feet.v))
    for share in _SHORTER:
        after = _feet(fit.sweep, points, feet.u, feet.v)
        if after.rms <= feet.rms:
            return after
        fit.shorten(share)
    return _feet(fit.sweep, points, feet.u, feet.v)


def _measured(
    sweep: SweptSurface,
    surface: BSplineSurface,
    given: Parameterised,
    knots: tuple[Array, Array],
    of_the_sweep: str,
) -> SweptFit:
    u, v, distance = surface.closest(given.points, start=(given.u, given.v))
    deviation = signed_deviation(surface, given.points, u, v, distance)
    # rails move, and with them the rim
    outside = given.outside | beyond_the_rim(given.points, surface, u, v)
    supported = _supported(surface, knots, u[~outside], v[~outside])
    said = (
        said_of_outside(outside),
        said_of_support(surface, supported, "there the rest of the sweep decides"),
        of_the_sweep,
    )
    message = " ".join(filter(None, said))
    return SweptFit(surface, deviation, (u, v), outside, supported, message, sweep)


def _supported(
    surface: BSplineSurface, knots: tuple[Array, Array], u: Array, v: Array
) -> NDArray[np.bool_]:
    """The surface's patches that lie where spans of the rails' and profiles' knots hold points."""
    spans = [np.unique(own) for own in knots]
    rows, columns = (
        np.clip(np.searchsorted(own, x, side="right") - 1, 0, len(own) - 2)
        for own, x in zip(spans, (u, v), strict=True)
    )
    count = np.zeros([len(own) - 1 for own in spans])
    np.add.at(count, (rows, columns), 1)
    middle = [(own[1:] + own[:-1]) / 2 for own in surface.patches.breaks]
    place = [
        np.clip(np.searchsorted(own, at) - 1, 0, len(own) - 2)
        for own, at in zip(spans, middle, strict=True)
    ]
    return np.asarray(dense_enough(count, knots)[np.ix_(*place)])
