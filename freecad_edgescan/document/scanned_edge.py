# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric scanned edge: a Part::FeaturePython whose Shape is one native edge.

Changing an input scans again on recompute; without a change nothing is computed. The name of this
module and of `ScannedEdgeProxy` are written into users' files.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
from numpy.typing import ArrayLike

from ..scanning import Gate, Progress, ScanError, ScannedEdge, ScanParameters, Start, scan_edge
from .bridge import origin_of
from .cloud_cache import point_cloud, probe_radius_of
from .declared_properties import declare
from .file_coordinates import refuse_file_coordinates
from .linked_geometry import require_cloud
from .native_edge import edge_shape
from .refusal import RefusalError
from .scan_inputs import checked_inputs, input_hash, read_inputs, write_inputs
from .scanned_edge_properties import CHOICES, LENGTHS, PROPERTIES, SCHEMA_VERSION
from .shown_properties import show_probe_radius, show_what_counts

__all__ = [
    "ScannedEdgeProxy",
    "change_scanned_edge",
    "make_scanned_edge",
    "scan_again",
    "write_result",
]


def make_scanned_edge(
    doc: Any,
    cloud: Any,
    at: ArrayLike | Start,
    gate: ArrayLike | Gate | None = None,
    parameters: ScanParameters | None = None,
    method: str = "patch",
    name: str = "ScannedEdge",
) -> Any:
    """Make a parametric edge; `doc.recompute()` scans it.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature in it
    at : (3,) point near the edge, or a Start, in the document's coordinates, mm
    gate : where to end: (3,) point, a Gate, or None
    parameters : what is None in them is chosen automatically
    method : "patch", or "probe": line by line like a measuring machine
    name : of the object

    Returns
    -------
    Part::FeaturePython. Its Shape is one line, circle, arc or B-spline.

    Raises
    ------
    ValueError: something that is no point cloud, or inputs that cannot work; nothing is made.
    """
    require_cloud(cloud)
    inputs = checked_inputs(at, gate, parameters, method)
    refuse_file_coordinates(cloud, inputs.at, inputs.gate)
    obj = doc.addObject("Part::FeaturePython", name)
    ScannedEdgeProxy(obj)
    obj.Cloud = cloud
    write_inputs(obj, inputs)
    return obj


def change_scanned_edge(
    obj: Any,
    at: ArrayLike | Start,
    gate: ArrayLike | Gate | None = None,
    parameters: ScanParameters | None = None,
    method: str = "patch",
    cloud: Any = None,
) -> None:
    """Give an edge other inputs, all of them at once; `doc.recompute()` scans it anew.

    What is not given here becomes automatic again. The least angle stays as it is.

    Parameters
    ----------
    obj : scanned edge, as made by `make_scanned_edge`
    at, gate, parameters, method : as there
    cloud : Points::Feature to scan from now on; None: the one it has

    Raises
    ------
    ValueError: an object that is no scanned edge, or inputs that cannot work; it stays as it was.
    """
    if not isinstance(getattr(obj, "Proxy", None), ScannedEdgeProxy):
        raise ValueError(
            f"{getattr(obj, 'Label', obj)!r} is not a scanned edge; make one with "
            "make_scanned_edge(doc, cloud, at=(x, y, z))."
        )
    inputs = checked_inputs(at, gate, parameters, method)
    refuse_file_coordinates(obj.Cloud if cloud is None else cloud, inputs.at, inputs.gate)
    if cloud is not None and obj.Cloud is not cloud:
        obj.Cloud = cloud
    write_inputs(obj, inputs)


def scan_again(obj: Any, progress: Progress | None = None) -> ScannedEdge:
    """Scan with the present inputs of an edge object; the object stays as it is.

    Raises
    ------
    ValueError: the scan cannot be done; the text says why.
    """
    inputs = read_inputs(obj)
    choices = {} if inputs.min_angle is None else {"min_angle": inputs.min_angle}
    return scan_edge(
        point_cloud(obj.Cloud),
        at=inputs.at,
        gate=inputs.gate,
        parameters=inputs.parameters,
        method=inputs.method,
        progress=progress,
        **choices,
    )


