# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a track to the finished edge: its ends found, and all its sections measured together."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...cloud.point_cloud import PointCloud
from ..automatic import Chosen
from ..edge_ends import led_to_vertex
from ..errors import ScanError
from ..gait import AdaptiveGait
from ..patch_edge import finish_edge
from ..patch_scan import FEWEST_POINTS, check_edge
from ..patch_section import PatchSection, PatchSettings
from ..report import describe
from ..scanned_edge import ScannedEdge
from ..section import Station
from ..stop import Stop
from ..trace import Trace, turned
from ..walker import walk
from .tracks import Track

__all__ = ["edge_of_track"]

_BEYOND = 12.0  # pitches past the last section, where a vertex is looked for before walking there
_CAREFUL = 0.7  # edge pitches, of a step where an edge seems to end
_FEWEST = 4  # stations that lead to a vertex


def edge_of_track(cloud: PointCloud, track: Track, chosen: Chosen) -> ScannedEdge:
    """The finished edge of a track.

    Parameters
    ----------
    chosen : its parameters and settings

    Raises
    ------
    ScanError: there is no edge, or it is not known well enough.
    """
    settings = chosen.settings
    stations = track.stations()
    if track.closed:
        trace = Trace(stations, (Stop.CLOSED, Stop.CLOSED))
    else:
        stations, end = _to_the_end(cloud, stations, settings)
        if end is Stop.CLOSED:
            trace = Trace(stations, (end, end))
        else:
            outward = [turned(station) for station in reversed(stations)]
            outward, start = _to_the_end(cloud, outward, settings)
            stations = [turned(station) for station in reversed(outward)]
            trace = Trace(stations, (start, end))
    if len(trace.stations) < FEWEST_POINTS:
        raise ScanError("Too few sections of an edge follow each other.")
    edge = finish_edge(cloud, trace, chosen)
    check_edge(edge, cloud, chosen)
    return replace(edge, message=describe(edge, None))


def _to_the_end(
    cloud: PointCloud, stations: list[Station], settings: PatchSettings
) -> tuple[list[Station], Stop]:
    """Stations on to where the edge ends ahead: a vertex, or where walking on is not possible."""
    if len(stations) >= _FEWEST:
        led = led_to_vertex(cloud, stations, settings, _BEYOND * settings.cloud_pitch)
        if led is not None:
            return led, Stop.CORNER
    pitch = settings.edge_pitch
    gait = AdaptiveGait(pitch, settings.half_width, _CAREFUL * pitch)
    section = PatchSection(cloud, settings)
    onward = walk(section, stations[-1], gait, behind=stations[:-1])
    return [*stations, *onward.stations], onward.stop
