# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces swept by profiles along one or two rails.

Two models. *blend* is that of Ueng, Lai and Doong 1998, Sweep-surface reconstruction from
three-dimensional measured data (Schreve eqs. 6.6.2.6 to 6.6.2.12): the profiles are only moved, and
blended from one end to the other. *rotate* carries the profiles in a frame that turns with the
rails and scales between them (Schreve eq. 6.6.2.1 with M from `rail_frame`); there may be profiles
between the ends, and one rail is enough.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicSpline

from ..geometry import BSplineCurve, BSplineSurface, compatible_curves
from ..geometry.knot_vectors import clamped_knots, merged_knots
from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from ..geometry.surface_approximation import approximated_surface
from .rail_frame import OneRailFrame, two_rail_frame
from .rail_pairing import RailPairing
from .self_crossing import self_crossing
from .sweep_joints import cut_to_profiles, distances_beside, in_order, refuse_crossing

__all__ = ["Pairing", "SweepModel", "SweptSurface"]

Array = NDArray[np.float64]

_DEGREE = 3
_SPANS = 8  # along paired rails, to begin with


class SweepModel(StrEnum):
    """How a profile changes along the rails."""

    BLEND = "blend"
    ROTATE = "rotate"


class Pairing(StrEnum):
    """Which points of two rails belong to one place: equal parameters, or those that face."""

    PARAMETER = "parameter"
    FACING = "facing"


