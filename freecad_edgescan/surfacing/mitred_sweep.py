# SPDX-License-Identifier: LGPL-2.1-or-later
"""A profile moved along a rail with corners: every piece of the rail ends in a mitre.

The profile is carried rigidly by frames that turn as little as they can, so along a plane rail it
keeps its angle to the plane. At a corner each of its points goes on straight, along the rail's
tangent, as far as the plane that halves the corner. From both sides it gets to the same place
there, so that neighbours share their rim exactly, without any intersection of surfaces.

All this is affine in the profile's points at any station. So the poles of the profile are moved;
its weights and knots stay. Along a straight piece the surface is exact. Along a curved one it
interpolates sections, and where a corner's inner side takes some of the curve away, the rim is off
the surface of the uncut curve by s²/2R: s is taken away, R the rail's radius of curvature.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_interp_spline

from ..geometry import BSplineCurve, BSplineSurface
from ..geometry.frames import turned_along, unit
from ..geometry.place_text import place_text
from .rail_frame import OneRailFrame

__all__ = ["MitredSweep", "mitred_sweep"]

Array = NDArray[np.float64]

_SHARPEST = np.deg2rad(120.0)  # of a corner; a mitre is as long as tan(turn / 2)
_STRAIGHT = 1e-9  # of the tangents' change
_TOLERANCE = 1e-4  # mm, of a surface between its sections; OpenCASCADE's pipes have the same
_HALVINGS = 12  # of the stretches between the rail's knots
_GAUSS = 0.5 + np.array([-0.5, 0.5]) / np.sqrt(3.0)
_SAMPLES = 64  # on each curve of a profile
_FADING = 0.25  # share of a curved piece over which a mitre fades out, at least
_STEEP = 6.0  # lengths of what a mitre moves, over which it fades out, at least


@dataclass(frozen=True)
class MitredSweep:
    """What a profile leaves.

    Attributes
    ----------
    surfaces : for each piece of the rail one for each curve of the profile; u runs along the
        profile, v along the rail
    first, last : the profile's curves at both ends of the rail
    closed : whether the rail ends where it begins
    """

    surfaces: tuple[tuple[BSplineSurface, ...], ...]
    first: tuple[BSplineCurve, ...]
    last: tuple[BSplineCurve, ...]
    closed: bool


def mitred_sweep(
    profile: Sequence[BSplineCurve], rail: Sequence[BSplineCurve], closed: bool = False
) -> MitredSweep:
    """Move a profile along pieces of a rail that follow each other.

    Parameters
    ----------
    profile : curves that follow each other, mm, where the profile stands beside the rail
    rail : curves that follow each other, in one direction
    closed : whether the last of them ends where the first begins

    Raises
    ------
    ValueError: a corner that is too sharp, or a profile that has no room in it or lies along the
        rail.
    """
    pieces = _with_frames([_Piece(curve.opened().over_range(0.0, 1.0)) for curve in rail], closed)
    samples = np.concatenate([curve.sample(_SAMPLES) for curve in profile])
    to_local = _standing(pieces, _centre(profile), samples)
    local = to_local(samples)
    if np.linalg.svd(local[:, [0, 2]] - local[0, [0, 2]])[1][0] < 1e-6 * np.abs(local).max():
        raise ValueError("The profile lies along the rail; let it stand across the rail.")
    poles = [to_local(curve.poles) for curve in profile]
    cuts = np.cumsum([len(own) for own in poles])[:-1]
    surfaces = []
    for number, piece in enumerate(pieces):
        ends = _mitres(pieces, number, closed)
        knots, moved = _sections(piece, ends, np.concatenate(poles), local)
        degree = 3 if len(moved) > 2 else 1
        surfaces.append(
            tuple(
                BSplineSurface(
                    own.transpose(1, 0, 2),
                    (curve.knots, knots),
                    (curve.degree, degree),
                    None
                    if curve.weights is None
                    else np.repeat(curve.weights[:, None], len(own), axis=1),
                )
                for curve, own in zip(profile, np.split(moved, cuts, axis=1), strict=True)
            )
        )
    return MitredSweep(
        tuple(surfaces),
        tuple(surface.curve_at(v=0.0) for surface in surfaces[0]),
        tuple(surface.curve_at(v=1.0) for surface in surfaces[-1]),
        closed,
    )


class _Piece:
    """A smooth piece of the rail over [0, 1], with frames whose columns are second axis, tangent
    and third axis; these turn by `turn` and, along the piece, by `twist` more.
    """

    def __init__(self, curve: BSplineCurve) -> None:
        self.curve, self.length = curve, curve.length()
        self._frames = OneRailFrame(curve)
        self.turn = self.twist = 0.0
        tangents = curve.tangent(np.linspace(0.0, 1.0, _SAMPLES))
        self.straight = bool(np.abs(tangents - tangents[0]).max() < _STRAIGHT)

    def at(self, share: Array) -> tuple[Array, Array]:
        """Places (m, 3) and frames (m, 3, 3) at shares of the length."""
        u = np.clip(self.curve.parameters_at_length(share * self.length), 0.0, 1.0)
        u[share <= 0.0], u[share >= 1.0] = 0.0, 1.0
        frames = self._frames(u)
        angle = (self.turn + share * self.twist)[:, None]
        second, along, third = frames.transpose(2, 0, 1)
        axes = (
            np.cos(angle) * second + np.sin(angle) * third,
            along,
            np.cos(angle) * third - np.sin(angle) * second,
        )
        return self.curve.evaluate(u), np.stack(axes, axis=-1)

    def shares(self, u: Array) -> Array:
        """Shares of the length (m,) at parameters (m,)."""
        until = [self.curve.restricted(0.0, one).length() if one > 0.0 else 0.0 for one in u]
        return np.clip(np.array(until) / self.length, 0.0, 1.0)

    def end(self, last: bool) -> tuple[Array, Array]:
        """Place (3,) and frame (3, 3) at one of the ends."""
        place, frame = self.at(np.array([float(last)]))
        return place[0], frame[0]


def _with_frames(pieces: list[_Piece], closed: bool) -> list[_Piece]:
    """Let each piece's frames go on from those of the piece before it."""
    pairs = list(zip(pieces, pieces[1:] + pieces[:1], strict=True))
    off = 0.0
    for before, after in pairs if closed else pairs[:-1]:
        place, frame = before.end(True)
        wanted = frame.T[None]
        turn = np.arccos(np.clip(frame[:, 1] @ after.end(False)[1][:, 1], -1.0, 1.0))
        if turn > _SHARPEST:
            raise ValueError(
                f"The rail turns by {np.degrees(turn):.0f}° at ({place_text(place)}); a mitre "
                f"needs {np.degrees(_SHARPEST):.0f}° or less. Sweep along both sides of that "
                "corner by themselves."
            )
        own = after.end(False)[1].T
        wanted = turned_along(wanted, frame[None, :, 1], own[None, 1])[0]
        off = float(np.arctan2(wanted[0] @ own[2], wanted[0] @ own[0]))
        if after is not pieces[0]:
            after.turn += off
    if closed:
        # What the frames have turned by on the way round is undone little by little.
        whole = sum(piece.length for piece in pieces)
        done = 0.0
        for piece in pieces:
            piece.turn -= off * done / whole
            piece.twist = -off * piece.length / whole
            done += piece.length
    return pieces


