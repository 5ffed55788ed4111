# SPDX-License-Identifier: LGPL-2.1-or-later
"""Traces measured as whole edges, and whether what comes out is an edge that shows itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from ...cloud.point_cloud import PointCloud
from ..automatic import Chosen
from ..edge_checks import check_edge
from ..errors import ScanError
from ..patch_edge import finish_edge
from ..patch_scan import FEWEST_POINTS
from ..patch_section import PatchSettings
from ..report import describe
from ..scan_lines import ScanLines
from ..scanned_edge import ScannedEdge
from ..stop import Stop
from ..trace import Trace
from .corners import unsure

__all__ = ["finished", "part_of_trace", "parted_at_bend"]

_SURE = 0.4  # pitches, of the median sigma of an edge that is believed without a click
_BENT = 0.6  # rad, between the chords before and behind a place, that two edges may meet at
_BESIDE = 6.0  # pitches, of such a chord
_STANDS_OUT, _LEAST_NOISE = 11.0, 0.1  # times the noise, and pitches that it counts for at least


def finished(cloud: PointCloud, task: tuple[Trace, Chosen]) -> ScannedEdge | None:
    """The edge of a trace; None where there is none that shows itself."""
    trace, chosen = task
    if len(trace.stations) < FEWEST_POINTS:
        return None
    try:
        edge = finish_edge(cloud, trace, chosen)
        check_edge(edge, cloud, chosen)
    except ScanError:
        return None
    return _truly_ending(edge) if _sure(edge, chosen.settings) else None


def _truly_ending(edge: ScannedEdge) -> ScannedEdge:
    """The edge, with a corner only where it has found the vertex with a third surface.

    That a walk met points of neither side, or another edge, makes no corner yet.
    """
    start, end = (
        Stop.LOST if stop is Stop.CORNER and vertex is None else stop
        for stop, vertex in zip(edge.stops, edge.vertices, strict=True)
    )
    edge = replace(edge, stops=(start, end))
    return replace(edge, message=describe(edge, None))


def _sure(edge: ScannedEdge, settings: PatchSettings) -> bool:
    """Whether an edge shows itself, as nobody has clicked here.

    Its sides turn by the least angle, and it is not too short for how badly it is known.
    """
    if len(edge) < FEWEST_POINTS:
        return False
    turn = np.pi - float(np.median(edge.angle))
    if turn < settings.min_angle:
        return False
    # A kink stands out from the smooth surface that explains it best by a share of its turn times
    # the length of its sides; in noise, a bent surface looks like a small one. Where the sides
    # begin away from the edge, the turn between them is spread out, as that of a smooth surface is.
    if isinstance(edge.scan_lines, ScanLines):
        fits = edge.scan_lines.fits
        begins, ends = (np.median(each, axis=0) for each in (fits.begins, fits.ends))
        length = float(np.min(np.square(1.0 - begins / ends) * ends))
        noise = max(settings.noise, _LEAST_NOISE * settings.cloud_pitch)
        if turn * length < _STANDS_OUT * noise:
            return False
    known = _SURE * settings.cloud_pitch + unsure(edge, settings.cloud_pitch)
    return float(np.median(edge.own_sigma)) <= known


def part_of_trace(trace: Trace, edge: ScannedEdge, stretch: np.ndarray) -> Trace:
    """The stations of a walk that stand on a stretch of its edge."""
    places = np.array([station.frame.origin[0] for station in trace.stations])
    nearest = cKDTree(edge.points).query(places)[1]
    within = np.isin(nearest, stretch)
    stations = [trace.stations[row] for row in np.flatnonzero(within)]
    if trace.closed and len(within) and within[0] and within[-1] and not within.all():
        # It leads over the end of the closed walk.
        first = int(np.flatnonzero(~within)[-1]) + 1
        order = np.roll(np.arange(len(within)), -first)
        stations = [trace.stations[row] for row in order if within[row]]
    whole = 0 in stretch, len(edge) - 1 in stretch
    start, end = (
        stop if reaches and not trace.closed else Stop.CORNER
        for stop, reaches in zip(trace.stops, whole, strict=True)
    )
    return Trace(stations, (start, end))


def parted_at_bend(trace: Trace, pitch: float) -> list[Trace]:
    """A trace that is no edge in two parts, where it bends most; none where it hardly bends.

    Under a rounding a walk may have gone round a corner, from one edge to the next.

    Parameters
    ----------
    pitch : of the cloud, mm
    """
    if trace.closed or len(trace.stations) < 2 * FEWEST_POINTS:
        return []
    places = np.array([station.frame.origin[0] for station in trace.stations])
    at = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1)))
    wide = _BESIDE * pitch
    before, after = (
        np.stack([np.interp(at + shift, at, places[:, k]) for k in range(3)], axis=1)
        for shift in (-wide, wide)
    )
    chords = [places - before, after - places]
    one, other = (x / np.maximum(np.linalg.norm(x, axis=1, keepdims=True), 1e-12) for x in chords)
    inner = (at > wide) & (at < at[-1] - wide)
    turn = np.where(inner, np.arccos(np.clip(np.einsum("ki,ki->k", one, other), -1.0, 1.0)), 0.0)
    worst = int(turn.argmax())
    if turn[worst] < _BENT:
        return []
    left = trace.stations[: int(np.searchsorted(at, at[worst] - 0.5 * wide))]
    right = trace.stations[int(np.searchsorted(at, at[worst] + 0.5 * wide)) :]
    return [Trace(left, (trace.stops[0], Stop.CORNER)), Trace(right, (Stop.CORNER, trace.stops[1]))]
