# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that move profiles along edges: cross-section, sweep, loft, swept surface."""

from __future__ import annotations

from typing import Any

import FreeCAD

from .command import Command
from .obstacles import no_cloud_or_shape, no_shape
from .recorded_step import object_line, object_lines
from .selected import clouds_of, is_scanned_edge, shapes_of
from .selection_command import SelectionCommand
from .translation import translate

__all__ = ["profile_and_rail", "sweep_commands"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def sweep_commands() -> list[Command]:
    """All of them, in the order of the toolbar."""
    return [
        SelectionCommand(
            "EdgeScan_CloudSection",
            QT_TRANSLATE_NOOP("EdgeScan_CloudSection", "Cross-section"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_CloudSection",
                "Cut a cloud across an edge and fit a line, arc or spline. Select the cloud and "
                "the edge, and another edge to which the profile leads.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_CloudSection", "Select a cloud and one or two edges"),
            _section,
            no_cloud_or_shape,
            joins=True,
        ),
        SelectionCommand(
            "EdgeScan_Sweep",
            QT_TRANSLATE_NOOP("EdgeScan_Sweep", "Sweep along edge"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_Sweep",
                "Sweep a profile along an edge. Select the profile (a sketch, wire or edge), "
                "then the scanned edge.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_Sweep", "Select a profile, then an edge"),
            _sweep,
            no_shape,
            joins=True,
        ),
        SelectionCommand(
            "EdgeScan_Loft",
            QT_TRANSLATE_NOOP("EdgeScan_Loft", "Loft through edges"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_Loft",
                "Make a skin through edges or sections. Select two or more of them, in order.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_Loft", "Select two or more edges or sections, in order"),
            _loft,
            no_shape,
        ),
        SelectionCommand(
            "EdgeScan_SweptSurface",
            QT_TRANSLATE_NOOP("EdgeScan_SweptSurface", "Swept surface"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_SweptSurface",
                "Sweep profiles along one or two rails, fitted to a cloud. Select the rails, then "
                "the profiles in order, and a cloud when there is one.",
            ),
            QT_TRANSLATE_NOOP(
                "EdgeScan_SweptSurface", "Select one or two rails, profiles in order, and a cloud"
            ),
            _swept,
            no_shape,
            joins=True,
        ),
    ]


def profile_and_rail(shapes: list[Any]) -> tuple[Any, Any]:
    """Tell profile and rail apart: the only scanned edge is the rail, else the second object.

    Raises
    ------
    ValueError: not two objects.
    """
    if len(shapes) != 2:
        raise ValueError(
            translate(
                "{count} objects with a shape are selected. Select two: the profile (a sketch, "
                "wire or edge), then the scanned edge to sweep it along."
            ).format(count=len(shapes))
        )
    first, second = shapes
    if is_scanned_edge(first) and not is_scanned_edge(second):
        return second, first
    return first, second


def _sweep(chosen: list[Any]) -> str:
    profile, rail = profile_and_rail(shapes_of(chosen))
    return f"document.make_sweep(doc, {object_line(profile)}, {object_line(rail)})"


def _loft(chosen: list[Any]) -> str:
    sections = shapes_of(chosen)
    if len(sections) < 2:
        raise ValueError(
            translate(
                "{count} objects with a shape are selected. Select two or more edges or sections, "
                "in the order the skin goes through them."
            ).format(count=len(sections))
        )
    return f"document.make_loft(doc, {object_lines(sections)})"


def _section(chosen: list[Any]) -> str:
    clouds, shapes = clouds_of(chosen), shapes_of(chosen)
    if len(clouds) != 1 or len(shapes) not in (1, 2):
        raise ValueError(
            translate(
                "{clouds} clouds and {edges} edges are selected. Select two or three objects: one "
                "cloud, the edge to cut across, and another edge if there is one."
            ).format(clouds=len(clouds), edges=len(shapes))
        )
    cloud, rail = object_line(clouds[0]), object_line(shapes[0])
    towards = f", towards={object_line(shapes[1])}" if len(shapes) == 2 else ""
    return f"document.make_cloud_section(doc, {cloud}, {rail}{towards})"


def _swept(chosen: list[Any]) -> str:
    clouds, shapes = clouds_of(chosen), shapes_of(chosen)
    scanned = [item for item in shapes if is_scanned_edge(item)]
    rails = scanned if len(scanned) in (1, 2) else shapes[:2]
    profiles = [item for item in shapes if item not in rails]
    if not rails or not profiles or len(clouds) > 1:
        raise ValueError(
            translate(
                "{curves} curves and {clouds} clouds are selected. Select two rails, two or more "
                "profiles in order, and the cloud if there is one; or one rail that is a scanned "
                "edge, and its profiles."
            ).format(curves=len(shapes), clouds=len(clouds))
        )
    given = ", ".join([object_lines(rails), object_lines(profiles), *map(object_line, clouds)])
    return f"document.make_swept_surface(doc, {given})"