def _standing(pieces: list[_Piece], centre: Array, samples: Array) -> Callable[[Array], Array]:
    """What turns places (k, 3) into those of the rail's frame where the profile stands.

    That is beside its centre; near a corner it is on the side across which the profile lies less
    deep.
    """
    best = (np.inf, np.zeros(3), np.eye(3))
    for piece in pieces:
        u, off = piece.curve.closest(centre[None])
        place, frame = (one[0] for one in piece.at(piece.shares(u)))
        deep = float(np.abs((samples - place) @ frame[:, 1]).max())
        best = min(best, (float(off[0]) + deep, place, frame), key=lambda one: one[0])
    _, place, frame = best
    return lambda places: (places - place) @ frame


def _centre(profile: Sequence[BSplineCurve]) -> Array:
    """Centre of mass (3,) of the profile's curves."""
    steps = [curve.sample(_SAMPLES) for curve in profile]
    middle = np.concatenate([0.5 * (own[1:] + own[:-1]) for own in steps])
    size = np.concatenate([np.linalg.norm(np.diff(own, axis=0), axis=1) for own in steps])
    return np.asarray(size @ middle / size.sum())


def _mitres(pieces: list[_Piece], number: int, closed: bool) -> tuple[_Mitre | None, _Mitre | None]:
    """How a piece meets the one before it and the one after it."""
    before = pieces[number - 1] if number or closed else None
    after = pieces[(number + 1) % len(pieces)] if number + 1 < len(pieces) or closed else None
    own = pieces[number]
    return (
        None if before is None else _Mitre(before.end(True), own.end(False)),
        None if after is None else _Mitre(own.end(True), after.end(False)),
    )


