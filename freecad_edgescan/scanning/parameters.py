# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of a scan; whatever is None is chosen from the cloud."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from enum import StrEnum
from typing import Any

import numpy as np

from .errors import ScanError
from .safeguards import Safeguards
from .start import UNIT_BLUR, numbers


class Pattern(StrEnum):
    """How the scan lines of a probe follow each other across the edge."""

    SQUARE = "square"
    ZIGZAG = "zigzag"


class Tangent(StrEnum):
    """How a probed scan finds the direction of the edge (Schreve 4.4.1)."""

    INTERPOLATION = "interpolation"
    PLANES = "planes"
    POLYNOMIALS = "polynomials"


class Steering(StrEnum):
    """How the next scan line is placed (Schreve 4.4.2, 4.4.3)."""

    TANGENT = "tangent"
    CURVATURE = "curvature"


class Compensation(StrEnum):
    """How the probe radius is taken off (Schreve 4.5)."""

    POINT = "point"
    CURVE = "curve"
    INTERSECTION = "intersection"
    INTERSECTION_PRINTED = "intersection_printed"


_LENGTHS = (
    "amplitude",
    "line_pitch",
    "edge_pitch",
    "chord_height",
    "tolerance",
    "prehit_distance",
    "search_distance",
    "cloud_pitch",
)


@dataclass(frozen=True)
class ScanParameters:
    """Parameters of a scan; None means chosen automatically.

    Attributes
    ----------
    amplitude : whole length of a scan line along the surface, half on each side, mm
    line_pitch : distance of the points on a probed scan line, mm
    edge_pitch : distance of the edge points, mm
    chord_height : largest deviation of the chord between two edge points, mm
    tolerance : scanning tolerance of a probed line section, mm
    degree : degree of a probed line section: 1, 2 or 3
    pattern, tangent, steering, compensation : choices for the probed scan
    probe_radius : radius of the probe whose centres the cloud holds, mm; None: the cloud's own
    approach : direction the probe came along; None: the cloud's own
    prehit_distance, search_distance : handed to the measuring machine with each move, mm
    cloud_pitch : pitch that tells a gap from surface in a probed scan of a cloud, mm
    safeguards : measures of a probed scan beyond the algorithm as printed

    Raises
    ------
    ScanError: a value that cannot work; its text names the value.
    """

    amplitude: float | None = None
    line_pitch: float | None = None
    edge_pitch: float | None = None
    chord_height: float | None = None
    tolerance: float | None = None
    degree: int | None = None
    pattern: Pattern | str | None = None
    tangent: Tangent | str | None = None
    steering: Steering | str | None = None
    compensation: Compensation | str | None = None
    probe_radius: float | None = None
    approach: Sequence[float] | np.ndarray | None = None
    prehit_distance: float | None = None
    search_distance: float | None = None
    cloud_pitch: float | None = None
    safeguards: Safeguards | None = None

    @classmethod
    def literal(cls, **values: Any) -> ScanParameters:
        """The probed scan exactly as it is printed, without any measure beyond it.

        Parameters
        ----------
        values : parameters by name; the printed compensation is used unless another one is given
        """
        printed = {
            "compensation": Compensation.INTERSECTION_PRINTED,
            "tangent": Tangent.POLYNOMIALS,
            "steering": Steering.TANGENT,
            "safeguards": Safeguards.none(),
        }
        return cls(**{**printed, **values})

    def __post_init__(self) -> None:
        for name in _LENGTHS:
            _check_length(name, getattr(self, name))
        if self.probe_radius is not None and not (
            isinstance(self.probe_radius, int | float | np.number)
            and np.isfinite(self.probe_radius)
            and self.probe_radius >= 0
        ):
            raise ScanError(
                f"The probe radius is {self.probe_radius!r}; give 0 or a positive length in mm."
            )
        if self.degree is not None and (self.degree not in (1, 2, 3) or self.degree is True):
            raise ScanError(
                f"The degree is {self.degree!r}; give 1 (line), 2 (quadratic) or 3 (cubic)."
            )
        for name, choices in (
            ("pattern", Pattern),
            ("tangent", Tangent),
            ("steering", Steering),
            ("compensation", Compensation),
        ):
            object.__setattr__(self, name, _choice(name, getattr(self, name), choices))
        object.__setattr__(self, "approach", _direction(self.approach))
        if not isinstance(self.safeguards, Safeguards | None):
            raise ScanError(
                f"The safeguards are {self.safeguards!r}; give Safeguards(...), or "
                "Safeguards.none() for the algorithm as printed."
            )

    def given(self) -> dict[str, object]:
        """Return the values that are not automatic, by name."""
        return {
            field.name: getattr(self, field.name)
            for field in fields(self)
            if getattr(self, field.name) is not None
        }


def _check_length(name: str, value: float | None) -> None:
    if value is None:
        return
    number = isinstance(value, int | float | np.number) and not isinstance(value, bool)
    if not (number and np.isfinite(value) and value > 0):
        words = name.replace("_", " ")
        raise ScanError(f"The {words} is {value!r}; give a positive length in mm.")


def _choice(name: str, value: object, choices: type[StrEnum]) -> StrEnum | None:
    if value is None or isinstance(value, choices):
        return value
    try:
        return choices(str(value))
    except ValueError:
        known = ", ".join(repr(choice.value) for choice in choices)
        raise ScanError(f"The {name} is {value!r}; choose one of {known}.") from None


def _direction(value: object) -> tuple[float, float, float] | None:
    """Return a unit vector, or None."""
    if value is None:
        return None
    vector = numbers(value)
    if vector is None or not np.any(vector):
        raise ScanError(f"The approach is {value!r}; give a direction of three numbers, not zero.")
    size = float(np.linalg.norm(vector))
    # A unit vector stays as it is, bit for bit: it may have been kept in a document or a macro.
    x, y, z = (float(part) for part in (vector if abs(size - 1.0) <= UNIT_BLUR else vector / size))
    return x, y, z
