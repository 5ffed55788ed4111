# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the cloud tells about an edge near a click: its two surfaces, its rounding, its points.

A short piece of the edge is measured with patches. They give the surfaces' curvature, the angle
and the rounding, which a probed scan has to know before it begins.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from .automatic import choose_parameters
from .errors import ScanError
from .first_contact import first_of_several
from .first_section import first_section, place_to_look
from .gait import AdaptiveGait
from .parameters import ScanParameters
from .patch_edge import finish_edge
from .patch_section import PatchSection
from .scan_lines import ScanLines
from .scanned_edge import ScannedEdge
from .section import Frames, SectionPoints
from .side_fit import SideFits
from .start import Start
from .surroundings import Surroundings
from .trace import Trace, turned
from .walker import walk

__all__ = ["EdgeSite", "measure_site"]

_LOOK = 4.0  # times what patches look at: on a wide rounding a short look finds a flat edge
_STEPS = 8  # of the short walk, each way
_PLACES = 40  # on each side, where the pitch is measured
_MARGIN = 2.0  # cloud pitches, of a line's end from the cloud's
_UNSEEN = 0.25  # of the noise: what a surface may rise over its length and be plane


@dataclass(frozen=True)
class EdgeSite:
    """A place on an edge and what was measured there.

    Attributes
    ----------
    frame : the one section at the place, of the cloud's own points
    room : how far along the surfaces, round the edge, both sides may be used together, mm
    around : the measured surroundings
    sigma : of an edge point measured with patches, both directions across the edge together, mm
    early : how far outside of the surfaces a virtual probe touches on the average, mm
    air : (3,) unit vector from the edge into the air, or out of the smaller wedge where the air
        is unknown
    """

    frame: Frames
    room: float
    around: Surroundings
    sigma: float
    early: float
    air: np.ndarray


def measure_site(
    cloud: PointCloud,
    at: Sequence[float] | np.ndarray | Start,
    given: ScanParameters,
    min_angle: float,
) -> EdgeSite:
    """Find the edge near a click or a start and measure it there.

    Parameters
    ----------
    at : where the user pointed, mm
    given : the probe and the amplitude in it are made use of
    min_angle : least turn between the two sides, rad

    Raises
    ------
    ScanError: no edge there, or no cloud there.
    """
    start = at if isinstance(at, Start) else None
    near = place_to_look(cloud, at, given)
    probe_only = ScanParameters(probe_radius=given.probe_radius, approach=given.approach)
    chosen = choose_parameters(cloud, near, probe_only, min_angle)
    short = chosen.settings.reach
    farthest = max(_LOOK * short, 0.5 * (given.amplitude or 0.0))
    wide = replace(chosen, settings=chosen.settings.with_reach(farthest))
    try:
        seed = first_section(cloud, near, start, wide)
    except ScanError:  # on narrow sides only a short look finds them
        seed, wide = first_section(cloud, near, start, chosen), chosen
    chosen = wide.with_seed(seed)
    settings, first = chosen.settings, seed.station
    section = PatchSection(cloud, settings)
    gait = AdaptiveGait(settings.edge_pitch, settings.half_width, settings.longest_step)
    onward = walk(section, first, gait, limit=_STEPS)
    backward = walk(section, turned(first), gait, limit=_STEPS)
    stations = [*(turned(s) for s in reversed(backward.stations)), first, *onward.stations]
    edge = finish_edge(cloud, Trace(stations, (backward.stop, onward.stop)), chosen)
    lines = edge.scan_lines
    if not isinstance(lines, ScanLines):
        raise TypeError("a scan with patches has patches")
    probe = chosen.parameters.probe_radius or 0.0
    frame = first.frame
    sides = _places(cloud, lines.points, min(short, settings.reach))
    pitch = given.cloud_pitch or max(_widest_pitch(cloud, side) for side in sides)
    smooth = float(np.median(lines.fits.ends, axis=0).min())
    room = min(seed.reach, _ends(lines.points), smooth)
    inner = edge.convex is False
    offset = -probe if inner else probe
    around = Surroundings(
        section_radius=_section_radius(lines.fits, room, settings.noise, offset),
        angle=float(np.median(edge.angle)),
        fillet_radius=_fillet_radius(edge),
        probe_radius=probe,
        cloud_pitch=pitch,
        noise_level=float(np.sqrt(3.0) * cloud.noise),
        convex=not inner,
    )
    outward = frame.normals[0].sum(axis=0) * (-1.0 if inner else 1.0)
    return EdgeSite(
        frame,
        2.0 * (room - _MARGIN * pitch - around.cut_off) + around.rounding,
        around,
        float(np.median(np.sqrt(np.trace(edge.covariance, axis1=1, axis2=2)))) / edge.reserve,
        first_of_several(pitch, cloud.pitch)[0] * cloud.noise,
        outward / np.linalg.norm(outward),
    )


def _places(cloud: PointCloud, points: SectionPoints, reach: float) -> list[np.ndarray]:
    """Points (k, 3) of each side half-way along the reach, mm.

    Neither a rounding nor the cloud's end disturbs there.
    """
    middle = np.abs(points.away - 0.5 * reach) < 0.25 * reach
    places = []
    for side in (0, 1):
        mine = points.side == side
        index = np.unique(points.index[mine & middle if np.any(mine & middle) else mine])
        places.append(cloud.points[index[:: max(len(index) // _PLACES, 1)]])
    return places


def _widest_pitch(cloud: PointCloud, places: np.ndarray) -> float:
    """Pitch in the direction in which points lie farthest apart, mm.

    Where they are strewn unevenly, the largest gap between them (Schreve 4.7.1).
    """
    pitch = float(np.nanmedian(cloud.local_pitch(places)[:, 0]))
    return max(pitch, cloud.largest_gap(places))


def _ends(points: SectionPoints) -> float:
    """How far from the edge there are points on both sides, mm."""
    ends = np.zeros((points.owner.max() + 1, 2))
    np.maximum.at(ends, (points.owner, points.side), points.away)
    return float(np.median(ends, axis=0).min())


def _section_radius(fits: SideFits, room: float, noise: float, offset: float) -> float:
    """Radius across the edge of the more bent one of the two surfaces of the part, mm.

    Infinite where neither departs from a plane by more than a fraction of the noise.
    """
    curvature = np.median(fits.coefficients[..., 2] / fits.reach, axis=0)
    strongest = float(curvature[np.argmax(np.abs(curvature))])
    if abs(strongest) * room**2 < 8.0 * _UNSEEN * noise:
        return float(np.inf)
    return 1.0 / strongest + offset


def _fillet_radius(edge: ScannedEdge) -> float:
    """Radius of the rounding where most of the sections have one, mm; 0 otherwise."""
    known = np.isfinite(edge.fillet_radius)
    return float(np.median(edge.fillet_radius[known])) if known.mean() > 0.5 else 0.0
