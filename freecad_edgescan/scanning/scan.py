# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan an edge: from a cloud or a machine, and a click or a start, to edge points."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..cloud.point_cloud import PointCloud, require_surface
from .automatic import MIN_ANGLE
from .cmm import Cmm
from .errors import ScanError
from .least_angle import check_least_angle
from .parameters import ScanParameters
from .patch_scan import scan_with_patches
from .probe_scan import scan_with_cmm, scan_with_probe
from .progress import Progress
from .scanned_edge import ScannedEdge
from .start import Gate, Start

__all__ = ["METHODS", "scan_edge"]

METHODS = ("patch", "probe")
_MACHINE = ("probe_radius", "approach", "move", "touch")

Point = Sequence[float] | np.ndarray


def scan_edge(
    cloud: PointCloud | Cmm,
    at: Point | Start,
    gate: Point | Gate | None = None,
    parameters: ScanParameters | None = None,
    method: str | None = None,
    min_angle: float = MIN_ANGLE,
    progress: Progress | None = None,
) -> ScannedEdge:
    """Scan the edge near a click, or from a start to a gate.

    Parameters
    ----------
    cloud : the scanned points, or a measuring machine that touches the part itself
    at : a point near the edge (mm): the edge is walked both ways until it ends; or a `Start`,
        which a machine needs
    gate : where to stop: a `Gate`, or a point to walk to
    parameters : what is None in them is chosen from the cloud; a machine needs the amplitude
    method : "patch" uses all the points on both sides; "probe" touches the cloud line by line
        like a measuring machine. None: patch for a cloud, probe for a machine
    min_angle : least turn between the two sides, rad
    progress : told about the edge points as they are found; may cancel

    Returns
    -------
    ScannedEdge, also when the walk could not go on: `stops` and `message` say why it ended.

    Raises
    ------
    ScanError: nothing to scan here, or parameters that cannot work; the text says what to do.
    ValueError: a cloud without a surface.
    """
    wanted = parameters or ScanParameters()
    if method is not None and method not in METHODS:
        raise ScanError(f"The method is {method!r}; choose 'patch' or 'probe'.")
    check_least_angle(min_angle)
    if isinstance(cloud, PointCloud):
        require_surface(cloud)
        if method == "probe":
            return scan_with_probe(cloud, at, gate, wanted, min_angle, progress)
        return scan_with_patches(cloud, at, gate, wanted, min_angle, progress)
    if not isinstance(cloud, Cmm):
        wanting = [name for name in _MACHINE if not hasattr(cloud, name)]
        what = f", which has no {', '.join(wanting)}" if len(wanting) < len(_MACHINE) else ""
        raise ScanError(
            f"scan_edge needs a PointCloud or a measuring machine and was given "
            f"{type(cloud).__name__}{what}; make a cloud with read_cloud(path) or "
            "PointCloud(points), or give the machine what a Cmm has."
        )
    if method == "patch":
        raise ScanError("A measuring machine has no points for patches; use method='probe'.")
    return scan_with_cmm(cloud, at, gate, wanted, min_angle, progress)
