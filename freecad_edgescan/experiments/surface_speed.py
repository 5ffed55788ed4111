# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast surfaces are fitted and points projected onto them, beside what others take.

Fits are compared with FITPACK (through SciPy), which fits one coordinate after the other to the
same points, parameters and knots, in the same run; projections with a function that is given.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from time import process_time

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import LSQBivariateSpline

from ..geometry import BSplineSurface
from ..scanning import Progress
from ..surfacing import fit_surface
from ..surfacing.parameterised import Parameterised
from ..surfacing.surface_through import surface_through

__all__ = ["SurfaceSpeed", "measure_surface_speed"]

Array = NDArray[np.float64]

POLES = (40, 20)
FITTED = 200_000  # points
PROJECTED = 1_000_000  # points
ASKED = 500  # points that the other projection is asked for
NOISE = 0.02  # mm, of the fitted points
AWAY = 0.5  # mm, of the projected ones
_SIZE = (200.0, 80.0)  # mm, of the surface


@dataclass(frozen=True)
class SurfaceSpeed:
    """Seconds of processor time.

    Attributes
    ----------
    fit : of points that have their parameters
    fit_with_projection : of points that have not
    fitpack : of FITPACK for the three coordinates of points that have their parameters
    projection : for all projected points
    other_projection : for one point by the other way; nan when there was none
    """

    fit: float
    fit_with_projection: float
    fitpack: float
    projection: float
    other_projection: float

    def text(self) -> str:
        """What was measured, in lines."""
        nu, nv = POLES
        share = self.fit / self.fitpack
        lines = [
            f"fit of {FITTED} points with {nu} × {nv} control points: {self.fit:.2f} s, "
            f"{share:.2f} of FITPACK's {self.fitpack:.2f} s; with projection "
            f"{self.fit_with_projection:.2f} s",
            f"closest places of {PROJECTED} points on a surface of {nu} × {nv} control points: "
            f"{self.projection:.2f} s",
        ]
        if np.isfinite(self.other_projection):
            faster = self.other_projection / (self.projection / PROJECTED)
            lines.append(
                f"one point by FreeCAD's Surface.parameter: {1e3 * self.other_projection:.2f} ms, "
                f"{faster:.0f} times as long"
            )
        return "\n".join(lines)


def measure_surface_speed(
    progress: Progress | None = None,
    other: Callable[[BSplineSurface], Callable[[Array], object]] | None = None,
) -> SurfaceSpeed | None:
    """Time fits and projections on a wavy surface.

    Parameters
    ----------
    progress : told the share that is done; where it answers False the result is None
    other : answers for a surface what projects one point (3,) onto it in another way
    """
    surface = wavy_surface()
    random = np.random.default_rng(0)
    u, v = random.random((2, FITTED))
    points = surface.evaluate(u, v) + random.normal(0.0, NOISE, (FITTED, 3))
    given = Parameterised(points, u, v, np.zeros(FITTED, dtype=bool))

    def fitpack() -> None:
        inner = [knots[4:-4] for knots in surface.knots]
        for column in points.T:
            LSQBivariateSpline(u, v, column, *inner)

    big = surface.evaluate(*random.random((2, PROJECTED)))
    big += random.normal(0.0, AWAY, big.shape)
    project = None if other is None else other(surface)

    def others() -> None:
        if project is not None:
            for point in big[:ASKED]:
                project(point)

    tasks: dict[str, Callable[[], object]] = {
        "fit": lambda: surface_through(given, surface, surface.knots, surface.degree, 0, 1e-3),
        "fit with projection": lambda: fit_surface(points, surface, POLES, corrections=0),
        "FITPACK": fitpack,
        "projection": lambda: surface.closest(big),
        "another projection": others,
    }
    seconds: dict[str, float] = {}
    for number, (name, task) in enumerate(tasks.items()):
        if progress is not None and not progress.update(number / len(tasks), name):
            return None
        began = process_time()
        task()
        seconds[name] = process_time() - began
    return SurfaceSpeed(
        fit=seconds["fit"],
        fit_with_projection=seconds["fit with projection"],
        fitpack=seconds["FITPACK"],
        projection=seconds["projection"],
        other_projection=seconds["another projection"] / ASKED if project else float("nan"),
    )


def wavy_surface() -> BSplineSurface:
    """A bicubic surface with hills and valleys."""
    x, y = (np.linspace(0.0, size, count) for size, count in zip(_SIZE, POLES, strict=True))
    height = 8.0 * np.sin(x / 25.0)[:, None] * np.cos(y / 20.0)
    poles = np.stack([*np.meshgrid(x, y, indexing="ij"), height], axis=2)
    u, v = (np.r_[[0.0] * 3, np.linspace(0.0, 1.0, count - 2), [1.0] * 3] for count in POLES)
    return BSplineSurface(poles, (u, v), (3, 3))
