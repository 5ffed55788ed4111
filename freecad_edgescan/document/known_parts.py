# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts whose edges are known exactly, sharp or under fillets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import FreeCAD  # before Part, which ends the process otherwise
import numpy as np
import Part
from numpy.typing import NDArray

from ..cloud import TrueEdge
from .sharp_edges import true_edges

__all__ = ["KnownPart", "block_with_bore", "filleted", "sharp_part", "simple_parts"]

Array = NDArray[np.float64]

_ROOM = 5.0  # pitches between two fillets' beginnings at least


@dataclass(frozen=True)
class KnownPart:
    """A shape to scan, and the sharp edges that the scan is to find.

    Attributes
    ----------
    name : of the part
    shape : Part.Shape that is scanned
    edges : the true edges that are sought, sharp also where the shape has fillets
    others : the other true edges, which a scan may go on to
    fillet : radius, mm, of the fillets on the edges that are sought; 0: they are sharp
    """

    name: str
    shape: Any
    edges: tuple[TrueEdge, ...]
    others: tuple[TrueEdge, ...] = ()
    fillet: float = 0.0

    def side_left(self, truth: TrueEdge) -> Array:
        """Width (k,) of the sides between one edge's fillet and the next, mm."""
        return np.asarray(truth.room - 2.0 * _begins(truth, self.fillet))


def sharp_part(name: str, shape: Any) -> KnownPart:
    """A part all of whose sharp edges are sought."""
    return KnownPart(name, shape, tuple(true_edges(shape)))


def block_with_bore() -> Any:
    """A block of 100 × 100 × 50 mm with a blind bore of 25 mm radius, 40 mm deep."""
    block = Part.makeBox(100.0, 100.0, 50.0)
    bore = Part.makeCylinder(25.0, 40.0, FreeCAD.Vector(50.0, 50.0, 10.0))
    return block.cut(bore)


def simple_parts() -> tuple[KnownPart, ...]:
    """Two planes at 90°, sharp and under a fillet of 2 mm, and the rim of a cylinder of R 20."""
    box, cylinder = Part.makeBox(60.0, 30.0, 30.0), Part.makeCylinder(20.0, 30.0)
    edge = _nearest_edge(box, (30.0, 0.0, 30.0))
    on_box, on_rim = (
        _true_edge_at(box, (30.0, 0.0, 30.0)),
        _true_edge_at(cylinder, (20.0, 0.0, 30.0)),
    )
    return (
        KnownPart("two planes", box, (on_box,)),
        KnownPart("two planes, fillet 2 mm", box.makeFillet(2.0, [edge]), (on_box,), fillet=2.0),
        KnownPart("cylinder rim", cylinder, (on_rim,)),
    )


def filleted(name: str, shape: Any, radius: float, pitch: float) -> KnownPart:
    """The part with a fillet on each straight convex edge that has room for it.

    Parameters
    ----------
    name : of the part
    shape : Part.Shape
    radius : of the fillets, mm
    pitch : of the scan, mm

    Raises
    ------
    ValueError: there is no edge that OpenCASCADE can round with this radius.
    """
    edges = true_edges(shape)
    straight = [
        truth
        for truth in edges
        if truth.convex and _is_straight(truth) and _has_room(truth, radius, pitch)
    ]
    rounded, done = _all_rounded(shape, straight, radius), straight
    if rounded is None:
        rounded, done = _each_rounded(shape, straight, radius)
    if not done:
        raise ValueError(f"No edge of {name} can be rounded with a radius of {radius:g} mm.")
    others = tuple(edge for edge in edges if not any(edge is truth for truth in done))
    return KnownPart(f"{name}, fillets {radius:.3g} mm", rounded, tuple(done), others, radius)


def _all_rounded(shape: Any, edges: Sequence[TrueEdge], radius: float) -> Any | None:
    """The shape with all edges rounded at once, which knows corners best; None when it fails."""
    if not edges:
        return None
    try:
        rounded = shape.makeFillet(
            radius, [_nearest_edge(shape, _middle(truth)) for truth in edges]
        )
    except (Part.OCCError, RuntimeError):
        return None
    return rounded if rounded.isValid() and len(rounded.Solids) == len(shape.Solids) else None


def _each_rounded(
    shape: Any, edges: Sequence[TrueEdge], radius: float
) -> tuple[Any, list[TrueEdge]]:
    """One edge after the other, without those at which it fails."""
    done = []
    for truth in edges:
        rounded = _all_rounded(shape, [truth], radius)
        if rounded is not None:
            shape = rounded
            done.append(truth)
    return shape, done


def _is_straight(truth: TrueEdge) -> bool:
    chord = float(np.linalg.norm(truth.points[-1] - truth.points[0]))
    return not truth.closed and chord > (1.0 - 1e-9) * truth.length


def _has_room(truth: TrueEdge, radius: float, pitch: float) -> bool:
    """Whether two fillets and a side between them fit to the next edge, and along it, too."""
    begins = _begins(truth, radius)
    needed = 2.0 * begins + _ROOM * pitch
    return bool(np.median(truth.room) >= needed) and truth.length > 2.0 * begins + 12.0 * pitch


def _begins(truth: TrueEdge, radius: float) -> float:
    """How far from an edge a fillet touches its sides, mm."""
    return radius / float(np.tan(0.5 * np.median(truth.angle)))


def _middle(truth: TrueEdge) -> Any:
    return truth.points[len(truth) // 2]


def _true_edge_at(shape: Any, place: Any) -> TrueEdge:
    return min(true_edges(shape), key=lambda edge: float(edge.distance([place])[0]))


def _nearest_edge(shape: Any, place: Any) -> Any:
    vertex = Part.Vertex(*(float(value) for value in place))
    return min(shape.Edges, key=lambda edge: float(edge.distToShape(vertex)[0]))