@dataclass(frozen=True, eq=False)
class SweptSurface:
    """A surface swept along rails.

    u in [0, 1] runs along the rails and v in [0, 1] along the profiles, from the first rail (v = 0)
    to the second (v = 1).

    Parameters
    ----------
    rails : one or two open curves beside each other
    profiles : curves from the first rail to the second, in order; the outer ones at the rails' ends
    model : "blend" (two rails, two profiles) or "rotate"
    pairing : "parameter" or "facing"; by default facing points for *rotate*
    largest_gap : float
        How far, mm, a profile may end beside its rail. Its ends are moved onto the rails, and the
        points between by their share.
    cut_rails : bool
        Whether rails that go on beyond the outer profiles by more than that end where these do.

    Raises
    ------
    ValueError: rails and profiles that make no sweep, with the gaps between them.
    """

    rails: tuple[BSplineCurve, ...]
    profiles: tuple[BSplineCurve, ...]
    model: SweepModel = SweepModel.BLEND
    pairing: Pairing | None = None
    largest_gap: float = 1.0
    cut_rails: bool = False
    _done: tuple[str, ...] = field(default=(), init=False, repr=False)

    def __post_init__(self) -> None:
        if self.model not in list(SweepModel):
            raise ValueError(f"There is no sweep model {self.model!r}; choose blend or rotate.")
        model = SweepModel(self.model)
        pairing = self.pairing
        if pairing is None:
            pairing = Pairing.PARAMETER if model is SweepModel.BLEND else Pairing.FACING
        if pairing not in list(Pairing):
            raise ValueError(f"There is no pairing {pairing!r}; choose parameter or facing.")
        rails, profiles, said = in_order(self.rails, self.profiles)
        if self.cut_rails:
            rails, said_of_cut = cut_to_profiles(rails, profiles, self.largest_gap)
            said = *said, *said_of_cut
        if len(rails) == 2:
            refuse_crossing(rails, "rails")
        if model is SweepModel.BLEND and (len(rails) != 2 or len(profiles) != 2):
            raise ValueError(
                f"The blend model takes two rails and two profiles, not {len(rails)} and "
                f'{len(profiles)}; take model="rotate".'
            )
        for name, value in (
            ("rails", rails),
            ("profiles", profiles),
            ("model", model),
            ("pairing", Pairing(pairing)),
            ("_done", said),
        ):
            object.__setattr__(self, name, value)
        self._refuse_gaps()

    @cached_property
    def message(self) -> str:
        """What was done to bring rails and profiles together, and where the sweep goes wrong."""
        return " ".join((*self._done, *self._faults()))

    @cached_property
    def _pairs(self) -> RailPairing | None:
        if self.pairing is Pairing.PARAMETER or len(self.rails) == 1:
            return None
        return RailPairing(*self.rails)

    def _rail_parameters(self, u: Array) -> tuple[Array, Array]:
        return (u, u) if self._pairs is None else self._pairs(u)

    def _rail_points(self, u: Array) -> tuple[Array, ...]:
        at = self._rail_parameters(u)
        return tuple(rail.evaluate(t) for rail, t in zip(self.rails, at, strict=False))

    @cached_property
    def _one_rail_frame(self) -> OneRailFrame:
        return OneRailFrame(self.rails[0])

    def frames(self, u: ArrayLike) -> Array:
        """Frames (m, 3, 3) that carry the profile at places u (m,), mm; columns are the axes."""
        at = np.asarray(u, dtype=float)
        if len(self.rails) == 1:
            return self._one_rail_frame(at)
        first, second = self._rail_points(at)
        speeds = (np.ones_like(at),) * 2 if self._pairs is None else self._pairs(at, 1)
        one, other = (
            rail.derivative(t) * speed[:, None]
            for rail, t, speed in zip(self.rails, self._rail_parameters(at), speeds, strict=True)
        )
        return two_rail_frame(first, second, one + other)

    @cached_property
    def stations(self) -> Array:
        """Places u of the profiles along the rails."""
        if len(self.rails) == 2 and len(self.profiles) == 2:
            return np.array([0.0, 1.0])
        u = np.linspace(0.0, 1.0, 2001)
        first = self._rail_points(u)[0]
        curve = BSplineCurve(first, clamped_knots(u, 1), 1)
        at = []
        for profile in self.profiles:
            points = profile.evaluate(np.zeros(1)) if len(self.rails) == 2 else profile.sample(50)
            place, off = curve.closest(points)
            at.append(float(place[np.argmin(off)]))
        if np.any(np.diff(at) <= 1e-6):
            listed = ", ".join(f"{x:.3f}" for x in at)
            raise ValueError(
                f"Profiles must follow each other along the first rail; they lie at {listed} of "
                "it. Give them in order, at different places."
            )
        if len(self.rails) == 2:
            at[0], at[-1] = 0.0, 1.0
        return np.array(at)

    def _corners(self) -> Array:
        """Vectors (k, 2, 3) from the profiles' ends to their rails."""
        points = np.stack(self._rail_points(self.stations), axis=1)
        ends = np.stack([profile.evaluate(np.array([0.0, 1.0])) for profile in self.profiles])
        return np.asarray(points - ends)

    def _refuse_gaps(self) -> None:
        if len(self.rails) == 1:
            return
        gaps = np.linalg.norm(self._corners(), axis=2)
        if gaps.max() > self.largest_gap:
            listed = "; ".join(
                f"profile {k + 1}: {plain(start, 3)} and {plain(end, 3)} mm"
                for k, (start, end) in enumerate(gaps)
            )
            way = "Let the curves meet"
            beside = distances_beside(self.rails, self.profiles)
            if not self.cut_rails and beside.max() <= self.largest_gap:
                way = "Cut the rails, which go on beyond the profiles, by cut_rails (CutRails)"
            raise ValueError(
                f"Profiles and rails do not meet. Gaps at the first and second rail: {listed}. "
                f"{way}, or allow more than {self.largest_gap:g} mm by largest_gap (LargestGap)."
            )

    def _moved_profile(self, k: int, v: Array) -> Array:
        """Points (m, 3) of a profile whose ends were moved onto the rails."""
        points = self.profiles[k].evaluate(v)
        if len(self.rails) == 1:
            return points
        start, end = self._moves[k]
        return points + (1.0 - v[:, None]) * start + v[:, None] * end

    @cached_property
    def _moves(self) -> Array:
        return self._corners()

    def evaluate(self, u: ArrayLike, v: ArrayLike) -> Array:
        """Points at u and v, broadcast together: their shape plus (3,), mm."""
        u, v = np.broadcast_arrays(np.asarray(u, dtype=float), np.asarray(v, dtype=float))
        place = self._blended if self.model is SweepModel.BLEND else self._turned
        return place(np.clip(u.ravel(), 0.0, 1.0), np.clip(v.ravel(), 0.0, 1.0)).reshape(
            *u.shape, 3
        )

    def _blended(self, u: Array, v: Array) -> Array:
        """Eq. 6.6.2.6, whose blending functions α and β are linear."""
        scale = self.gamma(v)[:, None]
        one, other = self._moved_profile(0, v), self._moved_profile(1, v)
        u, v = u[:, None], v[:, None]
        result = (1.0 - u) * one + u * other
        at = self._rail_parameters(u[:, 0])
        for rail, t, share in zip(self.rails, at, (1.0 - v, v), strict=True):
            start, end = rail.evaluate(0.0), rail.evaluate(1.0)
            result += share * scale * (rail.evaluate(t) - (1.0 - u) * start - u * end)
        return result

    def gamma(self, v: ArrayLike) -> Array:
        """γ(v) of eq. 6.6.2.12: distance between the profiles relative to that of their ends."""
        v = np.asarray(v, dtype=float)
        both = np.concatenate([[0.0, 1.0], v.ravel()])
        apart = np.linalg.norm(self._moved_profile(0, both) - self._moved_profile(1, both), axis=1)
        ends = (1.0 - v) * apart[0] + v * apart[1]
        return np.asarray(apart[2:].reshape(v.shape) / ends)

    def local_profiles(self, v: ArrayLike) -> Array:
        """Profiles (k, m, 3) at v (m,) in the coordinates of their frames."""
        v = np.asarray(v, dtype=float)
        origins, frames = self._rail_points(self.stations)[0], self.frames(self.stations)
        points = np.stack([self._moved_profile(k, v) for k in range(len(self.profiles))])
        return np.linalg.solve(frames[:, None], (points - origins[:, None])[..., None])[..., 0]

    @cached_property
    def _shares(self) -> CubicSpline | None:
        """How much each profile counts at u: linear between two, a cubic through more."""
        if len(self.profiles) == 1:
            return None
        return CubicSpline(self.stations, np.eye(len(self.profiles)))

    def profile_shares(self, u: ArrayLike) -> Array:
        """Shares (m, k) of the profiles at places u (m,); they sum to 1."""
        u = np.asarray(u, dtype=float)
        if self._shares is None:
            return np.ones((len(u), 1))
        first, last = self.stations[[0, -1]]
        return np.asarray(self._shares(np.clip(u, first, last)))

    def _turned(self, u: Array, v: Array) -> Array:
        # grids repeat few values: the curves are asked once for each
        at_u, row = np.unique(u, return_inverse=True)
        at_v, column = np.unique(v, return_inverse=True)
        origins, frames = self._rail_points(at_u)[0], self.frames(at_u)
        shares, local = self.profile_shares(at_u), self.local_profiles(at_v)
        profile = np.einsum("mk,kmi->mi", shares[row.ravel()], local[:, column.ravel()])
        return origins[row.ravel()] + np.einsum("mij,mj->mi", frames[row.ravel()], profile)

    def _faults(self) -> tuple[str, ...]:
        """Whether sections run into each other, or the surface passes through itself."""
        u, v = np.linspace(0.0, 1.0, 101), np.linspace(0.0, 1.0, 21)
        grid = self.evaluate(u[:, None], v)
        step = np.diff(grid, axis=0)
        middle = (u[1:] + u[:-1]) / 2
        onwards = self.frames(middle)[..., 1]
        back = np.einsum("uvi,ui->uv", step, onwards) < 0.0
        if back.any():
            place = float(middle[np.argmax(back.sum(axis=1))])
            return (
                f"The sweep runs back on itself near u = {place:.2f}: its profiles are too wide "
                "for the rails' bend there.",
            )
        crossed = self_crossing(grid)
        if crossed is None:
            return ()
        where = place_text(grid[crossed])
        return (f"The sweep passes through itself near ({where}); shorten its rails there.",)

    def to_bspline(self, tolerance: float = 1e-3) -> BSplineSurface:
        """The sweep as a B-spline surface over the same parameters.

        Exact, within rounding, where the sweep is a polynomial spline over its curves' knots (the
        blend model between profiles of constant distance); otherwise within the tolerance, mm.
        """
        profiles = compatible_curves(self.profiles)
        degree = (
            max(_DEGREE, *(rail.degree for rail in self.rails)),
            max(_DEGREE, profiles[0].degree),
        )
        if self._pairs is None:
            raised = [rail.elevated(degree[0]).knots for rail in self.rails]
            along = merged_knots(raised, degree[0])
        else:
            along = clamped_knots(np.linspace(0.0, 1.0, _SPANS + 1), degree[0])
        across = profiles[0].elevated(degree[1]).knots
        return approximated_surface(self.evaluate, (along, across), degree, tolerance)
