# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published surfaces of appendices H and I beside ours, as text."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineSurface
from ..scanning import Progress
from ..surfacing import extend_surface
from .doe_design import trial
from .doe_result import PATCH
from .doe_scan import edge_errors, scan_trial, trial_cloud
from .published_surfaces import PublishedSurface, published_surface
from .surface_route import published_route, surface_route

__all__ = ["at_the_joint", "surface_tables"]

_SEEDS = 5


def surface_tables(progress: Progress | None = None) -> str:
    """Extension of appendix H, and the edge of test 2S1.11 by way of surfaces and by scanning.

    Parameters
    ----------
    progress : told the share that is done; where it answers False the text ends there
    """
    lines = _extension()
    lines += ["", "edge of test 2S1.11: distance from the circle R 35, mm   average  maximum"]

    def row(name: str, average: float, maximum: float) -> None:
        lines.append(f"{name:<54} {average:8.3f} {maximum:8.3f}")

    printed = published_route()
    row("surfaces of appendix I as printed (published: 0.086)", printed.average, printed.maximum)
    ours = []
    for seed in range(_SEEDS):
        if progress is not None and not progress.update(seed / (_SEEDS + 1), "test 2S1.11"):
            return "\n".join(lines)
        ours.append(surface_route(seed=seed))
    row(
        f"our fits to {_SEEDS} such clouds, extended, intersected",
        float(np.mean([own.average for own in ours])),
        max(own.maximum for own in ours),
    )
    test = trial(2, 11)
    for name, method, group in (
        (f"{_SEEDS} clouds scanned line by line (published: 0.094)", "probe", ("zigzag", 2)),
        (f"{_SEEDS} clouds scanned with all points", *PATCH[:1], PATCH),
    ):
        scanned = [
            edge_errors(test, scan_trial(test, trial_cloud(test, seed), group, method).points)
            for seed in range(_SEEDS)
        ]
        row(
            name,
            float(np.mean([own.mean() for own in scanned])),
            max(float(own.max()) for own in scanned),
        )
    return "\n".join(lines)


def _extension() -> list[str]:
    """Tables 3 and 4 of appendix H: the extended surface, and its derivatives at the joint."""
    printed = published_surface(PublishedSurface.EXTENDED_BY_SHETTY_AND_WHITE)
    ours = extend_surface(published_surface(PublishedSurface.ORIGINAL), "v0", 0.25, tau=1.0)
    assert ours.weights is not None and printed.weights is not None
    off = [np.abs(ours.poles - printed.poles).max(), np.abs(ours.weights - printed.weights).max()]
    lines = [
        "extension of appendix H with τ = 1, to v = -0.5",
        f"table 3: largest difference of a pole {off[0]:.4f} mm, of a weight {off[1]:.4f} "
        "(printed: three decimals)",
        "table 4: derivative by v before and after the joint      (published: 12, 0, 13.8)",
    ]
    for name, surface in (
        ("Shetty and White, ours", ours),
        ("AutoCAD, as printed", published_surface(PublishedSurface.EXTENDED_BY_AUTOCAD)),
    ):
        both = "   ".join(
            "(" + ", ".join(f"{x:.1f}" for x in side + 0.0) + ")" for side in at_the_joint(surface)
        )
        lines.append(f"  {name:<24} {both}")
    return lines


def at_the_joint(surface: BSplineSurface) -> list[NDArray[np.float64]]:
    """Derivatives (3,) by v over [0, 1] on both sides of the knot of three, at u = 0.5."""
    knots = surface.knots[1]
    at, scale = knots[4], knots[-1] - knots[0]
    return [scale * part.derivative(0.5, at, 0, 1) for part in surface.split(1, at)]