class _Mitre:
    """The section in which two pieces meet."""

    def __init__(self, before: tuple[Array, Array], after: tuple[Array, Array]) -> None:
        self._sides = before, after
        self._normal = unit(before[1][:, 1] + after[1][:, 1])

    def __call__(self, local: Array) -> Array:
        """Where the profile's points (k, 3) come to; the mean of both, should the pieces gape."""
        sides = []
        for place, frame in self._sides:
            away, along = local @ frame.T, frame[:, 1]
            on = away - (away @ self._normal / (along @ self._normal))[:, None] * along
            sides.append(place + on)
        return np.asarray(0.5 * (sides[0] + sides[1]))


def _sections(
    piece: _Piece, ends: tuple[_Mitre | None, _Mitre | None], poles: Array, samples: Array
) -> tuple[Array, Array]:
    """Knots along the piece, and poles (m, k, 3) of the curves on which the profile's poles move.

    Its samples are those that must have room: a circle's poles stand far out of it.
    """
    local, seen = np.concatenate([poles, samples]), len(poles)
    moved = [
        np.zeros_like(local) if mitre is None else (mitre(local) - place) @ frame - local
        for mitre, (place, frame) in zip(ends, (piece.end(False), piece.end(True)), strict=True)
    ]
    # A straight piece is ruled, unless the frames turn about it by so much that this is narrower.
    ruled = piece.straight and np.abs(samples).max() * piece.twist**2 / 8.0 < _TOLERANCE
    fading = [1.0 if ruled else _fading(piece, own[seen:]) for own in moved]
    if ruled:
        share = np.array([0.0, 1.0])
        sections = _moved(piece, moved, fading, local, share)
        _require_room(piece, sections[:, seen:], share)
        return np.array([0.0, 0.0, 1.0, 1.0]), sections[:, :seen]
    # The frames bend as smoothly as the rail's tangent: at its knots only once.
    own_knots = piece.shares(np.unique(piece.curve.knots))
    breaks = np.unique(np.concatenate([own_knots, [fading[0], 1.0 - fading[1]]]))
    breaks = breaks[np.diff(breaks, prepend=-1.0) > 1e-6]
    breaks[-1] = 1.0
    for _ in range(_HALVINGS):
        knots = np.concatenate([[0.0, 0.0], np.repeat(breaks, 2), [1.0, 1.0]])
        share = (breaks[:-1, None] + np.diff(breaks)[:, None] * _GAUSS).ravel()
        share = np.concatenate([[0.0], share, [1.0]])
        sections = _moved(piece, moved, fading, local, share)
        spline = make_interp_spline(share, sections, k=3, t=knots, axis=0)
        between = 0.5 * (breaks[1:] + breaks[:-1])
        truth = _moved(piece, moved, fading, local, between)
        error = np.abs(spline(between) - truth).max(axis=(1, 2))
        if error.max() < _TOLERANCE:
            _require_room(piece, sections[:, seen:], share)
            return np.asarray(spline.t), np.asarray(spline.c[:, :seen])
        breaks = np.sort(np.concatenate([breaks, between[error >= _TOLERANCE]]))
    raise ValueError(
        f"The rail bends too sharply within one of its edges: the sweep would be {error.max():.2g} "
        "mm off. Split that edge where it bends, or sweep along a shorter piece."
    )


def _fading(piece: _Piece, moved: Array) -> float:
    """Share of a piece over which what a mitre moves fades out, from an end of the piece."""
    steep = _STEEP * np.abs(moved).max() / piece.length
    return float(min(1.0, max(steep, _FADING)))


def _moved(
    piece: _Piece, moved: list[Array], fading: list[float], local: Array, share: Array
) -> Array:
    """Places (m, k, 3) of points (k, 3) at shares of a piece's length."""
    place, frame = piece.at(share)
    points = np.broadcast_to(local, (len(share), *local.shape)).copy()
    for own, over, left in zip(moved, fading, (share, 1.0 - share), strict=True):
        fade = np.clip(1.0 - left / over, 0.0, None)
        if over < 1.0:
            fade = fade**3
        points += fade[:, None, None] * own
    return np.asarray(place[:, None] + np.einsum("mij,mkj->mki", frame, points))


def _require_room(piece: _Piece, sections: Array, share: Array) -> None:
    """Refuse a surface some of which would run backwards."""
    place, frame = piece.at(0.5 * (share[1:] + share[:-1]))
    onwards = np.einsum("mki,mi->mk", np.diff(sections, axis=0), frame[:, :, 1]).min(axis=1)
    worst = int(np.argmin(onwards))
    if onwards[worst] <= 0.0:
        raise ValueError(
            f"The profile is too wide for the rail near ({place_text(place[worst])}): the piece "
            "between two corners is too short for it, or bends too tightly. Take a smaller "
            "profile, or another piece of the rail."
        )
