# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands for surfaces, sections, segments and deviation maps."""

from __future__ import annotations

from typing import Any

import FreeCAD

from .recorded_step import object_line
from .selected_shapes import is_scanned_edge
from .selection_command import SelectionCommand

__all__ = ["surface_commands"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def surface_commands() -> dict[str, SelectionCommand]:
    """All of them, by their names, in the order of the toolbar."""
    commands = (
        SelectionCommand(
            "EdgeScan_CloudSection",
            QT_TRANSLATE_NOOP("EdgeScan_CloudSection", "Profile of a cloud"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_CloudSection",
                "Cut a cloud across an edge and fit a line, arc or spline. Select the cloud and "
                "the edge, and another edge to which the profile leads.",
            ),
            _section,
        ),
        SelectionCommand(
            "EdgeScan_SweptSurface",
            QT_TRANSLATE_NOOP("EdgeScan_SweptSurface", "Swept surface"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_SweptSurface",
                "Sweep profiles along one or two rails, fitted to a cloud. Select the rails, then "
                "the profiles in order, and a cloud when there is one.",
            ),
            _swept,
        ),
        SelectionCommand(
            "EdgeScan_CloudSegment",
            QT_TRANSLATE_NOOP("EdgeScan_CloudSegment", "Segment of a cloud"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_CloudSegment",
                "Take the points near a surface as a cloud of their own. Select the cloud and the "
                "surface.",
            ),
            lambda chosen: _of_cloud_and_surface(chosen, "make_cloud_segment"),
        ),
        SelectionCommand(
            "EdgeScan_FittedSurface",
            QT_TRANSLATE_NOOP("EdgeScan_FittedSurface", "Fitted surface"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_FittedSurface",
                "Fit a surface to a cloud near another surface, between four edges, or round the "
                "plane, cylinder, cone or sphere that the cloud lies on. Select the cloud, and the "
                "surface or the four edges.",
            ),
            _fitted,
        ),
        SelectionCommand(
            "EdgeScan_ExtendSurface",
            QT_TRANSLATE_NOOP("EdgeScan_ExtendSurface", "Extended surface"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_ExtendSurface",
                "Make a surface longer over one of its sides. Select the surface; choose the side "
                "in its properties.",
            ),
            _extended,
        ),
        SelectionCommand(
            "EdgeScan_IntersectSurfaces",
            QT_TRANSLATE_NOOP("EdgeScan_IntersectSurfaces", "Intersect surfaces"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_IntersectSurfaces",
                "Find all curves in which two surfaces meet. Select two of them.",
            ),
            _intersection,
        ),
        SelectionCommand(
            "EdgeScan_TrimmedShell",
            QT_TRANSLATE_NOOP("EdgeScan_TrimmedShell", "Trim and sew surfaces"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_TrimmedShell",
                "Trim surfaces where they meet, drop what sticks out, and sew the rest into a "
                "shell. Select the surfaces, and the edges at which they end.",
            ),
            _shell,
        ),
        SelectionCommand(
            "EdgeScan_DeviationMap",
            QT_TRANSLATE_NOOP("EdgeScan_DeviationMap", "Deviation map"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_DeviationMap",
                "Show in colours how far a cloud is from a surface or part. Select the cloud and "
                "the surface or part.",
            ),
            lambda chosen: _of_cloud_and_surface(chosen, "make_deviation_map"),
        ),
    )
    return {command.name: command for command in commands}


def _told_apart(chosen: list[Any]) -> tuple[list[Any], list[Any]]:
    """The clouds and the shapes among the selected objects."""
    clouds = [item for item in chosen if item.isDerivedFrom("Points::Feature")]
    return clouds, [item for item in chosen if hasattr(item, "Shape")]


def _of_cloud_and_surface(chosen: list[Any], make: str) -> str:
    clouds, shapes = _told_apart(chosen)
    if len(clouds) != 1 or len(shapes) != 1:
        raise ValueError(
            f"{len(clouds)} clouds and {len(shapes)} surfaces are selected. Select two objects: "
            "one cloud and one surface."
        )
    return f"document.{make}(doc, {object_line(clouds[0])}, {object_line(shapes[0])})"


def _fitted(chosen: list[Any]) -> str:
    clouds, shapes = _told_apart(chosen)
    surfaces = [item for item in shapes if item.Shape.Faces]
    edges = [item for item in shapes if not item.Shape.Faces]
    if len(clouds) != 1 or (len(surfaces), len(edges)) not in ((1, 0), (0, 4), (0, 0)):
        raise ValueError(
            f"{len(clouds)} clouds, {len(surfaces)} surfaces and {len(edges)} edges are selected. "
            "Select one cloud, and with it one surface, or four edges, or nothing else."
        )
    cloud = object_line(clouds[0])
    if surfaces:
        return f"document.make_fitted_surface(doc, {cloud}, {object_line(surfaces[0])})"
    around = f", edges=[{', '.join(object_line(item) for item in edges)}]" if edges else ""
    return f"document.make_fitted_surface(doc, {cloud}{around})"


def _section(chosen: list[Any]) -> str:
    clouds, shapes = _told_apart(chosen)
    if len(clouds) != 1 or len(shapes) not in (1, 2):
        raise ValueError(
            f"{len(clouds)} clouds and {len(shapes)} edges are selected. Select two or three "
            "objects: one cloud, the edge to cut across, and another edge if there is one."
        )
    cloud, rail = object_line(clouds[0]), object_line(shapes[0])
    towards = f", towards={object_line(shapes[1])}" if len(shapes) == 2 else ""
    return f"document.make_cloud_section(doc, {cloud}, {rail}{towards})"


def _swept(chosen: list[Any]) -> str:
    clouds, shapes = _told_apart(chosen)
    scanned = [item for item in shapes if is_scanned_edge(item)]
    rails = scanned if len(scanned) in (1, 2) else shapes[:2]
    profiles = [item for item in shapes if item not in rails]
    if not rails or not profiles or len(clouds) > 1:
        raise ValueError(
            f"{len(shapes)} curves and {len(clouds)} clouds are selected. Select two rails, two or "
            "more profiles in order, and the cloud if there is one; or one rail that is a scanned "
            "edge, and its profiles."
        )
    rail_list, profile_list = (
        f"[{', '.join(object_line(item) for item in items)}]" for items in (rails, profiles)
    )
    cloud = f", {object_line(clouds[0])}" if clouds else ""
    return f"document.make_swept_surface(doc, {rail_list}, {profile_list}{cloud})"


def _extended(chosen: list[Any]) -> str:
    _, shapes = _told_apart(chosen)
    if len(shapes) != 1:
        raise ValueError(
            f"{len(shapes)} surfaces are selected. Select one, not two or none, to extend it."
        )
    return f"document.make_extended_surface(doc, {object_line(shapes[0])}, 'u1')"


def _shell(chosen: list[Any]) -> str:
    _, shapes = _told_apart(chosen)
    surfaces = [item for item in shapes if item.Shape.Faces]
    edges = [item for item in shapes if not item.Shape.Faces]
    if not surfaces:
        raise ValueError(
            f"{len(edges)} edges and no surface are selected. Select the surfaces of a shell, and "
            "the edges at which they end."
        )
    surface_list, edge_list = (
        f"[{', '.join(object_line(item) for item in items)}]" for items in (surfaces, edges)
    )
    return f"document.make_trimmed_shell(doc, {surface_list}{f', {edge_list}' if edges else ''})"


def _intersection(chosen: list[Any]) -> str:
    _, shapes = _told_apart(chosen)
    if len(shapes) != 2:
        raise ValueError(f"{len(shapes)} surfaces are selected. Select two that meet.")
    first, second = (object_line(item) for item in shapes)
    return f"document.make_surface_intersection(doc, {first}, {second})"
