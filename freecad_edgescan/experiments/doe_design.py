# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design of the published experiments: 12 experiments of 16 tests in 11 parameters.

Schreve 5.3.2 and appendix E. Each experiment gives two levels to each parameter; the 16 tests
combine them so that every parameter's effect can be told from the others'. The printed curvatures
are rounded reciprocals of whole radii and the printed angles rounded radians of whole degrees:
the published numbers of edge points tell, and the true values are used here.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from importlib import resources

import numpy as np
from numpy.typing import NDArray

from ..cloud import TorusObject

__all__ = [
    "EXPERIMENTS",
    "PARAMETERS",
    "TESTS",
    "Trial",
    "coded_levels",
    "published_table",
    "trial",
]

EXPERIMENTS = range(1, 13)
TESTS = range(1, 17)
PARAMETERS = (
    *("surface_curvature", "amplitude", "noise", "line_pitch", "edge_pitch", "edge_curvature"),
    *("intersection_angle", "tolerance", "fillet_radius", "probe_radius", "cloud_pitch"),
)

PROJECTION_ANGLE = np.radians(10.0)  # of a scanning plane to the surface, seldom more (5.3.3.5.1.1)

# Printed curvature, 1/mm: true radius, mm.
_RADII = {
    0.125: 8.0,
    0.1: 10.0,
    0.067: 15.0,
    0.05: 20.0,
    0.033: 30.0,
    0.029: 35.0,
    0.025: 40.0,
    0.013: 75.0,
    0.01: 100.0,
    0.007: 150.0,
    0.004: 250.0,
    0.003: 350.0,
    0.002: 500.0,
}
# Printed angle, rad: true angle, degrees.
_DEGREES = {
    1.571: 90.0,
    1.745: 100.0,
    1.920: 110.0,
    2.094: 120.0,
    2.269: 130.0,
    2.443: 140.0,
    2.618: 150.0,
}


@dataclass(frozen=True)
class Trial:
    """One row of the design: an object, a cloud of it, and how it is scanned.

    Attributes
    ----------
    experiment, test : 1 … 12, 1 … 16
    section_radius : R, mm, of the surfaces across the edge
    amplitude : A, mm
    noise : level η, mm
    line_pitch : ρ_L, mm
    edge_pitch : ρ_e, mm
    edge_radius : x, mm
    angle : θ, rad
    tolerance : ε, mm
    fillet_radius : R_f, mm
    probe_radius : R_p, mm
    cloud_pitch : ρ_c, mm
    """

    experiment: int
    test: int
    section_radius: float
    amplitude: float
    noise: float
    line_pitch: float
    edge_pitch: float
    edge_radius: float
    angle: float
    tolerance: float
    fillet_radius: float
    probe_radius: float
    cloud_pitch: float

    @property
    def object(self) -> TorusObject:
        """The object, touched by the probe."""
        return TorusObject(
            self.section_radius, self.edge_radius, self.angle, self.fillet_radius, self.probe_radius
        )

    @property
    def nominal_points(self) -> float:
        """How many edge points a scan from azimuth 0.1 to π - 0.1 should have."""
        return (np.pi - 0.2) * self.edge_radius / self.edge_pitch

    @property
    def rounding_share(self) -> float:
        """What a scan line spends on the rounding over what it spends on a side, df/s (5.2.1.1)."""
        return self._rounding / self._side

    @property
    def arc_share(self) -> float:
        """Length of a line section over the radius of the surface, s·κ_s."""
        return self._side / self.section_radius

    @property
    def tolerance_ratio(self) -> float:
        """Least over given tolerance, ε_min/ε; above 1 points of the surface are cleaned away."""
        least = self.noise + self.cloud_pitch * np.sin(PROJECTION_ANGLE)
        return float(least / self.tolerance)

    @property
    def quoted_shares(self) -> tuple[float, float]:
        """df/s and s·κ_s as quoted in 5.3.3, which have R - R_p for R above the line in 5.2.1.1."""
        radius = self.section_radius - self.probe_radius
        sine = radius * np.cos(self.angle / 2) / (self.section_radius + self.fillet_radius)
        rounding = 2 * float(np.arcsin(sine)) * (self.fillet_radius + self.probe_radius)
        side = (self.amplitude - rounding) / 2
        return rounding / side, side / self.section_radius

    @property
    def _rounding(self) -> float:
        return self.object.rounding_length

    @property
    def _side(self) -> float:
        return (self.amplitude - self._rounding) / 2


@cache
def trial(experiment: int, test: int) -> Trial:
    """The row of the design with its true values.

    Raises
    ------
    ValueError: no such experiment or test.
    """
    if experiment not in EXPERIMENTS or test not in TESTS:
        raise ValueError(
            f"There is no test {experiment}.{test}; "
            "experiments go from 1 to 12, tests from 1 to 16."
        )
    levels = _levels()[experiment]
    high = coded_levels()[test - 1] > 0
    values = {name: pair[int(up)] for name, pair, up in zip(PARAMETERS, levels, high, strict=True)}
    return Trial(
        experiment,
        test,
        section_radius=_RADII[values.pop("surface_curvature")],
        edge_radius=_RADII[values.pop("edge_curvature")],
        angle=float(np.radians(_DEGREES[values.pop("intersection_angle")])),
        **values,
    )


@cache
def coded_levels() -> NDArray[np.float64]:
    """The design in coded levels: (16, 11), -1 low and +1 high, columns as ``PARAMETERS``."""
    rows = published_table("doe_design.csv")
    levels = np.array([[float(row[name]) for name in PARAMETERS] for row in rows])
    levels.setflags(write=False)
    return levels


@cache
def _levels() -> dict[int, list[tuple[float, float]]]:
    """Low and high value of each parameter, as printed, by experiment."""
    printed: dict[int, dict[str, list[float]]] = {}
    for row in published_table("doe_levels.csv"):
        values = [float(row[name]) for name in PARAMETERS]
        printed.setdefault(int(row["experiment"]), {})[row["level"]] = values
    return {
        experiment: list(zip(levels["low"], levels["high"], strict=True))
        for experiment, levels in printed.items()
    }


def published_table(name: str) -> list[dict[str, str]]:
    """Rows of one of the published tables that come with this package."""
    file = resources.files(__package__) / "published" / name
    return list(csv.DictReader(file.read_text(encoding="utf-8").splitlines()))
