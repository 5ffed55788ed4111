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
from .confirming import confirmed
from .tracing import Tracer
from .tracks import split_at_corners, track_of

_FEWEST = 2

def find_edges(cloud: PointCloud, min_angle: float = MIN_ANGLE):
    require_surface(cloud)
    import time
    T=[time.process_time()]
    chosen = choose_parameters(cloud, cloud.points[len(cloud)//2], ScanParameters(cloud_pitch=cloud.pitch), min_angle)
    settings = chosen.settings
    sections = sections_on_edges(cloud, settings)
    T.append(time.process_time())
    tracks = [
        part
        for chain in chains_of(sections.frames, cloud.pitch, _FEWEST)
        for part in split_at_corners(track_of(sections, chain))
    ]
    T.append(time.process_time())
    tracks = bridged(cloud, tracks, settings)
    T.append(time.process_time())
    n = len(tracks)
    tracks = confirmed(cloud, tracks, settings)
    T.append(time.process_time())
    tracer = Tracer(cloud, tracks, chosen)
    edges = [edge for number in range(len(tracks)) for edge in tracer.finish(number)]
    T.append(time.process_time())
    print('evidence,chains,bridge,confirm,finish',np.diff(T), n,len(tracks),len(edges))
    return edges
