# SPDX-License-Identifier: LGPL-2.1-or-later
"""Macro lines of a scan: they make the same edge again, bit for bit, without a screen."""

from __future__ import annotations

from dataclasses import fields
from enum import Enum
from typing import Any

from freecad_edgescan.document.scan_inputs import ScanInputs
from freecad_edgescan.scanning import Gate, ScanParameters, Start

from .recorded_step import as_literal, object_line

__all__ = ["change_lines", "make_lines"]

_IMPORT = "import freecad_edgescan as es"


def make_lines(cloud: Any, inputs: ScanInputs) -> list[str]:
    """Lines that make a scanned edge in ``doc``."""
    return _lines(f"edge = document.make_scanned_edge(doc, {object_line(cloud)}", inputs)


def change_lines(edge: Any, cloud: Any, inputs: ScanInputs) -> list[str]:
    """Lines that give a scanned edge of ``doc`` other inputs."""
    lines = _lines(f"document.change_scanned_edge({object_line(edge)}", inputs)
    if cloud is not edge.Cloud:
        lines[-1] = f"{lines[-1][:-1]}, cloud={object_line(cloud)})"
    return lines


def _lines(call: str, inputs: ScanInputs) -> list[str]:
    arguments = [f"at={_place(inputs.at)}"]
    if inputs.gate is not None:
        arguments.append(f"gate={_place(inputs.gate)}")
    if inputs.parameters.given():
        arguments.append(f"parameters={_parameters(inputs.parameters)}")
    if inputs.method != "patch":
        arguments.append(f"method={inputs.method!r}")
    line = f"{call}, {', '.join(arguments)})"
    return [_IMPORT, line] if "es." in line else [line]


def _place(place: Any) -> str:
    """A point, Start or Gate; unit vectors read back bit for bit."""
    if isinstance(place, Start):
        vectors = (place.point, place.across, place.along)
        return f"es.Start({', '.join(as_literal(vector) for vector in vectors)})"
    if isinstance(place, Gate):
        return f"es.Gate({as_literal(place.point)}, {as_literal(place.across)})"
    return as_literal(place)


def _parameters(given: ScanParameters) -> str:
    texts = []
    for field in fields(given):
        value = getattr(given, field.name)
        if value is None:
            continue
        if isinstance(value, Enum):
            value = value.value
        elif isinstance(value, tuple):
            texts.append(f"{field.name}={as_literal(value)}")
            continue
        elif not isinstance(value, int | str):
            value = float(value)
        texts.append(f"{field.name}={value!r}")
    return f"es.ScanParameters({', '.join(texts)})"
