# SPDX-License-Identifier: LGPL-2.1-or-later
"""Taking the probe radius off probed edge points (Schreve 4.5), in four ways.

Each way answers an edge point for every line. The lines j - 1, j and j + 1 take part; the first
and the last line have one neighbour only and are compensated as curves in their own plane.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry.frames import cross
from ..geometry.polynomial_curve import OffsetCurve, fit_polynomial, meeting_parameters
from .probed_line import ProbedLine

__all__ = ["compensated_curves", "cut_of_ruled_surfaces", "from_compensated_points"]

_STEP = 1e-4  # of a curve, for its derivative


def compensated_curves(line: ProbedLine, distance: float) -> np.ndarray | None:
    """Edge point with the two curves offset in the line's own plane (Schreve 4.5.3).

    Parameters
    ----------
    line : a probed line
    distance : mm, of the surfaces from the probe's centres: positive into the smaller wedge of
        the two sides, where the material of a convex edge is

    Returns
    -------
    (3,) mm, or None when the offset curves do not meet
    """
    curves = [
        OffsetCurve(section.curve, distance * line.wedge_side(k))
        for k, section in enumerate(line.sections)
    ]
    met = meeting_parameters(curves[0], curves[1])
    return None if met is None else line.place(curves[0].at(met[0]))


def from_compensated_points(
    before: ProbedLine, line: ProbedLine, after: ProbedLine, distance: float
) -> np.ndarray | None:
    """Edge point with every point offset along its own normal (Schreve 4.5.2).

    The normal is read off the neighbouring points of the line and the nearest ones of the lines
    beside it, eq. 4.5.2.1 and 4.5.2.2, and takes over all their noise.
    """
    curves = []
    for k, section in enumerate(line.sections):
        contacts = line.contacts[section.contacts[section.kept]]
        along = np.gradient(contacts, axis=0)
        beside = _nearest(after, k, contacts) - _nearest(before, k, contacts)
        normals = cross(along, beside)
        normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        into = -line.rough_sides[1 - k]
        outward = np.where(normals @ into < 0.0, -1.0, 1.0)[:, None]
        moved = contacts - distance * outward * normals
        points = (moved - line.origin) @ line.axes.T
        curves.append(fit_polynomial(points, min(section.curve.degree, len(points) - 1))[0])
    met = meeting_parameters(curves[0], curves[1])
    return None if met is None else line.place(curves[0].at(met[0]))


def cut_of_ruled_surfaces(
    lines: Sequence[ProbedLine], j: int, distance: float
) -> np.ndarray | None:
    """Edge point of line j between the compensated curves of its neighbours, as printed.

    The curves of lines j - 1 and j + 1 span a ruled surface on each side, and the plane across
    the edge at line j cuts it (Schreve eq. 4.5.4.1 to 4.5.4.5, with the sign of 4.5.4.5 put
    right). The rulings are chords of the edge, so that the edge point lies its sagitta
    ρe² κe / 2 inside of a bend.

    Parameters
    ----------
    lines : of the walk, in order
    j : number of the line, neither the first nor the last
    distance : see `compensated_curves`
    """
    line, rails = lines[j], []
    normals = [_between(lines, j, k, np.array([1.0]))[0] for k in range(2)]
    tangent = cross(normals[0], normals[1])
    tangent = tangent / np.linalg.norm(tangent)
    origin = 0.5 * (line.end(0) + line.end(1))  # eq. 4.5.4.2
    first = line.rough_sides[0] - (line.rough_sides[0] @ tangent) * tangent
    first = first / np.linalg.norm(first)
    axes = np.array([first, cross(tangent, first)])
    for k in range(2):
        pair = [_Compensated(lines, i, k, distance) for i in (j - 1, j + 1)]
        rails.append(_Cut(pair[0], pair[1], origin, tangent, axes))
    met = meeting_parameters(rails[0], rails[1])
    return None if met is None else origin + rails[0].at(met[0]) @ axes


class _Compensated:
    """Section k of line i, moved along the surface's normals (Schreve eq. 4.5.4.3)."""

    def __init__(self, lines: Sequence[ProbedLine], i: int, k: int, distance: float) -> None:
        self.lines, self.i, self.k, self.distance = lines, i, k, distance

    def at(self, u: np.ndarray) -> np.ndarray:
        line = self.lines[self.i]
        points = line.place(line.sections[self.k].curve.at(u))
        return points - self.distance * _between(self.lines, self.i, self.k, u)


@dataclass(frozen=True)
class _Cut:
    """The ruled surface between two compensated curves, cut by a plane (Schreve eq. 4.5.4.5)."""

    before: _Compensated
    after: _Compensated
    origin: np.ndarray
    tangent: np.ndarray
    axes: np.ndarray

    @property
    def degree(self) -> int:
        return 2  # not straight

    def at(self, u: np.ndarray | float) -> np.ndarray:
        where = np.atleast_1d(np.asarray(u, dtype=float))
        start, end = self.before.at(where), self.after.at(where)
        share = ((self.origin - start) @ self.tangent) / ((end - start) @ self.tangent)
        cut = (start + share[:, None] * (end - start) - self.origin) @ self.axes.T
        return cut if np.ndim(u) else cut[0]

    def derivative(self, u: np.ndarray | float) -> np.ndarray:
        u = np.asarray(u, dtype=float)
        return (self.at(u + _STEP) - self.at(u - _STEP)) / (2.0 * _STEP)


def _between(lines: Sequence[ProbedLine], j: int, k: int, u: np.ndarray) -> np.ndarray:
    """Normals (n, 3) of surface k on line j, out of the smaller wedge (Schreve eq. 4.5.4.1)."""
    line = lines[j]
    before, after = lines[max(j - 1, 0)], lines[min(j + 1, len(lines) - 1)]
    beside = after.place(after.sections[k].curve.at(u)) - before.place(
        before.sections[k].curve.at(u)
    )
    normals = cross(line.sections[k].curve.derivative(u) @ line.axes, beside)
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    outward = np.where(normals @ line.rough_sides[1 - k] > 0.0, -1.0, 1.0)
    return np.asarray(outward[:, None] * normals)


def _nearest(line: ProbedLine, k: int, points: np.ndarray) -> np.ndarray:
    """The contacts of a line's section k nearest to points (n, 3)."""
    mine = line.contacts[line.sections[k].contacts]
    gap = np.linalg.norm(points[:, None] - mine[None], axis=2)
    return np.asarray(mine[gap.argmin(axis=1)])
