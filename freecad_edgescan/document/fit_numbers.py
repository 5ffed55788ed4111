# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a fitted surface says of its fit, as properties."""

from __future__ import annotations

from typing import Any

from ..surfacing import SurfaceFit
from ..surfacing.support import supported_share
from .computed_object import result

__all__ = ["FIT_RESULTS", "write_fit_numbers"]

FIT_RESULTS = (
    result("Length", "Average", "Mean absolute deviation of the points from the surface"),
    result("Length", "Maximum", "Largest absolute deviation of a point from the surface"),
    result("Length", "RootMeanSquare", "Root mean square deviation of the points"),
    result("Integer", "PointCount", "Number of points the surface was fitted to; 0: to none"),
    result("Integer", "OutsideCount", "Number of points beyond the surface's rim, left out"),
    result("Percent", "Supported", "Share of the surface's area where there are points enough"),
)


def write_fit_numbers(obj: Any, fit: SurfaceFit | None) -> None:
    """Write them; None: the surface was not fitted to points."""
    obj.Average = 0.0 if fit is None else fit.average
    obj.Maximum = 0.0 if fit is None else fit.maximum
    obj.RootMeanSquare = 0.0 if fit is None else fit.rms
    obj.PointCount = 0 if fit is None else int((~fit.outside).sum())
    obj.OutsideCount = 0 if fit is None else int(fit.outside.sum())
    obj.Supported = 0 if fit is None else round(100.0 * supported_share(fit.surface, fit.supported))
