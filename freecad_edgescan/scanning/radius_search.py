# SPDX-License-Identifier: LGPL-2.1-or-later
"""The radius of the rounding between two sides: some are tried, and the likeliest let free.

Which is the likeliest is not the one that fits best. Two bent sides without a rounding follow the
points of a rounding well, and so do two planes with one; the planes had less to choose from. What
a radius is worth is the average over all the curvatures its sides might have (`agreed_shape`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .agreed_shape import agreed_shape, shape_evidence
from .normal_equations import BLOCK_EDGES
from .rounded_rows import Rounded
from .rounded_strip import COARSE, FAR, FINE, LARGEST, WIDEST, Expected, RoundedStrip, moved

__all__ = ["SeenRadii", "Settled", "of_some_radii", "radii_about", "settled", "some_radii"]

_RADII = (0.3, 1.0, 2.0, 3.0, 4.5, 6.5, 9.0, 12.0, 16.0, 21.0)  # pitches
_ABOUT = (0.7, 1.0, 1.4)  # times a radius that is roughly known


def some_radii(pitch: float) -> np.ndarray:
    """Radii to try, (k,), the first one as good as none; pitch of the cloud."""
    radii = np.array(_RADII) * pitch
    return radii[: max(np.count_nonzero(radii <= LARGEST), 2)]


def radii_about(pitch: float, radius: float) -> np.ndarray:
    """Radii to try where one is roughly known, (k,), the first one as good as none."""
    smallest = _RADII[0] * pitch
    about = np.array(_ABOUT) * min(max(radius, 2.0 * smallest), LARGEST)
    return np.append(smallest, about[about <= LARGEST])


@dataclass(frozen=True)
class SeenRadii:
    """Roundings of some radii between two sides, the smallest first.

    Attributes
    ----------
    models : with each of the radii
    odds : logarithms of how likely each makes the points
    """

    models: list[Rounded]
    odds: np.ndarray

    @property
    def sharpest(self) -> Rounded:
        """The one with the smallest radius, which is as good as none."""
        return self.models[0]

    @property
    def likeliest(self) -> Rounded:
        """The likeliest of the others, if there are any."""
        others = self.odds[1:]
        return self.models[1 + int(np.argmax(others))] if len(others) else self.sharpest

    def rounded(self, strip: RoundedStrip, found: Rounded) -> float:
        """Probability of a rounding that is wider than the smallest.

        Between some radii the points may have none that they fit; the one that was found from the
        likeliest of them counts as another.
        """
        odds = np.append(self.odds, _evidence(strip, found))
        likely = np.exp(odds - odds.max())
        return float(likely[1:].mean() / (likely[0] + likely[1:].mean()))


def of_some_radii(
    strip: RoundedStrip,
    coefficients: np.ndarray,
    expected: Expected,
    lasts: np.ndarray,
    radii: np.ndarray,
) -> SeenRadii:
    """Fit the sides with each of some radii, in reaches, as far as there is room for them."""
    widest = WIDEST * float(np.median(BLOCK_EDGES[lasts]))
    blurred = strip.blurred()
    odds: list[float] = []
    models: list[Rounded] = []
    for radius in radii:
        model = Rounded(coefficients, np.full(len(strip.frames), radius))
        model, _ = moved(blurred, model, expected, COARSE, free=False)
        model = settled(blurred, model, expected, free=False).model
        if models and float(np.median(strip.rows(model)[0].begins)) > widest:
            break
        odds.append(_evidence(blurred, model))
        models.append(model)
        coefficients = model.coefficients
    seen = SeenRadii(models, np.array(odds))
    return seen if blurred is strip else _sharply(strip, blurred, seen, expected)


def _sharply(
    strip: RoundedStrip, blurred: RoundedStrip, seen: SeenRadii, expected: Expected
) -> SeenRadii:
    """The sharpest and the likeliest of the roundings once more, with the strip's true noise."""
    models = [settled(strip, seen.sharpest, expected, free=False).model]
    if len(seen.models) > 1:
        models.append(settled(blurred, seen.likeliest, expected, free=True).model)
    return SeenRadii(models, np.array([_evidence(strip, model) for model in models]))


def _evidence(strip: RoundedStrip, model: Rounded) -> float:
    """Logarithm of how likely the points are with a model's radius, whatever the curvatures."""
    seen = strip.rows(model)
    own = strip.summed(model, FINE[0], seen)
    average = shape_evidence(own, model.coefficients, model.radius, strip.counted)
    return average - 0.5 * strip.misfit(seen[1])


@dataclass(frozen=True)
class Settled:
    """Sides and a rounding with what neighbouring sections agree on.

    Attributes
    ----------
    model : the sides and the rounding
    expected : what is expected of each section by itself
    agreeing : sections on each side that mostly agree
    """

    model: Rounded
    expected: Expected
    agreeing: int


def settled(strip: RoundedStrip, model: Rounded, expected: Expected, free: bool) -> Settled:
    """Bring a model to the points with curvatures, and a radius if free, that neighbours share."""
    if free:
        model, _ = moved(strip, model, expected, FAR + FINE)
    for _ in range(3 if free else 1):
        own = strip.summed(model, FINE[0])
        mean, covariance, agreeing = agreed_shape(
            own, model.radius, strip.counted, strip.closed, not free
        )
        expected = expected.with_shape(mean, covariance)
        model, _ = moved(strip, replace(model, radius=mean[:, -1]), expected, FINE)
    return Settled(model, expected, agreeing)
