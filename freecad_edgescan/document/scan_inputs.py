# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between the input properties of a scanned edge and the arguments of `scan_edge`."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from typing import Any

import FreeCAD
import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..scanning import Gate, ScanError, ScanParameters, Start
from ..scanning.start import numbers
from .cloud_cache import cloud_checksum
from .scanned_edge_properties import AUTOMATIC, CHOICES, LENGTHS, METHODS, SCHEMA_VERSION

__all__ = [
    "ScanInputs",
    "checked_inputs",
    "checked_point",
    "input_hash",
    "read_inputs",
    "write_inputs",
]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ScanInputs:
    """Arguments of `scan_edge` besides the cloud."""

    at: Array | Start
    gate: Array | Gate | None = None
    parameters: ScanParameters = ScanParameters()  # noqa: RUF009, frozen
    method: str = "patch"
    min_angle: float | None = None


def checked_inputs(
    at: ArrayLike | Start,
    gate: ArrayLike | Gate | None,
    parameters: ScanParameters | None,
    method: str,
) -> ScanInputs:
    """Refuse what cannot be written into properties, with a sentence.

    Raises
    ------
    ScanError
    """
    if method not in METHODS:
        known = ", ".join(repr(name) for name in METHODS)
        raise ScanError(f"The method is {method!r}; choose one of {known}.")
    return ScanInputs(
        at if isinstance(at, Start) else checked_point("click", at),
        gate if gate is None or isinstance(gate, Gate) else checked_point("gate", gate),
        parameters or ScanParameters(),
        method,
    )


def write_inputs(obj: Any, inputs: ScanInputs) -> None:
    """Fill the input properties of a scanned edge; only those that differ are touched.

    The least angle stays as it is, unless one is given.
    """
    at, gate, given = inputs.at, inputs.gate, inputs.parameters
    values: dict[str, Any] = {
        "At": _vector(at.point if isinstance(at, Start) else at),
        "Across": _vector(at.across if isinstance(at, Start) else np.zeros(3)),
        "Along": _vector(at.along if isinstance(at, Start) else np.zeros(3)),
        "UseGate": gate is not None,
        "GateAcross": _vector(gate.across if isinstance(gate, Gate) else np.zeros(3)),
        "Method": inputs.method,
        "Degree": given.degree or 0,
        "OwnProbeRadius": given.probe_radius is not None,
        "Approach": _vector(np.zeros(3) if given.approach is None else given.approach),
    }
    if gate is not None:
        values["Gate"] = _vector(gate.point if isinstance(gate, Gate) else gate)
    for field, (name, _) in LENGTHS.items():
        values[name] = getattr(given, field) or 0.0
    for field, (name, _, _) in CHOICES.items():
        choice = getattr(given, field)
        values[name] = AUTOMATIC if choice is None else choice.value
    if given.probe_radius is not None:
        values["ProbeRadius"] = given.probe_radius
    if inputs.min_angle is not None:
        values["MinAngle"] = float(np.degrees(inputs.min_angle))
    for name, value in values.items():
        present = getattr(obj, name)
        if getattr(present, "Value", present) != value:
            setattr(obj, name, value)


def read_inputs(obj: Any) -> ScanInputs:
    """Give the arguments the input properties stand for.

    Raises
    ------
    ScanError: a value that cannot work; its text names the value.
    """
    values: dict[str, Any] = {
        field: getattr(obj, name).Value or None for field, (name, _) in LENGTHS.items()
    }
    values["degree"] = obj.Degree or None
    for field, (name, _, _) in CHOICES.items():
        choice = getattr(obj, name)
        values[field] = None if choice == AUTOMATIC else choice
    values["probe_radius"] = obj.ProbeRadius.Value if obj.OwnProbeRadius else None
    values["approach"] = _direction(obj.Approach)
    place = checked_point("click", tuple(obj.At))
    at: Array | Start = place
    across, along = _direction(obj.Across), _direction(obj.Along)
    if across is not None:
        if along is None:
            raise ScanError(
                "Across is given and Along is (0, 0, 0); give the direction of the walk in Along, "
                "or set Across to (0, 0, 0) to scan from a click."
            )
        at = Start(place, across, along)
    gate: Array | Gate | None = None
    if obj.UseGate:
        end = checked_point("gate", tuple(obj.Gate))
        gate_across = _direction(obj.GateAcross)
        gate = end if gate_across is None else Gate(end, gate_across)
    min_angle = float(np.radians(obj.MinAngle.Value)) or None
    return ScanInputs(at, gate, ScanParameters(**values), obj.Method, min_angle)


def input_hash(obj: Any) -> str:
    """Hash of everything the result of a scanned edge depends on.

    Raises
    ------
    ScanError: there is no cloud, it is empty, or its probe cannot be.
    """
    if obj.Cloud is None:
        raise ScanError(
            f"The cloud of the edge {obj.Label!r} was deleted; choose another one in its property "
            "Cloud, or undo the deletion. The edge found before is kept."
        )
    texts = [str(SCHEMA_VERSION), cloud_checksum(obj.Cloud)]
    names = ["At", "Across", "Along", "UseGate", "Gate", "GateAcross", "Method", "MinAngle"]
    names += [name for name, _ in LENGTHS.values()]
    names += [name for name, _, _ in CHOICES.values()]
    names += ["Degree", "OwnProbeRadius", "Approach"]
    if obj.OwnProbeRadius:  # else it repeats that of the cloud, which is in the checksum
        names.append("ProbeRadius")
    for name in names:
        value = getattr(obj, name)
        value = (
            tuple(value) if isinstance(value, FreeCAD.Vector) else getattr(value, "Value", value)
        )
        texts.append(f"{name}={_as_a_file_keeps_it(value)!r}")
    return hashlib.blake2b("\n".join(texts).encode(), digest_size=16).hexdigest()


def _as_a_file_keeps_it(value: Any) -> Any:
    """Numbers less the last digits, which do not survive in a document's file."""
    if isinstance(value, tuple):
        return tuple(_as_a_file_keeps_it(own) for own in value)
    return float(f"{value:.12g}") if isinstance(value, float) else value


def checked_point(name: str, value: ArrayLike) -> Array:
    """A point (3,) that a user gives; `name` says which.

    Raises
    ------
    ScanError: no three finite numbers.
    """
    point = numbers(value)
    if point is None:
        raise ScanError(f"The {name} is {value!r}; give three finite coordinates in mm.")
    return point


def _direction(vector: Any) -> Array | None:
    direction = np.array(vector, dtype=float)
    return direction if np.any(direction) else None


def _vector(values: ArrayLike) -> Any:
    return FreeCAD.Vector(*np.asarray(values, dtype=float).tolist())
