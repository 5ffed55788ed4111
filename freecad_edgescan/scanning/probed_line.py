# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was touched on one line across an edge: its two sections and where they meet.

A line is brought into a plane, split at the point farthest from its chord, cleaned of what was
touched on a rounding, and each section is fitted by a polynomial of low degree (Schreve 4.3).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..geometry.polynomial_curve import meeting_parameters
from .line_section import LineSection, line_section
from .probe_settings import ProbeSettings
from .sharpness import MISSED, UNKNOWN, Sharpness
from .stop import Stop

__all__ = ["ProbedLine", "farthest_from_chord", "measure_line", "without_rounding"]

_CLEAR = 0.6  # line pitches from the edge, within which there are contacts only where it is narrow
_AS_WELL = 1.5  # times what a section's own points lie off its curve, at most
_EXACT = 1e-6  # line pitches
_DRAWN_OUT = 1.5  # of a section's length: how far its curve stands for the surface


@dataclass(frozen=True)
class ProbedLine:
    """A line across the edge.

    Attributes
    ----------
    contacts : (n, 3) mm, in the order of travel
    origin, axes : (3,) mm and (2, 3) unit vectors: the plane its points were brought into
    ruling : (3,) unit vector along which they were moved there
    drift : a, b, c, x0: along the ruling the line ran at a + b·x + c·|x - x0|, mm; a line that is
        not square to the edge has a kink there
    sections : on the two surfaces of the edge, always in the same order
    meeting : parameters of the two curves where they meet
    ends_on : which of the two surfaces the line ended on
    narrow : whether it was scanned over an edge known as sharp, with contacts close to it
    split_off : line pitches that the point it was split at lies beside the nearer section
    sharpness : what this line and those before it have shown of the edge
    """

    contacts: np.ndarray
    origin: np.ndarray
    axes: np.ndarray
    ruling: np.ndarray
    drift: tuple[float, float, float, float]
    sections: tuple[LineSection, LineSection]
    meeting: tuple[float, float]
    ends_on: int
    narrow: bool = False
    split_off: float = np.inf
    sharpness: Sharpness = UNKNOWN

    def place(self, xy: np.ndarray) -> np.ndarray:
        """Points (…, 3) mm where the line ran, at coordinates (…, 2) of the plane."""
        a, b, c, x0 = self.drift
        along = a + b * xy[..., 0] + c * np.abs(xy[..., 0] - x0)
        return self.origin + xy @ self.axes + along[..., None] * self.ruling

    @property
    def edge_point(self) -> np.ndarray:
        """Where the two curves meet, (3,) mm; the probe radius is not taken off."""
        return self.place(self.sections[0].curve.at(self.meeting[0]))

    @property
    def rough_sides(self) -> np.ndarray:
        """Unit vectors along the two sections at their ends near the edge, away from it, (2, 3)."""
        ways = np.array([-s.curve.derivative(1.0) for s in self.sections]) @ self.axes
        return ways / np.linalg.norm(ways, axis=1, keepdims=True)

    def wedge_side(self, k: int) -> float:
        """1 when the smaller wedge lies to the left of curve k on its way to the edge, else -1."""
        way = self.sections[k].curve.derivative(1.0)
        left = np.array([-way[1], way[0]]) @ self.axes
        return 1.0 if left @ self.rough_sides[1 - k] > 0.0 else -1.0

    def length(self, k: int) -> float:
        """Of section k over its contacts, to the middle of the gap in which the edge lies, mm."""
        own, other = self.sections[k].points, self.sections[1 - k].points
        steps = np.linalg.norm(np.diff(own, axis=0), axis=1)
        return float(steps.sum() + 0.5 * np.linalg.norm(own[-1] - other[-1]))

    @property
    def bent_edge_point(self) -> np.ndarray:
        """Where curves of a higher degree meet, (3,) mm; without a rounding they come closer."""
        first, second = (section.leading_curve() for section in self.sections)
        met = meeting_parameters(first, second)
        return self.edge_point if met is None else self.place(first.at(met[0]))

    def end(self, k: int) -> np.ndarray:
        """The end of section k nearest the edge, (3,) mm, on its curve."""
        return self.place(self.sections[k].curve.at(1.0))

    def level_with(self, point: np.ndarray, k: int) -> np.ndarray:
        """The place on the curve of section k that is closest to a point (3,) mm."""
        curve = self.sections[k].curve
        seen = (point - self.origin) @ self.axes.T
        u = float(curve.closest(seen[None], np.ones(1))[0])
        return self.place(curve.at(min(max(u, 0.0), _DRAWN_OUT)))


