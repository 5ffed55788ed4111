# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a scanned edge: what goes in, what automatic chose, what came out."""

from __future__ import annotations

from enum import Enum

from ..scanning import Compensation, Pattern, Steering, Tangent
from .declared_properties import Declared, Role

__all__ = [
    "AUTOMATIC",
    "CHOICES",
    "LENGTHS",
    "METHODS",
    "PROBE_ONLY",
    "PROPERTIES",
    "SCHEMA_VERSION",
]

SCHEMA_VERSION = 1
AUTOMATIC = "automatic"
METHODS = ("patch", "probe")

# Field of ScanParameters: property name, tooltip.
LENGTHS = {
    "amplitude": ("Amplitude", "Length of a scan line along the surface, half on each side"),
    "line_pitch": ("LinePitch", "Distance of the points on a probed scan line"),
    "edge_pitch": ("EdgePitch", "Distance of the edge points"),
    "chord_height": ("ChordHeight", "Largest deviation of the chord between two edge points"),
    "tolerance": ("Tolerance", "Scanning tolerance of a probed line section"),
    "prehit_distance": ("PrehitDistance", "Prehit distance of the measuring machine"),
    "search_distance": ("SearchDistance", "Search distance of the measuring machine"),
    "cloud_pitch": ("CloudPitch", "Pitch that tells a gap from surface in a probed scan"),
}
CHOICES: dict[str, tuple[str, str, type[Enum]]] = {
    "pattern": ("Pattern", "How the scan lines of a probed scan follow each other", Pattern),
    "tangent": ("Tangent", "How a probed scan finds the direction of the edge", Tangent),
    "steering": ("Steering", "How a probed scan places its next scan line", Steering),
    "compensation": ("Compensation", "How a probed scan takes off the probe radius", Compensation),
}

# Parameters of the probed scan only: shown when that is the method.
PROBE_ONLY = (
    "LinePitch",
    "Tolerance",
    "PrehitDistance",
    "SearchDistance",
    "CloudPitch",
    "Degree",
    *(name for name, _, _ in CHOICES.values()),
)


def _parameter(kind: str, name: str, tooltip: str, choices: tuple[str, ...] = ()) -> Declared:
    return Declared(kind, name, "Scan parameters", tooltip, Role.INPUT, choices)


_WHERE = (
    Declared("LinkGlobal", "Cloud", "Cloud", "The point cloud, a Points object, that is scanned"),
    Declared(
        "Vector",
        "At",
        "Scan",
        "Where the scan begins: a point near the edge, or, with Across and Along, the first point "
        "of the first scan line (document coordinates)",
    ),
    Declared(
        "Vector",
        "Across",
        "Scan",
        "Direction of the first scan line, across the edge; (0, 0, 0): At is a click near the edge",
    ),
    Declared("Vector", "Along", "Scan", "Direction of the walk along the edge; used with Across"),
    Declared("Bool", "UseGate", "Scan", "Whether the scan ends at Gate; else where the edge ends"),
    Declared(
        "Vector",
        "Gate",
        "Scan",
        "Where the scan ends: a point, or, with GateAcross, the first end of a gate line",
    ),
    Declared(
        "Vector",
        "GateAcross",
        "Scan",
        "Direction of the gate line, across the edge; (0, 0, 0): the gate is a point",
    ),
    Declared(
        "Enumeration",
        "Method",
        "Scan",
        "How edge points are found: patch uses all the points on both sides, probe touches the "
        "cloud line by line like a measuring machine",
        choices=METHODS,
    ),
    Declared(
        "Angle", "MinAngle", "Scan", "Least turn between the two sides of an edge; 0: automatic"
    ),
)

