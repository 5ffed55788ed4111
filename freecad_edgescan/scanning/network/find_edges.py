# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges of a cloud."""

from __future__ import annotations

import numpy as np

from ...cloud.point_cloud import PointCloud, require_surface
from ..automatic import MIN_ANGLE, choose_parameters
from ..errors import ScanError
from ..parameters import ScanParameters
from ..patch_section import PatchSettings
from ..scanned_edge import ScannedEdge
from .chains import chains_of
from .evidence import sections_on_edges
from .joining import bridged
from .sections import measure_sections
from .tracing import edge_of_track
from .tracks import Track, track_of

_FEWEST = 2

def find_edges(cloud: PointCloud, min_angle: float = MIN_ANGLE):
    require_surface(cloud)
    import time
    T=[time.process_time()]
    chosen = choose_parameters(cloud, cloud.points[len(cloud)//2], ScanParameters(cloud_pitch=cloud.pitch), min_angle)
    settings = chosen.settings
    sections = sections_on_edges(cloud, settings)
    T.append(time.process_time())
    tracks = [track_of(sections, chain) for chain in chains_of(sections.frames, cloud.pitch, _FEWEST)]
    T.append(time.process_time())
    tracks = bridged(cloud, tracks, settings)
    T.append(time.process_time())
    edges = []
    for track in tracks:
        try:
            edges.append(edge_of_track(cloud, track, chosen))
        except ScanError as error:
            print(len(track), error)
    T.append(time.process_time())
    print('evidence,chains,bridge,finish',np.diff(T), len(tracks))
    return edges
