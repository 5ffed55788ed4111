# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cloud that a command's options name: from its unit to mm, and only what is in a region."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from freecad_edgescan.terminal_progress import TerminalProgress, tell

if TYPE_CHECKING:
    from freecad_edgescan.cloud import PointCloud

__all__ = ["UNITS", "cloud_of"]

UNITS = ("mm", "m", "inch")
SMALLEST_PART = 1.0  # mm; a scanned part is larger


def cloud_of(options: argparse.Namespace) -> PointCloud:
    """Read the file, its coordinates brought from their unit (None: not named, mm) to mm.

    Region and probe radius are mm whatever the unit of the file.

    Raises
    ------
    KeyboardInterrupt: Ctrl-C was pressed; half a cloud is none to go on with.
    """
    from freecad_edgescan.cloud import read_cloud
    from freecad_edgescan.geometry.plain_number import plain

    with TerminalProgress("reading") as progress:
        cloud = read_cloud(
            options.file,
            getattr(options, "probe_radius", 0.0),
            getattr(options, "approach", None),
            region=options.region,
            progress=_ShareOnly(progress),
            unit=options.unit or "mm",
        )
    if progress.cancelled:
        raise KeyboardInterrupt
    unsure = options.unit is None and options.region is None  # a box may be as small as wanted
    small = unsure and 0.0 < (across := float(cloud.size.max())) < SMALLEST_PART
    if small and _has_surface(cloud):  # else what it lacks is the reason, and told by whoever asks
        tell(
            f"{options.file} is only {plain(across, 3)} mm across; is the file in metres? "
            "If so, give --unit m (or --unit inch)."
        )
    return cloud


def _has_surface(cloud: PointCloud) -> bool:
    from freecad_edgescan.cloud import require_surface

    try:
        require_surface(cloud)
    except ValueError:
        return False
    return True


class _ShareOnly:
    """Tells how far reading is, and not what was read: a terminal has no use for points."""

    def __init__(self, progress: TerminalProgress) -> None:
        self._progress = progress

    def update(self, fraction: float, _so_far: object) -> bool:
        return self._progress.update(fraction, None)
