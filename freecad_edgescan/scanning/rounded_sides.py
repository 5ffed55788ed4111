# SPDX-License-Identifier: LGPL-2.1-or-later
"""Both sides of an edge fitted together with the rounding between them.

Where a rounding is wide beside its sides, or the noise hides where it begins, sides fitted by
themselves take a part of it for their own and turn towards it, and the edge, over which they are
drawn out, moves by many times the noise. Fitted together, the sides, the rounding and where it
begins are one question with one answer (`rounded_rows`):

1. a first radius, the best of a row of them;
2. where the sides end: a far end that bends away is the next rounding;
3. what neighbouring sections agree on: both curvatures and the radius (`agreed_shape`);
4. each section by itself, with these expected;
5. where a rounding and none are both likely, their mean.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import convolve1d

from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from .edge_path import EdgePath
from .errors import ScanError
from .normal_equations import BLOCK_EDGES
from .patch_section import PatchSettings
from .radius_search import (
    SeenRadii,
    Settled,
    of_some_radii,
    radii_about,
    settled,
    some_radii,
)
from .rounded_ends import (
    beyond_rounding,
    even_stretch,
    moved_by_last_block,
    without_far_ends,
)
from .rounded_fits import RoundedFits
from .rounded_rows import Rounded, solved
from .rounded_strip import POOLED, Expected, RoundedStrip, stepped
from .section import SectionPoints
from .side_fit import SideFits
from .stop import GIVEN_ENDS

__all__ = ["fit_rounded"]

_ROUNDS = 5
_UNLIKELY = 0.02  # probability below which a rounding, or none, is left out of account
_SURELY = 0.9  # that from which on no edge is known beside one that leaves no side
# Mean square of the points about a rounding, in variances, and its own standard deviations above
# that, from which on it is none.
_NO_CIRCLE, _BY_CHANCE = 1.2, 3.0
_OF_A_CIRCLE = 5.0  # standard deviations, farther off than which is another surface
_OF_A_SECTION = 3.5  # the same, when a section is fitted by itself
_LEAST_SIDE, _NARROW = 1.5, 0.3  # pitches of a side beyond the rounding, and share with less
_A_PIECE = 0.5  # of a side that was fitted by itself, on the rounding
_WORSE, _SOME = 0.5, 0.1  # variances by which they may fit worse, and share of sections that may
_WIDER = (1, 2, 4, 8)  # sections on each side to borrow points from
_THIN = 0.25  # variance of an extrapolated side, in noise squared, that asks for more points


def fit_rounded(
    points: SectionPoints,
    fits: SideFits,
    noise: np.ndarray,
    path: EdgePath,
    settings: PatchSettings,
    counted: float,
    about: float | None = None,
) -> tuple[RoundedFits, np.ndarray, int] | None:
    """Fit both sides of each section and the rounding between them.

    Parameters
    ----------
    points : of the strip along the edge, those of a rounding among them
    fits : sides as they were fitted by themselves
    noise : (m, 2) standard deviation of the points about these, mm
    path : the sections
    counted : how often sums over neighbouring sections count each point
    about : radius of the rounding, mm, as far as it is known

    Returns
    -------
    the fits, how many neighbours on each side each section borrowed points from (m,), and how many
    sections on each side mostly agree on the shape; None where no circle is seen between the
    sides, or they fit worse with it than by themselves

    Raises
    ------
    ScanError: there surely is a rounding, and it leaves next to nothing of a side.
    """
    strip = RoundedStrip.of(points, noise, path, settings, counted)
    expected = Expected.nothing(len(path))
    mine, seen, lasts = _searched(strip, fits, expected, about)
    if not len(mine.place):  # no side reaches as far as its points
        return None
    even, found = _between_even_ends(mine, seen.likeliest, expected, path)
    rounded = seen.rounded(mine, found.model)
    if rounded < _UNLIKELY:
        return None
    if not _is_a_circle(even, found.model) or not _leaves_sides(even, found.model, lasts):
        # Far ends may have been cut for another radius' sake; sides by themselves know none.
        if rounded > _SURELY and (
            not _leaves_sides(even, found.model, fits.stretch[..., 1])
            or _within_rounding(even, found.model, fits)
        ):
            raise _no_side_left(strip, found.model)
        return None
    together, borrowed = _section_by_section(even, found, fits, lasts)
    if _worse_than_alone(even, together, fits) or _bends_sides_to_a_circle(together, fits):
        return None
    if rounded < 1.0 - _UNLIKELY:
        sharp = settled(even, seen.sharpest, expected, free=False)
        other, _ = _section_by_section(even, sharp, fits, lasts)
        together = together.or_else(other, 1.0 - rounded)
    return together, borrowed, found.agreeing


def _no_side_left(strip: RoundedStrip, model: Rounded) -> ScanError:
    radius = float(np.median(model.radius)) * strip.reach
    middle = strip.frames.origin[len(strip.frames) // 2]
    least = _LEAST_SIDE * strip.pitch * strip.reach
    return ScanError(
        f"Something like a rounding of radius {plain(radius, 2)} mm near ({place_text(middle)}) "
        f"leaves less than {plain(least, 2)} mm of one side, and where that met the other one is "
        "not known. Click elsewhere across the rounding or along it, or scan denser."
    )


def _searched(
    strip: RoundedStrip, fits: SideFits, expected: Expected, about: float | None
) -> tuple[RoundedStrip, SeenRadii, np.ndarray]:
    """Look for the radius, and for where the sides end: neither is known without the other.

    Returns the strip cut at those ends, the radii that were tried, and the last blocks (m, 2).
    """
    lasts, coefficients = fits.stretch[..., 1], fits.coefficients
    mine, seen = strip.within(BLOCK_EDGES[lasts]), None
    if about is None:
        seen = of_some_radii(mine, coefficients, expected, lasts, some_radii(strip.pitch))
        first, coefficients = seen.likeliest, seen.sharpest.coefficients
    else:
        first = Rounded(coefficients, np.full(len(coefficients), about / strip.reach))
    ends = beyond_rounding(mine, first, lasts)
    ends = without_far_ends(strip, first, expected, ends)
    if seen is not None and np.array_equal(ends, lasts):
        return mine, seen, lasts
    mine = strip.within(BLOCK_EDGES[ends])
    radii = radii_about(strip.pitch, float(np.median(first.radius)))
    return mine, of_some_radii(mine, coefficients, expected, ends, radii), ends


def _between_even_ends(
    strip: RoundedStrip, model: Rounded, expected: Expected, path: EdgePath
) -> tuple[RoundedStrip, Settled]:
    """Settle the sides and their rounding without the ends of the edge that are not like the rest.

    An end that was given is none.
    """
    open_ends = tuple(end not in GIVEN_ENDS for end in path.ends)
    found = settled(strip, model, expected, free=True)
    for _ in range(_ROUNDS):
        even = strip.between(*even_stretch(strip, found.model, open_ends))
        if len(even.place) == len(strip.place):
            break
        strip = even
        found = settled(strip, model, expected, free=True)
    return strip, found


def _worse_than_alone(strip: RoundedStrip, together: RoundedFits, alone: SideFits) -> bool:
    """Whether in some of the sections the points of the sides fit worse to them than before.

    The sides that were fitted by themselves are known to be smooth within the noise.
    """
    points = strip.points
    rows, off = strip.rows(Rounded(together.coefficients, together.radius))
    before = alone.residuals(points) / (strip.reach * points.of_their_sides(strip.noise))
    both = alone.within(points) & together.within(points) & ~rows.on_arc
    both &= np.abs(before) < _OF_A_SECTION
    gained = np.minimum(off[both] ** 2, 9.0) - np.square(before[both])
    mode = "wrap" if strip.closed else "constant"
    total, count = (
        convolve1d(
            np.bincount(points.owner[both], weights=part, minlength=len(strip.frames)),
            np.ones(2 * POOLED + 1),
            mode=mode,
        )
        for part in (gained, np.ones(len(gained)))
    )
    return bool(np.mean(total > _WORSE * np.maximum(count, 1.0)) > _SOME)


def _bends_sides_to_a_circle(together: RoundedFits, alone: SideFits) -> bool:
    """Whether the sides bend inwards for the rounding's sake, and lose more than they gain by it.

    Where wear or a blend has rounded the edge otherwise than a circle does, a circle and sides that
    are bent into it fit a short piece of the blend, and nothing of the sides farther out.
    """
    explained, before = together.ends, alone.ends - alone.begins
    curvature, unforced = together.coefficients[..., 2], alone.coefficients[..., 2]
    return bool(
        np.median(explained, axis=0).sum() < np.median(before, axis=0).sum()
        and np.median(curvature, axis=0).sum() < np.median(unforced, axis=0).sum()
    )


def _is_a_circle(strip: RoundedStrip, model: Rounded) -> bool:
    """Whether there are points between the sides, and they lie on the rounding.

    Those of a chamfer, or of wear, bring sides and a rounding together that are none of theirs.
    """
    rows, off = strip.rows(model)
    arc = rows.on_arc & (np.abs(off) < _OF_A_CIRCLE)
    if not arc.any():
        return False
    weight = strip.crowd[arc]
    chance = _BY_CHANCE * np.sqrt(2.0 * strip.counted / weight.sum())
    return bool(np.average(off[arc] ** 2, weights=weight) <= _NO_CIRCLE + chance)


def _leaves_sides(strip: RoundedStrip, model: Rounded, lasts: np.ndarray) -> bool:
    """Whether the rounding leaves enough of both sides."""
    beyond = BLOCK_EDGES[lasts] - strip.rows(model)[0].begins
    return bool(np.quantile(beyond, _NARROW, axis=0).min() >= _LEAST_SIDE * strip.pitch)


def _within_rounding(strip: RoundedStrip, model: Rounded, alone: SideFits) -> bool:
    """Whether one of the sides that were fitted by themselves is a piece of the rounding."""
    begins, ends = (BLOCK_EDGES[alone.stretch[..., k]] for k in (0, 1))
    rounded = np.clip(strip.rows(model)[0].begins, begins, ends) - begins
    share = rounded / (ends - begins)
    return bool(np.quantile(share, 1.0 - _NARROW, axis=0).max() > _A_PIECE)


def _section_by_section(
    strip: RoundedStrip, found: Settled, fits: SideFits, lasts: np.ndarray
) -> tuple[RoundedFits, np.ndarray]:
    """Each section on its own points, and its neighbours' where these are too few."""
    model, expected = found.model, found.expected
    noise = strip.noise.mean(axis=1)
    for _ in range(2):
        own, mean = strip.summed(model, _OF_A_SECTION), expected.of_change(model.radius)
        unknown, covariance = solved(own, mean, expected.precision)
        borrowed = np.zeros(len(own))
        for width in _WIDER:
            extrapolated = np.maximum(covariance[:, 0, 0], covariance[:, 4, 4])
            thin = extrapolated > _THIN * noise**2
            if not thin.any() or width >= len(own) // 2:
                break
            more = solved(strip.pooled(own, width), mean, expected.precision)
            unknown[thin], covariance[thin] = more[0][thin], more[1][thin]
            borrowed[thin] = width
        model = stepped(strip, model, unknown)
    rows, off = strip.rows(model)
    both = np.stack([covariance[:, :4, :4], covariance[:, 4:8, 4:8]], axis=1)
    count = _points_of_sides(strip, (np.abs(off) < _OF_A_SECTION) & ~rows.on_arc, borrowed)
    firsts = np.searchsorted(BLOCK_EDGES, np.clip(rows.begins, 0.0, None))
    firsts = np.minimum(firsts, lasts - 1)
    variance = np.square(strip.noise)
    return (
        RoundedFits(
            reach=strip.reach,
            coefficients=model.coefficients,
            inverse=both / variance[..., None, None],
            variance=variance,
            count=count,
            stretch=np.stack([firsts, lasts], axis=-1),
            accepted=fits.accepted,
            astray=moved_by_last_block(strip, found.model, lasts),
            expectation=fits.expectation,
            radius=model.radius,
            joint=covariance,
            joint_shared=expected.shared(covariance),
        ),
        borrowed,
    )


def _points_of_sides(strip: RoundedStrip, used: np.ndarray, borrowed: np.ndarray) -> np.ndarray:
    """Number of points (m, 2) of each section's sides, those that it has borrowed among them."""
    bins = (strip.points.owner * 2 + strip.points.side)[used]
    own = np.bincount(bins, minlength=2 * len(borrowed)).reshape(-1, 2).astype(float)
    mode, count = "wrap" if strip.closed else "constant", own.copy()
    for width in np.unique(borrowed[borrowed > 0]).astype(int):
        asked = borrowed == width
        window = np.ones(2 * width + 1) / strip.counted
        count[asked] = convolve1d(own, window, axis=0, mode=mode)[asked]
    return count
