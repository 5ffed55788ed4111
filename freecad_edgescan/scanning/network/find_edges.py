# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges of a cloud.

1. Sections where two smooth sides meet are found all over the cloud.
2. Sections that follow each other are put in order, and gaps between them are bridged.
3. Each track is led to its ends and measured as one edge; what belongs to another edge already,
   and what its evidence does not carry, is left out.
4. Edges that end near each other are joined in corners.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from ...cloud.point_cloud import PointCloud, require_surface
from ...cloud.region import cropped
from ..automatic import MIN_ANGLE, Chosen, choose_parameters
from ..errors import ScanError
from ..parameters import ScanParameters
from ..patch_section import PatchSettings
from ..progress import Progress
from ..scanned_edge import ScannedEdge
from .chains import chains_of
from .confirming import confirmed
from .edge_network import EdgeNetwork, network_of
from .evidence import sections_on_edges
from .joining import bridged
from .tracing import Tracer
from .tracks import Track, split_at_corners, track_of

__all__ = ["SHORTEST", "find_edges"]

_FEWEST = 2  # sections of a track
SHORTEST = 8.0  # pitches, of an edge, where no length is given
_LOOKING, _TRACKING = 0.35, 0.4  # share of the work that is done then
_REACH, _EDGE_PITCH, _LEAST_NOISE = 22.0, 2.0, 0.03  # pitches, as of a scan from a click
_STRAY = 0.5  # pitches of scatter along the normal, that no surface has


def find_edges(
    cloud: PointCloud,
    min_angle: float = MIN_ANGLE,
    min_length: float | None = None,
    progress: Progress | None = None,
    region: ArrayLike | None = None,
) -> EdgeNetwork:
    """Find all edges of a cloud, without a click.

    Parameters
    ----------
    cloud : the scanned points
    min_angle : least turn between the two sides of an edge, rad
    min_length : of an edge, mm; None: eight times the cloud's pitch
    progress : told the share that is done, and the edges so far as a list; where it answers False
        the search ends, and what was found until then is kept
    region : ((xmin, ymin, zmin), (xmax, ymax, zmax)), mm: only this box of the cloud is searched

    Returns
    -------
    EdgeNetwork; without edges where the cloud has none, and its message says so.

    Raises
    ------
    ScanError: an angle or a length that is none, or a region without points.
    ValueError: a cloud without a surface.
    """
    _check(min_angle, min_length)
    if region is not None:
        cloud = _cut_out(cloud, region)
    require_surface(cloud)
    shortest = SHORTEST * cloud.pitch if min_length is None else float(min_length)
    told = _Told(progress)
    chosen = _chosen(cloud, min_angle)
    if _scattered(cloud):
        return network_of(cloud, [], _no_surface(cloud))
    tracks = _tracks(cloud, chosen, told)
    edges: list[ScannedEdge] = []
    tracer = Tracer(cloud, tracks, chosen)
    for number in range(len(tracks)):
        share = number / len(tracks)
        if not told.update(_TRACKING + (1.0 - _TRACKING) * share, edges):
            break
        edges += [edge for edge in tracer.finish(number) if edge.length >= shortest]
    network = network_of(cloud, edges, _message(edges, shortest, told.cancelled), told.cancelled)
    told.update(1.0, edges)
    return network


def _check(min_angle: float, min_length: float | None) -> None:
    if not 0.0 < min_angle < np.pi:
        raise ScanError(f"The least angle is {min_angle!r}; give one between 0 and pi, in rad.")
    if min_length is not None and not 0.0 <= min_length < np.inf:
        raise ScanError(f"The least length is {min_length!r}; give 0 or a positive length in mm.")


def _cut_out(cloud: PointCloud, region: ArrayLike) -> PointCloud:
    try:
        return cropped(cloud, region)
    except ValueError as error:
        raise ScanError(str(error)) from None


def _chosen(cloud: PointCloud, min_angle: float) -> Chosen:
    """One set of parameters for all edges, which the cloud's own pitch and noise tell."""
    pitch = cloud.pitch
    chosen = choose_parameters(cloud, cloud.points[len(cloud) // 2], ScanParameters(), min_angle)
    probe = cloud.probe_radius
    amplitude, edge_pitch = 2.0 * (_REACH * pitch + probe), _EDGE_PITCH * pitch
    of_the_cloud = "the whole cloud's pitch"
    return Chosen(
        replace(chosen.parameters, amplitude=amplitude, edge_pitch=edge_pitch, cloud_pitch=pitch),
        {
            **chosen.reasons,
            "amplitude": f"{2.0 * _REACH:g} times {of_the_cloud}",
            "edge_pitch": f"{_EDGE_PITCH:g} times {of_the_cloud}",
            "cloud_pitch": of_the_cloud,
        },
        PatchSettings(
            0.5 * amplitude,
            edge_pitch,
            pitch,
            max(cloud.noise, _LEAST_NOISE * pitch),
            probe,
            min_angle,
        ),
    )


def _scattered(cloud: PointCloud) -> bool:
    return cloud.noise > _STRAY * cloud.pitch


def _no_surface(cloud: PointCloud) -> str:
    return (
        f"No edge was looked for: the points scatter by {cloud.noise:.3g} mm about their surface "
        f"and are {cloud.pitch:.3g} mm apart, so that no surface can be told from noise. If two "
        "scans were merged, align them first; else thin the cloud to a pitch of twice its noise."
    )


def _tracks(cloud: PointCloud, chosen: Chosen, told: _Told) -> list[Track]:
    """Tracks in order of confidence."""
    settings = chosen.settings
    sections = sections_on_edges(
        cloud, settings, tell=lambda share: told.update(_LOOKING * share, [])
    )
    if told.cancelled:
        return []
    tracks = [
        part
        for chain in chains_of(sections.frames, cloud.pitch, _FEWEST)
        for part in split_at_corners(track_of(sections, chain))
    ]
    tracks = bridged(cloud, tracks, settings)
    return confirmed(cloud, tracks, settings)


def _message(edges: list[ScannedEdge], shortest: float, cancelled: bool) -> str:
    if cancelled:
        return f"The search was cancelled; the {len(edges)} edges found until then are kept."
    if not edges:
        return (
            "No edge was found: the cloud is one smooth surface at the scale of its points, or its "
            f"edges turn by less than the least angle or are shorter than {shortest:.3g} mm."
        )
    length = sum(edge.length for edge in edges)
    return f"{len(edges)} edges of {length:.4g} mm in all were found."


class _Told:
    """Passes on how far the search is, and remembers that it was cancelled."""

    def __init__(self, progress: Progress | None) -> None:
        self.progress, self.cancelled = progress, False

    def update(self, fraction: float, so_far: object) -> bool:
        if self.progress is not None and not self.cancelled:
            self.cancelled = not self.progress.update(fraction, so_far)
        return not self.cancelled