def measure_line(
    contacts: np.ndarray,
    origin: np.ndarray,
    tangent: np.ndarray,
    across: np.ndarray,
    starts_on: int,
    settings: ProbeSettings,
    wedge: np.ndarray | None = None,
    narrow: bool = False,
) -> ProbedLine | Stop:
    """Find the edge on a scanned line.

    Parameters
    ----------
    contacts : (n, 3) mm
    origin : (3,) mm, near the edge
    tangent : (3,) unit vector, along the edge as far as it is known
    across : (3,) unit vector in the direction of travel
    starts_on : which of the two surfaces the line begins on
    wedge : (3,) a direction into the smaller wedge of the two surfaces, when it is known
    narrow : whether the edge was known as sharp, and contacts were taken close to it

    Returns
    -------
    the line, or why it shows no edge
    """
    if len(contacts) < 5:
        return Stop.TOO_FEW_POINTS
    if settings.safeguards.slide:
        normal = tangent
    else:
        origin = contacts.mean(axis=0)
        normal = np.linalg.svd(contacts - origin, full_matrices=False)[2][2]
    x = across - (across @ normal) * normal
    x = x / np.sqrt(x @ x)
    y = np.array(
        [
            normal[1] * x[2] - normal[2] * x[1],
            normal[2] * x[0] - normal[0] * x[2],
            normal[0] * x[1] - normal[1] * x[0],
        ]
    )
    axes = np.array([x, y])
    offset = contacts - origin
    points = offset @ axes.T
    if _straight(points, settings.least_turn):
        return Stop.NO_EDGE
    ways = [0.0]
    if settings.safeguards.signed_split:
        ways = [1.0, -1.0] if wedge is None else [1.0 if wedge @ axes[1] > 0.0 else -1.0]
    found: list[_Halves] = []
    for way in ways:
        halves = _halves(points, farthest_from_chord(points, way), settings, narrow)
        if halves is not None:
            found.append(halves)
    if not found:
        return Stop.TOO_FEW_POINTS
    best = min(found, key=lambda halves: halves.miss)
    if best.meeting is None:
        return Stop.NO_EDGE
    (first, second), met = best.sections, best.meeting
    if starts_on == 1:
        first, second, met = second, first, (met[1], met[0])
    drift = 0.0, 0.0, 0.0, 0.0
    if settings.safeguards.slide:
        edge_at = first.curve.at(met[0])[0]
        drift = _drift(points[:, 0], offset @ normal, float(edge_at))
    off = best.off / settings.line_pitch
    if narrow and off > MISSED:
        # The contacts that have shown the rounding lie on it.
        aside = np.linalg.norm(points - points[best.split], axis=1)
        (clear,) = np.nonzero(aside > _CLEAR * settings.line_pitch)
        line = measure_line(contacts[clear], origin, tangent, across, starts_on, settings, wedge)
        return line if isinstance(line, Stop) else _of_all_contacts(line, contacts, clear, off)
    sections = first, second
    return ProbedLine(
        contacts, origin, axes, normal, drift, sections, met, 1 - starts_on, narrow, off
    )


def _of_all_contacts(
    line: ProbedLine, contacts: np.ndarray, used: np.ndarray, off: float
) -> ProbedLine:
    """A narrow line that was measured with some of its contacts only."""
    first, second = (replace(section, contacts=used[section.contacts]) for section in line.sections)
    return replace(line, contacts=contacts, sections=(first, second), narrow=True, split_off=off)


@dataclass(frozen=True)
class _Halves:
    """Both sections of a split line, where they meet, and how far from the split that is.

    `split` is the number of the point it is split at, `off` how far (mm) that one lies beside the
    section that leads to it.
    """

    split: int
    sections: tuple[LineSection, LineSection]
    meeting: tuple[float, float] | None
    miss: float
    off: float


