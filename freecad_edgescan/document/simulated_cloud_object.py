# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulated scan of a shape, or of the core box, as clouds in a document.

The name of this module and of `SimulatedCloudProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ..cloud import CoreBox, SimulatedCloud
from .cloud_object import make_cloud
from .computed_cloud import WRITTEN_POINTS, ComputedCloudProxy, write_points
from .computed_object import Task
from .declared_properties import Declared
from .given_numbers import length_or_zero, positive_length, whole_number
from .linked_geometry import face_inputs, linked_faces, require_shape
from .simulated_shape import simulate_cloud

__all__ = ["SimulatedCloudProxy", "make_core_box", "make_simulated_cloud"]

_GROUP = "Simulated cloud"
_PROPERTIES = (
    Declared("LinkGlobal", "Source", _GROUP, "The part that is scanned: any object with faces"),
    Declared("Distance", "Pitch", _GROUP, "One point for each pitch² of surface"),
    Declared("Distance", "Noise", _GROUP, "Standard deviation of the points along the normal"),
    Declared(
        "Distance",
        "ProbeRadius",
        _GROUP,
        "Radius of the ball whose centres the cloud holds; 0: the points lie on the surface",
    ),
    Declared("Integer", "Seed", _GROUP, "The same seed gives the same cloud"),
    *WRITTEN_POINTS,
)


def make_simulated_cloud(
    doc: Any,
    source: Any,
    pitch: float,
    noise: float = 0.0,
    probe_radius: float = 0.0,
    seed: int = 0,
    name: str = "SimulatedCloud",
) -> Any:
    """Make the simulated scan of an object with faces; `doc.recompute()` scans it.

    Parameters
    ----------
    doc : App.Document
    source : object whose Shape has faces
    pitch, noise, probe_radius, seed : see `simulate_cloud`, mm
    name : of the object

    Returns
    -------
    Points::FeaturePython that follows the shape.

    Raises
    ------
    ValueError: no shape, a pitch that is not positive, or a negative noise or probe radius.
    """
    require_shape("part", [source])
    pitch, noise = positive_length("pitch", pitch), length_or_zero("noise", noise)
    probe_radius = length_or_zero("probe radius", probe_radius)
    seed = whole_number("seed", seed, 0)
    obj = doc.addObject("Points::FeaturePython", name)
    SimulatedCloudProxy(obj)
    obj.Source = source
    obj.Pitch, obj.Noise, obj.ProbeRadius = pitch, noise, probe_radius
    obj.Seed = seed
    return obj


def make_core_box(doc: Any, pitch: float = 0.5, small: bool = False, name: str = "CoreBox") -> Any:
    """Make the simulated scan of the published case study's core box.

    Parameters
    ----------
    doc : App.Document
    pitch : mm, of the scan lines
    small : a part of it with one pipe, for a first try
    name : of the object

    Returns
    -------
    A plain Points::Feature of centres of a ball that came down.

    Raises
    ------
    ValueError: no document, or a pitch that cannot work.
    """
    box = CoreBox.small() if small else CoreBox()
    return make_cloud(doc, box.cloud(positive_length("pitch", pitch)), name=name)


class SimulatedCloudProxy(ComputedCloudProxy):
    """What makes the object scan its source."""

    PROPERTIES = _PROPERTIES
    PLAIN = False

    def depends_on(self, obj: Any) -> Iterable[object]:
        """All faces of the source, and how it is scanned."""
        yield from face_inputs(linked_faces(obj.Source, "part"))
        yield from (obj.Pitch.Value, obj.Noise.Value, obj.ProbeRadius.Value, obj.Seed)

    def task(self, obj: Any) -> Task:
        """What scans the source."""
        lengths = (obj.Pitch.Value, obj.Noise.Value, obj.ProbeRadius.Value)
        shape, seed = obj.Source.Shape, int(obj.Seed)
        return lambda _progress: simulate_cloud(shape, *lengths, seed)

    def write(self, obj: Any, result: SimulatedCloud) -> None:
        """Write the points."""
        write_points(obj, result.points, "", (0.0, 0.0, 0.0))