def write_result(obj: Any, edge: ScannedEdge) -> None:
    """Write a scan made with the object's present inputs; the next recompute has nothing to do.

    Raises
    ------
    ScanError: fewer than two edge points.
    """
    shape = edge_shape(edge)
    shape.Placement = obj.Placement
    obj.Shape = shape
    _write_used(obj, edge)
    _write_edge_points(obj, edge)
    fillets = edge.fillet_radius[np.isfinite(edge.fillet_radius)]
    obj.Message = edge.message
    obj.Stops = [stop.name for stop in edge.stops]
    obj.PointCount = len(edge.points)
    obj.Length = shape.Length
    obj.MeanSigma = float(np.mean(edge.sigma))
    obj.LargestSigma = float(np.max(edge.sigma))
    obj.MeanAngle = float(np.degrees(np.mean(edge.angle)))
    obj.FilletRadius = float(np.median(fillets)) if len(fillets) else 0.0
    obj.Convex = "unknown" if edge.convex is None else ("yes" if edge.convex else "no")
    obj.Closed = bool(edge.closed)
    obj.Origin = FreeCAD.Vector(*origin_of(obj.Cloud))
    obj.InputHash = input_hash(obj)


class ScannedEdgeProxy:
    """What makes the object scan. It keeps no state: everything lives in properties."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        declare(obj, PROPERTIES)
        obj.SchemaVersion = SCHEMA_VERSION
        show_what_counts(obj)

    def onChanged(self, obj: Any, name: str) -> None:
        """Keep ProbeRadius true: the cloud's, not to be edited, or the edge's own.

        A value other than the cloud's makes it the edge's own.
        """
        # FreeCAD calls this before all properties exist, too, and while it undoes.
        if "Restore" in obj.State or obj.Document.Transacting or not hasattr(obj, "InputHash"):
            return
        if name == "ProbeRadius" and obj.ProbeRadius.Value != probe_radius_of(obj.Cloud):
            obj.OwnProbeRadius = True
        elif name in ("Cloud", "OwnProbeRadius"):
            show_probe_radius(obj)
        elif name == "Method":
            show_what_counts(obj)

    def execute(self, obj: Any) -> None:
        """Scan when an input has changed since the last scan.

        A scan that fails leaves the edge found before, and its sentence is in ``Message``.
        """
        show_probe_radius(obj)
        refused = _scan_if_changed(obj)
        if refused is not None:
            raise RefusalError(refused)

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring an object of an older file up to date."""
        declare(obj, PROPERTIES)
        while obj.SchemaVersion < SCHEMA_VERSION:
            obj.SchemaVersion += 1
        show_what_counts(obj)

    def dumps(self) -> None:
        """Nothing to write into the file."""
        return None

    def loads(self, state: object) -> None:
        """Nothing to read from the file."""

    # FreeCAD before 0.21.2 asks for these instead.
    __getstate__ = dumps
    __setstate__ = loads


def _scan_if_changed(obj: Any) -> str | None:
    """Scan when an input has changed; the sentence that says why not, when it is refused."""
    try:
        if obj.InputHash != input_hash(obj) or obj.Shape.isNull():
            write_result(obj, scan_again(obj))
    except ValueError as error:
        obj.InputHash = ""
        obj.Message = str(error)
        if isinstance(error, ScanError):
            return str(error)
        raise
    return None


def _write_used(obj: Any, edge: ScannedEdge) -> None:
    used = edge.parameters
    for field, (name, _) in LENGTHS.items():
        setattr(obj, f"{name}Used", getattr(used, field) or 0.0)
    obj.DegreeUsed = used.degree or 0
    for field, (name, _, _) in CHOICES.items():
        choice = getattr(used, field)
        setattr(obj, f"{name}Used", "" if choice is None else choice.value)
    obj.ProbeRadiusUsed = used.probe_radius or 0.0
    approach = np.zeros(3) if used.approach is None else np.asarray(used.approach)
    obj.ApproachUsed = FreeCAD.Vector(*approach.tolist())
    obj.Reasons = [f"{name}: {reason}" for name, reason in edge.reasons.items()]


def _write_edge_points(obj: Any, edge: ScannedEdge) -> None:
    covariance = edge.covariance
    obj.Points = _vectors(edge.points)
    obj.Tangents = _vectors(edge.tangents)
    obj.FirstNormals = _vectors(edge.normals[:, 0])
    obj.SecondNormals = _vectors(edge.normals[:, 1])
    obj.Angles = np.asarray(edge.angle, dtype=float).tolist()
    obj.Sigma = np.asarray(edge.sigma, dtype=float).tolist()
    obj.Covariances = _vectors(
        np.column_stack([covariance[:, 0, 0], covariance[:, 0, 1], covariance[:, 1, 1]])
    )
    obj.FilletRadii = np.asarray(edge.fillet_radius, dtype=float).tolist()
    obj.FilletSigmas = np.asarray(edge.fillet_sigma, dtype=float).tolist()
    obj.Supported = np.asarray(edge.supported, dtype=bool).tolist()
    obj.Compensated = [str(how) for how in edge.compensation]


def _vectors(rows: ArrayLike) -> list[Any]:
    return [FreeCAD.Vector(*row) for row in np.asarray(rows, dtype=float).tolist()]
