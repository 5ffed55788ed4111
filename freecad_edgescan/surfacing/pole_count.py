# SPDX-License-Identifier: LGPL-2.1-or-later
"""As many poles as the points ask for.

From one patch on, poles are added in the direction that lowers the misfit more, until the largest
deviation is within the tolerance, or until more poles no longer tell more than their number costs
(Bayesian information criterion, the same as for curves). The search goes through some of the
points; all are asked at its end.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineSurface
from ..geometry.knot_vectors import averaged_knots
from ..geometry.plain_number import plain
from .fit_result import SurfaceFit
from .parameterised import Parameterised
from .surface_through import surface_through

if TYPE_CHECKING:
    from ..scanning import Progress

__all__ = ["averaged", "fit_with_enough_poles", "some_of"]

Array = NDArray[np.float64]

_GROWTH = (1.4, 2.0)  # a few more poles may fit worse where knots lie unluckily
_MOST = 200  # poles in one direction
_SOME = 20_000  # points that are enough to choose


def fit_with_enough_poles(
    given: Parameterised,
    base: BSplineSurface,
    degree: tuple[int, int],
    tolerance: float | None,
    corrections: int,
    smoothing: float,
    progress: Progress | None = None,
) -> SurfaceFit:
    """The fit with the fewest poles that keeps the tolerance, or that the points justify."""
    if tolerance is not None and not tolerance > 0.0:
        raise ValueError(f"The tolerance is {tolerance} mm; give a positive length.")
    search = _Search(base, degree, tolerance, smoothing, int((~given.outside).sum()), progress)
    some = some_of(given)
    poles = search.grown(some, (degree[0] + 1, degree[1] + 1))
    fit = search.fit(given, poles, corrections)
    if tolerance is not None and some is not given and fit.maximum > tolerance:
        poles = search.grown(given, poles)
        fit = search.fit(given, poles, corrections)
    if tolerance is None or fit.maximum <= tolerance or search.cancelled:
        return fit
    said = (
        f"The largest deviation is {plain(fit.maximum, 3)} mm, above the tolerance of "
        f"{tolerance:g} mm; more control points would only follow the points' scatter."
    )
    return replace(fit, message=f"{said} {fit.message}".strip())


class _Search:
    """Grows the number of poles over a base surface."""

    def __init__(
        self,
        base: BSplineSurface,
        degree: tuple[int, int],
        tolerance: float | None,
        smoothing: float,
        count: int,
        progress: Progress | None,
    ) -> None:
        self._base, self._degree, self._smoothing = base, degree, smoothing
        self._tolerance, self._count, self._progress = tolerance, count, progress
        self.cancelled = False

    def fit(self, given: Parameterised, poles: tuple[int, int], corrections: int) -> SurfaceFit:
        knots = averaged(given, self._base, poles, self._degree)
        return surface_through(given, self._base, knots, self._degree, corrections, self._smoothing)

    def grown(self, given: Parameterised, poles: tuple[int, int]) -> tuple[int, int]:
        """Numbers of poles at which the search ends."""
        points = int((~given.outside).sum())
        best = self.fit(given, poles, 0)
        while self._tolerance is None or best.maximum > self._tolerance:
            if self._progress and not self._progress.update(np.nan, best):
                self.cancelled = True
                break
            found = self._better(given, poles, best, points)
            if found is None:
                break
            poles, best = found
        return poles

    def _better(
        self, given: Parameterised, poles: tuple[int, int], best: SurfaceFit, points: int
    ) -> tuple[tuple[int, int], SurfaceFit] | None:
        """Larger numbers of poles that tell more than they cost, and their fit."""
        for growth in _GROWTH:
            wider = {
                trial: self.fit(given, trial, 0)
                for trial in _wider(poles, growth)
                if max(trial) <= _MOST and 2 * trial[0] * trial[1] <= points
            }
            if not wider:
                return None
            trial = min(wider, key=lambda size: self._information(wider[size], points))
            if self._information(wider[trial], points) < self._information(best, points):
                return trial, wider[trial]
        return None

    def _information(self, fit: SurfaceFit, points: int) -> float:
        """Bayesian information criterion for all points, from some of them; lower is better."""
        poles = fit.surface.poles.shape[0] * fit.surface.poles.shape[1]
        variance = max(fit.rms**2, 1e-300) / (1.0 - poles / points)
        return float(self._count * np.log(variance) + poles * np.log(self._count))


def averaged(
    given: Parameterised, base: BSplineSurface, poles: tuple[int, int], degree: tuple[int, int]
) -> tuple[Array, Array]:
    """Knots averaged over the points' parameters; even ones where too many are alike."""
    on = ~given.outside
    knots = []
    for x, count, p, limits in zip(
        (given.u[on], given.v[on]), poles, degree, base.parameter_range, strict=True
    ):
        even = np.linspace(*limits, count - p + 1)
        own = averaged_knots(x, count, p, limits) if len(x) >= count else None
        if own is None or np.diff(own[p : count + 1]).min() < 1e-3 * (even[1] - even[0]):
            own = np.r_[[limits[0]] * p, even, [limits[1]] * p]
        knots.append(own)
    return knots[0], knots[1]


def _wider(poles: tuple[int, int], growth: float) -> tuple[tuple[int, int], ...]:
    more = tuple(max(count + 1, round(growth * count)) for count in poles)
    return (more[0], poles[1]), (poles[0], more[1]), (more[0], more[1])


def some_of(given: Parameterised) -> Parameterised:
    """Every so manieth point, so that no more than enough remain."""
    step = -(-len(given.u) // _SOME)
    if step == 1:
        return given
    rows = slice(None, None, step)
    return Parameterised(given.points[rows], given.u[rows], given.v[rows], given.outside[rows])
