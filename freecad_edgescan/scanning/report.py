# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a finished scan tells a person: what happened, and what to try."""

from __future__ import annotations

import numpy as np

from ..geometry.plain_number import plain
from .scan_lines import ScanLines
from .scanned_edge import ScannedEdge
from .stop import Stop

_FAR_OUTSIDE = 3.0  # pitches
_BESIDE = 3.0  # pitches from a click to its edge, besides what a rounding takes away
_MOST_SCATTER = 0.5  # pitches, that no scanner's noise is
_ADVICE = {
    Stop.LOST: "try a larger amplitude, or click again beyond the place",
    Stop.SMOOTH: "the turn between the sides fell below the least angle",
    Stop.LIMIT: "raise the edge pitch, or scan on from there",
    Stop.CANCELLED: "what was found until then is kept",
    Stop.COLLISION: "raise the prehit distance, or lower the edge pitch",
    Stop.REPEATED_POINT: "raise the line pitch, or lower the amplitude",
    Stop.OFF_OBJECT: "the part or the cloud ends there, or a corner or a gap is near; "
    "a smaller amplitude or a larger search distance may help",
    Stop.NO_EDGE: "choose an amplitude that holds this one edge and no other",
    Stop.TOO_FEW_POINTS: "lower the line pitch, or raise the amplitude or the tolerance",
    Stop.CMM_FAILED: "what was found until then is kept",
}
_IGNORED = (
    "line_pitch",
    "tolerance",
    "degree",
    "pattern",
    "tangent",
    "steering",
    "compensation",
    "prehit_distance",
    "search_distance",
    "cloud_pitch",
)


def describe(edge: ScannedEdge, gate: object | None, clicked: np.ndarray | None = None) -> str:
    """Sentences about the edge's ends, its probe compensation, and parameters without effect.

    Parameters
    ----------
    clicked : (3,) mm, the place the edge was looked for at, where that was a click
    """
    sentences = [_ends(edge)]
    if clicked is not None and len(edge):
        away = float(np.linalg.norm(edge.points - clicked, axis=1).min())
        taken = 2.0 * float(np.median(edge.overhang)) if len(edge.overhang) else 0.0
        if away > _BESIDE * (edge.parameters.cloud_pitch or np.inf) + taken:
            sentences.append(f"It is {plain(away, 3)} mm from the place that was clicked.")
    for stop in dict.fromkeys(edge.stops):
        if stop in _ADVICE:
            sentences.append(f"{stop.name}: {_ADVICE[stop]}.")
    if gate is not None and edge.stops[1] is not Stop.GATE:
        sentences.append("The gate was not passed.")
    probe = edge.parameters.probe_radius
    if probe and edge.parameters.approach is None:
        kind = "an outer edge, rounded by the probe" if edge.convex else "a sharp inner edge"
        moved = probe / np.sin(0.5 * float(np.median(edge.angle)))
        sentences.append(
            f"The points count as centres of a ball of {probe:g} mm radius, and the rim as {kind}: "
            f"the edge lies {plain(moved, 3)} mm off where the sides through the points meet. If "
            "the points lie on the part itself, give no probe radius."
        )
    outside = float(np.median(edge.overhang)) if len(edge.overhang) else 0.0
    if outside > _FAR_OUTSIDE * (edge.parameters.cloud_pitch or np.inf):
        sentences.append(
            f"The two sides meet {plain(outside, 3)} mm outside the points: a rounding or wear has "
            "taken the edge away, or there never was a sharp one."
        )
    scatter, pitch = _scatter(edge), edge.parameters.cloud_pitch or np.inf
    if scatter > _MOST_SCATTER * pitch:
        sentences.append(
            f"The points scatter by {plain(scatter, 3)} mm about the sides and are "
            f"{plain(pitch, 3)} mm apart: the surface may be there twice (two scans that do not "
            "match, a thin wall), and then the edge is between the two, or worse than stated."
        )
    amplitude = edge.reasons.get("amplitude", "")
    if amplitude.startswith("given; "):
        given = plain(edge.parameters.amplitude or 0.0, 3)
        sentences.append(f"The amplitude of {given} mm was {amplitude}.")
    lent = int((~edge.supported).sum())
    if lent:
        sentences.append(
            f"{lent} of {len(edge)} edge points rest on their neighbours: the cloud has a gap "
            "there, or too little of a side looks smooth."
        )
    if edge.method == "probe":
        return " ".join(sentences)
    ignored = [name.replace("_", " ") for name in _IGNORED if edge.reasons.get(name) == "given"]
    if ignored:
        sentences.append(f"Without effect in the patch method: {', '.join(ignored)}.")
    return " ".join(sentences)


def _scatter(edge: ScannedEdge) -> float:
    """Median standard deviation of the points about the worse side, mm; 0 of a probe's lines."""
    if not isinstance(edge.scan_lines, ScanLines) or not len(edge):
        return 0.0
    fits = edge.scan_lines.fits
    return float(np.median(np.sqrt(fits.variance.max(axis=1))) * fits.reach)


def _ends(edge: ScannedEdge) -> str:
    size = f"{len(edge)} edge points, {plain(edge.length, 4)} mm"
    if edge.closed:
        return f"{size}; the edge is closed."
    start, end = edge.stops
    if start is end:
        return f"{size}; both ends {end.value}."
    if start is Stop.START:
        return f"{size}; from the start the walk {end.value}."
    return f"{size}; one end {start.value}, the other {end.value}."
