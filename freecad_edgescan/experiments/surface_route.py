# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edge of test 2S1.11 by way of its surfaces: extended, intersected, compared with the circle.

Schreve 6.5.2. The published average is 0.086 mm with the fitted surfaces of appendix I, to which
the scanner's 0.094 mm was compared. Those surfaces as printed come to 0.107 mm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..geometry import BSplineSurface
from ..surfacing import SurfaceIntersection, extend_surface, fit_surface, intersect_surfaces
from .doe_design import trial
from .published_surfaces import PublishedSurface, published_surface

__all__ = ["SurfaceRoute", "published_route", "surface_route"]

_REACH = 8.0  # mm, of the cloud to both sides of the edge


@dataclass(frozen=True, eq=False)
class SurfaceRoute:
    """The intersection of two extended surfaces and its distances from the true edge, mm."""

    curve: SurfaceIntersection
    average: float
    maximum: float


def published_route() -> SurfaceRoute:
    """The surfaces fitted and printed in appendix I, extended by a quarter and intersected."""
    return _route(
        published_surface(PublishedSurface.OUTER), published_surface(PublishedSurface.INNER)
    )


def surface_route(
    control_points: tuple[int, int] = (8, 4), seed: int | Sequence[int] = 0
) -> SurfaceRoute:
    """Our own: both faces of a cloud like that of the test, not offset by a probe, fitted.

    Parameters
    ----------
    control_points : of both surfaces, along the edge and across it
    seed : anything ``numpy.random.default_rng`` takes
    """
    row = trial(2, 11)
    part = replace(row.object, probe_radius=0.0)
    cloud = part.cloud(row.cloud_pitch, _REACH, row.noise, seed)
    outer, inner = (
        fit_surface(cloud.points[cloud.labels == label], published_surface(base), control_points)
        for label, base in ((0, PublishedSurface.OUTER_BASE), (1, PublishedSurface.INNER_BASE))
    )
    return _route(outer.surface, inner.surface)


def _route(outer: BSplineSurface, inner: BSplineSurface) -> SurfaceRoute:
    curve = intersect_surfaces(extend_surface(outer, "v1"), extend_surface(inner, "v0"))[0]
    row = trial(2, 11)
    x, y, z = curve.points.T
    error = np.hypot(np.hypot(x, y) - row.edge_radius, z + row.section_radius)
    return SurfaceRoute(curve, float(error.mean()), float(error.max()))
