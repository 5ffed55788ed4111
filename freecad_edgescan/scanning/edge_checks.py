# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether what was measured is an edge: known well enough, of two smooth sides that end at it."""

from __future__ import annotations

import numpy as np

from ..cloud.point_cloud import PointCloud
from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from .automatic import Chosen
from .corner import corners
from .errors import ScanError
from .fillet import gap_under_rounding
from .rounded_fits import RoundedFits
from .scan_lines import ScanLines
from .scanned_edge import ScannedEdge
from .side_fit import MOST_CURVED
from .sides_beyond import sides_beyond

__all__ = ["check_edge"]

_MUCH = 0.75  # of the edge points, that have to be known
_BESIDE = 1.2  # pitches: what an edge may be off its points besides where its sides begin
_CURLED, _BESIDE_CURLED = 0.5, 0.8  # rad by which both sides curl, and what it may be off then
# Pitches: what is seen of a side, below which it has to be smooth in most sections and not bend
# inwards as a rounding does (rad), and below which it is none.
_NARROW, _MOSTLY, _ROUND = 5.0, 0.5, 0.2
_LEAST_SIDE = 1.5


def check_edge(edge: ScannedEdge, cloud: PointCloud, chosen: Chosen) -> None:
    """Refuse what is no edge.

    Raises
    ------
    ScanError: it is known too badly; its sides come together far outside the points, are a
        rounding or narrow pieces of something that bends, or go on beyond the edge.
    """
    if not len(edge):
        return
    _check_known(edge, chosen)
    _check_beside_points(edge, cloud)
    _check_sides_are_no_rounding(edge)
    _check_smooth(edge, chosen)
    _check_sides_end(edge, cloud, chosen)


def _check_known(edge: ScannedEdge, chosen: Chosen) -> None:
    """An edge of which much is known worse than the cloud's pitch is none."""
    sigma = float(np.quantile(edge.own_sigma, _MUCH))
    pitch = chosen.settings.cloud_pitch
    if sigma > pitch:
        raise ScanError(
            f"What meets near ({place_text(edge.points[len(edge) // 2])}) is known only to "
            f"{plain(sigma, 3)} mm (one sigma), worse than the cloud's pitch of {plain(pitch, 3)} "
            "mm: the sides are too narrow, too curved or too noisy. Click elsewhere, "
            "or scan denser."
        )


def _check_beside_points(edge: ScannedEdge, cloud: PointCloud) -> None:
    """An edge farther from its points than its sides begin is that of two sides bent together.

    However a rounding, a chamfer or wear has taken an edge away, the sides' own first points are
    where they begin.
    """
    if not isinstance(edge.scan_lines, ScanLines):
        return
    lines, away = edge.scan_lines, float(np.median(edge.overhang))
    fits = lines.fits
    begins = float(np.median(fits.begins.min(axis=1)))
    middle = edge.points[len(edge) // 2]
    beside = cloud.points[cloud.tree.query(middle)[1]]
    pitch = float(cloud.local_pitch(beside[None])[0, 0])
    # Sides that curl towards each other have no edge but under a rounding that touches both. The
    # faces of a plate meet in no other way: sides that curl apart were nearer each other before.
    half = float(np.median(corners(lines.frames, fits).half_angle))
    rounded = float(gap_under_rounding(np.median(fits.begins.max(axis=1)), half))
    curled = float(np.median(fits.inward_curl.sum(axis=1))) > _CURLED
    if away > begins + _BESIDE * pitch or (curled and away > rounded + _BESIDE_CURLED * pitch):
        raise ScanError(
            f"The sides near ({place_text(middle)}) come together {plain(away, 3)} mm outside the "
            f"points, although they begin {plain(begins, 2)} mm from there: they are the two faces "
            "of something too thin for this pitch, and have no edge there. An edge needs sides of "
            "four pitches; click on a wider one, or scan denser."
        )


def _check_sides_are_no_rounding(edge: ScannedEdge) -> None:
    """Where a wide rounding in much noise ends, its arc and the side behind it seem to meet."""
    if not isinstance(edge.scan_lines, ScanLines):
        return
    fits = edge.scan_lines.fits
    bend = -float(np.median(fits.coefficients[..., 2], axis=0).min())
    if bend > MOST_CURVED:
        raise ScanError(
            f"One side near ({place_text(edge.points[len(edge) // 2])}) bends inwards on a radius "
            f"of {plain(fits.reach / bend, 2)} mm: it is a rounding, and no side. Click in the "
            "middle of the rounding, with an amplitude that reaches beyond it, or scan denser."
        )


def _check_smooth(edge: ScannedEdge, chosen: Chosen) -> None:
    """A narrow side that is no smooth surface is a piece of a rounding, or of several surfaces.

    What a wide one has of that is seen beside the rest of it, and moves the edge little.
    """
    if not isinstance(edge.scan_lines, ScanLines):
        return
    fits, pitch = edge.scan_lines.fits, chosen.settings.cloud_pitch
    if isinstance(fits, RoundedFits):  # the rounding has its part, and the sides have theirs
        return
    uneven = np.mean(fits.accepted, axis=0) < _MOSTLY
    bent = np.median(fits.inward_curl, axis=0) > _ROUND
    narrow = fits.seen < np.where(uneven | bent, _NARROW, _LEAST_SIDE) * pitch
    if np.any(narrow):
        raise ScanError(
            f"One side near ({place_text(edge.points[len(edge) // 2])}) is seen on "
            f"{plain(fits.seen[narrow].min(), 2)} mm only, and may be a piece of a rounding there. "
            "Click elsewhere along the edge, or scan denser."
        )


def _check_sides_end(edge: ScannedEdge, cloud: PointCloud, chosen: Chosen) -> None:
    """A surface that passes by the edge is no side of it."""
    if np.mean(sides_beyond(edge, cloud, chosen.settings)) > _MOSTLY:
        raise ScanError(
            f"One of the surfaces near ({place_text(edge.points[len(edge) // 2])}) goes on beyond "
            "where the other one would meet it: there is no edge. The other one may lie behind a "
            "thin wall: click nearer to the edge that you mean. Or a burr or a bead stands along "
            "the edge: take its points out of the cloud, and scan again."
        )