_PARAMETERS = (
    *(
        # Not "Length", which turns a negative value into 0 without a word.
        _parameter("Distance", name, f"{tooltip}; 0: automatic")
        for name, tooltip in LENGTHS.values()
    ),
    _parameter("Integer", "Degree", "Degree of a line section, 1 to 3; 0: automatic"),
    *(
        _parameter(
            "Enumeration", name, tooltip, (AUTOMATIC, *(str(choice.value) for choice in enum))
        )
        for name, tooltip, enum in CHOICES.values()
    ),
    _parameter(
        "Bool",
        "OwnProbeRadius",
        "Whether this edge has a ProbeRadius of its own; else that of the cloud counts",
    ),
    _parameter(
        "Distance",
        "ProbeRadius",
        "Radius of the ball whose centres the cloud holds. Without OwnProbeRadius it is the "
        "cloud's and cannot be edited here: set it at the cloud, or set OwnProbeRadius",
    ),
    _parameter(
        "Vector", "Approach", "Direction the probe came along; (0, 0, 0): that of the cloud"
    ),
)


def _used(kind: str, name: str) -> Declared:
    return Declared(kind, f"{name}Used", "Values used", f"{name} that was used", Role.RESULT)


_USED = (
    *(_used("Length", name) for name, _ in LENGTHS.values()),
    _used("Integer", "Degree"),
    *(_used("String", name) for name, _, _ in CHOICES.values()),
    _used("Length", "ProbeRadius"),
    _used("Vector", "Approach"),
    Declared(
        "StringList", "Reasons", "Values used", "Why each automatic value was chosen", Role.RESULT
    ),
)


def _result(kind: str, name: str, tooltip: str) -> Declared:
    return Declared(kind, name, "Result", tooltip, Role.RESULT)


def _list(kind: str, name: str, tooltip: str) -> Declared:
    return Declared(kind, name, "Edge points", tooltip, Role.HIDDEN_RESULT)


_RESULTS = (
    _result("String", "Message", "What happened, and what to try"),
    _result("StringList", "Stops", "Why the edge ends, at its start and at its end"),
    _result("Integer", "PointCount", "Number of edge points"),
    _result("Length", "Length", "Length of the edge"),
    _result("Length", "MeanSigma", "Mean standard deviation of the edge points"),
    _result("Length", "LargestSigma", "Largest standard deviation of an edge point"),
    _result("Angle", "MeanAngle", "Mean angle between the two sides"),
    _result("Length", "FilletRadius", "Median radius of the rounding; 0: none is measurable"),
    _result("String", "Convex", "Whether material fills the smaller wedge: yes, no or unknown"),
    _result("Bool", "Closed", "Whether the edge comes back to its start"),
    _list("VectorList", "Points", "Edge points, document coordinates"),
    _list("VectorList", "Tangents", "Unit tangents at the edge points"),
    _list("VectorList", "FirstNormals", "Unit normals of the first side at the edge points"),
    _list("VectorList", "SecondNormals", "Unit normals of the second side at the edge points"),
    _list("FloatList", "Angles", "Angle between the two sides at the edge points, rad"),
    _list("FloatList", "Sigma", "Standard deviation of the edge points, mm"),
    _list(
        "VectorList",
        "Covariances",
        "Covariance across the edge as (aa, ab, bb), mm²; axes n1 + n2 and n1 - n2",
    ),
    _list("FloatList", "FilletRadii", "Radius of the rounding at the edge points, mm, or nan"),
    _list("FloatList", "FilletSigmas", "Standard deviation of the radii, mm, or nan"),
    _list(
        "BoolList",
        "Supported",
        "False where the point rests on its neighbours: a gap, or too little of a side is smooth",
    ),
    _list("StringList", "Compensated", "How the probe radius was taken off each edge point"),
    Declared(
        "Vector",
        "Origin",
        "Result",
        "Add this to the document's coordinates to get those of the cloud's source",
        Role.RESULT,
    ),
)


def _record(kind: str, name: str, tooltip: str) -> Declared:
    return Declared(kind, name, "Record", tooltip, Role.HIDDEN_RESULT)


_RECORD = (
    Declared(
        "Integer", "SchemaVersion", "Record", "Version of these properties", Role.HIDDEN_RESULT
    ),
    Declared("String", "InputHash", "Record", "Inputs the result belongs to", Role.HIDDEN_RESULT),
)

PROPERTIES = (*_WHERE, *_RESULTS, *_PARAMETERS, *_USED, *_RECORD)
