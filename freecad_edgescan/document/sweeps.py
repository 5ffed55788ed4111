# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps and lofts on scanned edges; they recompute when an edge is scanned again."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from .linked_geometry import require_shape
from .sweep_object import SweepProxy

__all__ = ["make_loft", "make_sweep"]


def make_sweep(doc: Any, profile: Any, rail: Any, name: str = "Sweep") -> Any:
    """Sweep a profile along a rail.

    Parameters
    ----------
    doc : App.Document
    profile : object with a Shape that is moved along
    rail : object with a Shape, such as a scanned edge; all its edges are followed

    Returns
    -------
    Part::FeaturePython with the properties of FreeCAD's Part::Sweep. Along a rail in a plane the
    profile keeps its angle to that plane; along any other its frames turn as little as they can. In
    corners of up to 120° the sweep is mitred. What cannot be swept marks the object as faulty, and
    its *Message* says why.

    Raises
    ------
    ValueError: profile and rail are the same, or one of them has no Shape.
    """
    require_shape("profile", [profile])
    require_shape("rail", [rail])
    if profile is rail:
        raise ValueError(f"Profile and rail are both {rail.Label!r}; choose two different objects.")
    edges = max(1, len(rail.Shape.Edges))
    sweep = doc.addObject("Part::FeaturePython", name)
    SweepProxy(sweep)
    sweep.Sections = [profile]
    sweep.Spine = (rail, [f"Edge{number}" for number in range(1, edges + 1)])
    return sweep


def make_loft(doc: Any, sections: Sequence[Any], closed: bool = False, name: str = "Loft") -> Any:
    """Lay a surface through sections, in their order.

    Parameters
    ----------
    doc : App.Document
    sections : two or more objects with a Shape
    closed : whether the last section is joined to the first

    Returns
    -------
    Part::Loft

    Raises
    ------
    ValueError: fewer than two sections, the same one twice in a row, or one without a Shape.
    """
    sections = list(sections)
    if len(sections) < 2:
        raise ValueError(f"A loft needs two sections or more, not {len(sections)}.")
    require_shape("section", sections)
    for before, after in pairwise(sections):
        if before is after:
            raise ValueError(
                f"The section {after.Label!r} follows itself; choose different objects."
            )
    loft = doc.addObject("Part::Loft", name)
    loft.Sections = sections
    loft.Solid = False
    loft.Ruled = False
    loft.Closed = bool(closed)
    return loft