def _halves(
    points: np.ndarray, split: int, settings: ProbeSettings, narrow: bool
) -> _Halves | None:
    order = np.arange(len(points))
    sections = []
    for part in (order[:split], order[:split:-1]):
        section = line_section(part, points[part], settings)
        if section is None:
            return None
        sections.append(section)
    beside = [section.lead_to(points[split]) for section in sections]
    k = int(np.argmin(beside))
    if narrow:
        sections[k] = _with_split(sections[k], beside[k], split, points[split], settings)
    first, second = sections
    met = meeting_parameters(first.curve, second.curve)
    miss = np.inf if met is None else np.linalg.norm(first.curve.at(met[0]) - points[split])
    return _Halves(split, (first, second), met, float(miss), beside[k])


def _with_split(
    section: LineSection, off: float, split: int, point: np.ndarray, settings: ProbeSettings
) -> LineSection:
    """The section and the point that its line is split at, if that goes on with it."""
    if off > _AS_WELL * np.abs(section.residuals()).max() + _EXACT * settings.line_pitch:
        return section  # it lies on a rounding, even if the tolerance would let it pass
    order = np.append(section.contacts, split)
    longer = line_section(order, np.vstack([section.points, point]), settings)
    return section if longer is None or not longer.kept[-1] else longer


def without_rounding(
    line: ProbedLine, edge: np.ndarray, begins: Sequence[float], settings: ProbeSettings
) -> ProbedLine:
    """The same line without the points of both sides that lie nearer to the edge than they begin.

    Parameters
    ----------
    edge : (3,) mm, the edge
    begins : of the two sides, mm from the edge

    Returns
    -------
    the line, or the old one where too little would be left of it
    """
    middle, sections = (edge - line.origin) @ line.axes.T, []
    for section, begin in zip(line.sections, begins, strict=True):
        away = np.linalg.norm(section.points - middle, axis=1)
        count = int(np.count_nonzero(np.minimum.accumulate(away) >= begin))
        if count == len(away):
            sections.append(section)
            continue
        left = line_section(section.contacts[:count], section.points[:count], settings)
        if left is None or left.curve.degree < section.curve.degree:
            return line
        kept = np.zeros(len(away), dtype=bool)
        kept[:count] = left.kept
        sections.append(replace(section, kept=kept, curve=left.curve))
    met = meeting_parameters(sections[0].curve, sections[1].curve)
    if met is None:
        return line
    return replace(line, sections=(sections[0], sections[1]), meeting=met)


def farthest_from_chord(points: np.ndarray, wedge: float = 0.0) -> int:
    """Where to split a line: at the point farthest from its chord (Schreve 4.3.2).

    On strongly curved sides some point of a side may be farther from the chord than the edge is.
    The edge stands out of the smaller wedge, the sides' bellies do not.

    Parameters
    ----------
    points : (n, 2) coordinates in the plane of the line
    wedge : 1 when the smaller wedge lies on the side of y, -1 on the other, 0 when unknown
    """
    chord = points[-1] - points[0]
    offset = points - points[0]
    off = chord[0] * offset[:, 1] - chord[1] * offset[:, 0]
    if wedge:
        return int((-wedge * np.sign(chord[0]) * off).argmax())
    return int(np.abs(off).argmax())


def _straight(points: np.ndarray, least_turn: float) -> bool:
    """Whether no point stands out of the chord as an edge would (Schreve figure 4.22).

    An edge in the middle stands out by half the chord times the tangent of half its turn; one
    that lies far from the middle by less, for which a quarter of that is left.
    """
    chord, offset = points[-1] - points[0], points - points[0]
    off = np.abs(chord[0] * offset[:, 1] - chord[1] * offset[:, 0])
    return bool(off.max() < 0.125 * np.tan(0.5 * least_turn) * (chord @ chord))


def _drift(x: np.ndarray, along: np.ndarray, x0: float) -> tuple[float, float, float, float]:
    """Two straight lines with a kink at x0 through how far along the edge the points lie."""
    terms = np.stack([np.ones_like(x), x, np.abs(x - x0)])
    a, b, c = np.linalg.solve(terms @ terms.T + 1e-12 * np.eye(3), terms @ along)
    return float(a), float(b), float(c), float(x0)
