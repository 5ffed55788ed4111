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
from ...geometry.plain_number import plain
from ..automatic import MIN_ANGLE, Chosen, choose_parameters
from ..errors import ScanError
from ..least_angle import check_least_angle
from ..parameters import ScanParameters
from ..patch_section import PatchSettings
from ..progress import Progress
from ..scanned_edge import ScannedEdge
from .chains import chains_of
from .cloud_workers import CloudWorkers, jobs_for
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
    jobs: int | None = None,
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
    jobs : number of processes, which does not change the result; 1: this one; None: as many as
        the machine has cores, where the cloud is worth it

    Returns
    -------
    EdgeNetwork; without edges where the cloud has none, and its message says so.

    Raises
    ------
    ScanError: an angle, a length or a number of jobs that is none, or a region without points.
    ValueError: a cloud without a surface.
    """
    if not isinstance(cloud, PointCloud):
        raise ScanError(
            f"find_edges needs a PointCloud and was given {type(cloud).__name__}; make one with "
            "read_cloud(path) or PointCloud(points)."
        )
    _check(min_angle, min_length, jobs)
    if region is not None:
        cloud = _cut_out(cloud, region)
    require_surface(cloud)
    shortest = SHORTEST * cloud.pitch if min_length is None else float(min_length)
    told = _Told(progress)
    chosen = _chosen(cloud, min_angle)
    if _scattered(cloud):
        return network_of(cloud, [], _no_surface(cloud))
    edges: list[ScannedEdge] = []
    too_short: list[float] = []
    with CloudWorkers(cloud, jobs_for(cloud) if jobs is None else jobs) as workers:
        tracks = _tracks(workers, chosen, told)
        for share, found in Tracer(workers, tracks, chosen).edges():
            edges += [edge for edge in found if edge.length >= shortest]
            too_short += [edge.length for edge in found if edge.length < shortest]
            if not told.update(_TRACKING + (1.0 - _TRACKING) * share, edges):
                break
    # Shorter ones than are found without a least length are no edges.
    too_short = [length for length in too_short if length >= SHORTEST * cloud.pitch]
    message = _message(edges, shortest, too_short, told.cancelled)
    network = network_of(cloud, edges, message, told.cancelled)
    told.update(1.0, edges)
    return network


def _check(min_angle: float, min_length: float | None, jobs: int | None) -> None:
    check_least_angle(min_angle)
    if min_length is not None and not 0.0 <= min_length < np.inf:
        raise ScanError(f"The least length is {min_length!r}; give 0 or a positive length in mm.")
    if jobs is not None and not (isinstance(jobs, int) and jobs >= 1):
        raise ScanError(f"The number of jobs is {jobs!r}; give a positive integer, or None.")


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
        f"No edge was looked for: the points scatter by {plain(cloud.noise, 3)} mm about their "
        f"surface and are {plain(cloud.pitch, 3)} mm apart, so that no surface can be told from "
        "noise. If two scans were merged, align them first; else thin the cloud to a pitch of "
        "twice its noise."
    )


def _tracks(workers: CloudWorkers, chosen: Chosen, told: _Told) -> list[Track]:
    """Tracks in order of confidence."""
    settings = chosen.settings
    sections = sections_on_edges(
        workers, settings, tell=lambda share: told.update(_LOOKING * share, [])
    )
    if told.cancelled:
        return []
    tracks = [
        part
        for chain in chains_of(sections.frames, settings.cloud_pitch, _FEWEST)
        for part in split_at_corners(track_of(sections, chain))
    ]
    tracks = bridged(workers, tracks, settings)
    return confirmed(workers, tracks, settings)


def _message(
    edges: list[ScannedEdge], shortest: float, too_short: list[float], cancelled: bool
) -> str:
    if cancelled:
        return f"The search was cancelled; {_counted(edges)} found until then are kept."
    if not edges and too_short:
        return (
            f"No edge is long enough: {_counted(too_short)} {_were(too_short)} found, the longest "
            f"of {plain(max(too_short), 4)} mm, and the least length is {round(shortest, 3):g} mm. "
            "Give a smaller one."
        )
    if not edges:
        return (
            "No edge was found: the cloud is one smooth surface at the scale of its points, or "
            "its edges turn by less than the least angle or are shorter than "
            f"{round(shortest, 3):g} mm."
        )
    length = sum(edge.length for edge in edges)
    return f"{_counted(edges)} of {plain(length, 4)} mm in all {_were(edges)} found."


def _counted(edges: list[ScannedEdge] | list[float]) -> str:
    return f"{len(edges)} edge{'s' * (len(edges) != 1)}"


def _were(edges: list[ScannedEdge] | list[float]) -> str:
    return "was" if len(edges) == 1 else "were"


class _Told:
    """Passes on how far the search is, and remembers that it was cancelled."""

    def __init__(self, progress: Progress | None) -> None:
        self.progress, self.cancelled = progress, False

    def update(self, fraction: float, so_far: object) -> bool:
        if self.progress is not None and not self.cancelled:
            self.cancelled = not self.progress.update(fraction, so_far)
        return not self.cancelled
