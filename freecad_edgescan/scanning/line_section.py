# SPDX-License-Identifier: LGPL-2.1-or-later
"""One side of a scan line: cleaned of what was touched on a rounding, and fitted (Schreve 4.3)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry.polynomial_curve import PolynomialCurve, fit_polynomial
from .probe_settings import ProbeSettings

__all__ = ["LineSection", "clean", "line_section"]

_LEADING = 3  # degree of the curve that a section is drawn out by
_SPARE = 2  # points beyond those a curve needs, that hold the tolerance for a reason


@dataclass(frozen=True)
class LineSection:
    """The part of a line on one side of the edge.

    Attributes
    ----------
    contacts : (n,) index of its contacts in the line, from far away towards the edge
    points : (n, 2) the same in the line's plane, mm
    kept : (n,) False where a point was cleaned away
    curve : through the kept points; its parameter is 1 at the one nearest the edge
    """

    contacts: np.ndarray
    points: np.ndarray
    kept: np.ndarray
    curve: PolynomialCurve

    def residuals(self) -> np.ndarray:
        """Distances of the kept points from the curve, mm, positive to its left."""
        points = self.points[self.kept]
        u = self.curve.closest(points, np.linspace(0.0, 1.0, len(points)))
        way, off = self.curve.derivative(u), points - self.curve.at(u)
        across = way[:, 0] * off[:, 1] - way[:, 1] * off[:, 0]
        return np.asarray(across / np.hypot(way[:, 0], way[:, 1]))

    def leading_curve(self) -> PolynomialCurve:
        """Through the kept points, of a degree that leads on beyond them, however it is bent."""
        points = self.points[self.kept]
        return fit_polynomial(points, min(_LEADING, len(points) - 1))[0]

    def lead_to(self, point: np.ndarray) -> float:
        """How far beside the leading curve a point (2,) beyond the section's end lies, mm."""
        curve = self.leading_curve()
        u = curve.closest(point[None], np.ones(1))
        return float(np.linalg.norm(curve.at(u)[0] - point))


def line_section(
    order: np.ndarray, points: np.ndarray, settings: ProbeSettings
) -> LineSection | None:
    """Clean one section and fit its curve; None when too few points are left."""
    safeguards, tolerance = settings.safeguards, settings.tolerance
    if len(points) < 2:
        return None
    degree = min(settings.degree, len(points) - 1)  # Schreve 4.7.3
    quadratic = safeguards.quadratic_cleaning and degree == 1 and len(points) > 3
    curve, near = clean(points, 2 if quadratic else degree, tolerance, safeguards.spare_points)
    far = 0
    if quadratic:
        curve, u = fit_polynomial(points[:near], 1)
        if safeguards.near_points:
            while near - far > 3 and not _within(curve, points[far:near], u, tolerance):
                far += 1
                curve, u = fit_polynomial(points[far:near], 1)
    kept = np.zeros(len(points), dtype=bool)
    kept[far:near] = True
    return LineSection(order, points, kept, curve)


def clean(
    points: np.ndarray, degree: int, tolerance: float, spare: bool = False
) -> tuple[PolynomialCurve, int]:
    """Give up points from the edge's end until the rest lies within the tolerance (Schreve 4.3.3).

    Parameters
    ----------
    points : (n, 2) mm, the last one nearest the edge; n > degree
    degree : of the curve
    tolerance : mm
    spare : where only so few points hold the tolerance that they may do so by chance, to take
        those points instead after which giving up more did not make the curve fit better

    Returns
    -------
    the curve, and how many of the points are kept
    """
    count, best = len(points), None
    while True:
        curve, u = fit_polynomial(points[:count], degree)
        off = curve.at(curve.closest(points[:count], u)) - points[:count]
        worst = float(np.einsum("ni,ni->n", off, off).max())
        freedom = count - degree - 1
        if worst <= tolerance**2 and (freedom >= _SPARE or not spare or best is None):
            return curve, count
        if spare and freedom > 0:
            scatter = float(np.einsum("ni,ni->", off, off)) / freedom
            if best is None or scatter < 0.7 * best[0]:
                best = scatter, curve, count
        if count == degree + 1:
            return (curve, count) if best is None else best[1:]
        count -= 1


def _within(curve: PolynomialCurve, points: np.ndarray, u: np.ndarray, tolerance: float) -> bool:
    off = curve.at(curve.closest(points, u)) - points
    return bool(np.einsum("ni,ni->n", off, off).max() <= tolerance**2)
