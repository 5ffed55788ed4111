# SPDX-License-Identifier: LGPL-2.1-or-later
"""The direction of the edge from the last two probed lines (Schreve 4.4.1)."""

from __future__ import annotations

import numpy as np

from ..geometry.frames import cross
from .parameters import Tangent
from .probe_settings import ProbeSettings
from .probed_line import ProbedLine

__all__ = ["edge_tangent"]


def edge_tangent(
    line: ProbedLine,
    before: ProbedLine,
    known: np.ndarray,
    settings: ProbeSettings,
) -> np.ndarray:
    """Unit tangent of the edge at a line, (3,).

    Parameters
    ----------
    line, before : this line and one behind it
    known : (3,) unit vector, the direction so far; it tells forward from backward, and the
        safeguards do not let the new one turn away too far
    settings : which of the three methods, and the safeguards
    """
    safeguards = settings.safeguards
    if settings.tangent is Tangent.INTERPOLATION:
        tangent = line.edge_point - before.edge_point  # Schreve eq. 4.4.1.1.1
    else:
        if settings.tangent is Tangent.PLANES:
            normals = [_plane_normal(line, before, k) for k in range(2)]
        else:
            level = safeguards.level_ends
            normals = [_surface_normal(line, before, k, level) for k in range(2)]
        tangent = cross(normals[0], normals[1])  # Schreve eq. 4.4.1.3.1, up to sign
    size = float(np.linalg.norm(tangent))
    if size < 1e-9:
        return known
    tangent = tangent / size
    if tangent @ known < 0.0:
        tangent = -tangent
    tangent = _turned_at_most(known, tangent, safeguards.largest_turn)
    tangent = (1.0 - safeguards.smoothing) * tangent + safeguards.smoothing * known
    return np.asarray(tangent / np.linalg.norm(tangent))


def _surface_normal(line: ProbedLine, before: ProbedLine, k: int, level: bool) -> np.ndarray:
    """Normal of surface k from both lines' curves (Schreve eq. 4.4.1.3.2), up to sign."""
    end = line.end(k)
    beside = before.level_with(end, k) if level else before.end(k)
    normal = cross(line.rough_sides[k], end - beside)
    return np.asarray(normal / np.linalg.norm(normal))


def _plane_normal(line: ProbedLine, before: ProbedLine, k: int) -> np.ndarray:
    """Normal of the plane through both lines' points of surface k (Schreve 4.4.1.2)."""
    points = np.vstack(
        [each.contacts[each.sections[k].contacts[each.sections[k].kept]] for each in (line, before)]
    )
    centred = points - points.mean(axis=0)
    return np.asarray(np.linalg.eigh(centred.T @ centred)[1][:, 0])


def _turned_at_most(known: np.ndarray, tangent: np.ndarray, largest: float) -> np.ndarray:
    cosine = float(known @ tangent)
    if cosine >= np.cos(largest):
        return tangent
    aside = tangent - cosine * known
    size = max(float(np.linalg.norm(aside)), 1e-300)
    return np.asarray(np.cos(largest) * known + np.sin(largest) / size * aside)
