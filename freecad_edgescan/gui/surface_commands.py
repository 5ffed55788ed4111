# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands for segments of clouds, surfaces fitted to them, and deviation maps."""

from __future__ import annotations

from typing import Any

import FreeCAD

from .command import Command
from .obstacles import no_cloud, no_cloud_or_shape, no_shape
from .recorded_step import object_line, object_lines
from .segment_command import SegmentCommand
from .selected import clouds_of, shapes_of
from .selection_command import SelectionCommand
from .translation import translate

__all__ = ["surface_commands"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def surface_commands() -> list[Command]:
    """All of them, in the order of the toolbar."""
    return [
        SegmentCommand(
            "EdgeScan_CloudSegment",
            QT_TRANSLATE_NOOP("EdgeScan_CloudSegment", "Segment cloud"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_CloudSegment",
                "Take the points near a surface, or of one face between edges, as a cloud of their "
                "own. Select the cloud and the surface; or a network of edges, then click on the "
                "face.",
            ),
            QT_TRANSLATE_NOOP(
                "EdgeScan_CloudSegment", "Select a cloud and a surface, or a network of edges"
            ),
            lambda chosen: _of_cloud_and_surface(chosen, "make_cloud_segment"),
            no_cloud_or_shape,
        ),
        SelectionCommand(
            "EdgeScan_FittedSurface",
            QT_TRANSLATE_NOOP("EdgeScan_FittedSurface", "Fit surface"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_FittedSurface",
                "Fit a surface to a cloud near another surface, between four edges, or round the "
                "plane, cylinder, cone or sphere that the cloud lies on. Select the cloud, and the "
                "surface or the four edges.",
            ),
            QT_TRANSLATE_NOOP(
                "EdgeScan_FittedSurface", "Select a cloud, and a surface near it or four edges"
            ),
            _fitted,
            no_cloud,
        ),
        SelectionCommand(
            "EdgeScan_ExtendSurface",
            QT_TRANSLATE_NOOP("EdgeScan_ExtendSurface", "Extend surface"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_ExtendSurface",
                "Make a surface longer over one of its sides. Select the surface; choose the side "
                "in its properties.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_ExtendSurface", "Select one surface"),
            _extended,
            no_shape,
        ),
        SelectionCommand(
            "EdgeScan_IntersectSurfaces",
            QT_TRANSLATE_NOOP("EdgeScan_IntersectSurfaces", "Intersect surfaces"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_IntersectSurfaces",
                "Find all curves in which two surfaces meet. Select two of them.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_IntersectSurfaces", "Select two surfaces"),
            _intersection,
            no_shape,
        ),
        SelectionCommand(
            "EdgeScan_TrimmedShell",
            QT_TRANSLATE_NOOP("EdgeScan_TrimmedShell", "Trim and sew surfaces"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_TrimmedShell",
                "Trim surfaces where they meet, drop what sticks out, and sew the rest into a "
                "shell. Select the surfaces, and the edges at which they end.",
            ),
            QT_TRANSLATE_NOOP(
                "EdgeScan_TrimmedShell", "Select surfaces, and the edges at which they end"
            ),
            _shell,
            no_shape,
        ),
        SelectionCommand(
            "EdgeScan_DeviationMap",
            QT_TRANSLATE_NOOP("EdgeScan_DeviationMap", "Deviation map"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_DeviationMap",
                "Show in colours how far a cloud is from a surface or part. Select the cloud and "
                "the surface or part.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_DeviationMap", "Select a cloud, and a surface or part"),
            lambda chosen: _of_cloud_and_surface(chosen, "make_deviation_map"),
            no_cloud_or_shape,
            covered=True,
        ),
    ]


def _of_cloud_and_surface(chosen: list[Any], make: str) -> str:
    clouds, shapes = clouds_of(chosen), shapes_of(chosen)
    if len(clouds) != 1 or len(shapes) != 1:
        raise ValueError(
            translate(
                "{clouds} clouds and {surfaces} surfaces are selected. Select two objects: one "
                "cloud and one surface."
            ).format(clouds=len(clouds), surfaces=len(shapes))
        )
    return f"document.{make}(doc, {object_line(clouds[0])}, {object_line(shapes[0])})"


def _fitted(chosen: list[Any]) -> str:
    clouds, (surfaces, edges) = clouds_of(chosen), _surfaces_and_edges(chosen)
    if len(clouds) != 1 or (len(surfaces), len(edges)) not in ((1, 0), (0, 4), (0, 0)):
        raise ValueError(
            translate(
                "{clouds} clouds, {surfaces} surfaces and {edges} edges are selected. Select one "
                "cloud, and with it one surface, or four edges, or nothing else."
            ).format(clouds=len(clouds), surfaces=len(surfaces), edges=len(edges))
        )
    cloud = object_line(clouds[0])
    if surfaces:
        return f"document.make_fitted_surface(doc, {cloud}, {object_line(surfaces[0])})"
    around = f", edges={object_lines(edges)}" if edges else ""
    return f"document.make_fitted_surface(doc, {cloud}{around})"


def _extended(chosen: list[Any]) -> str:
    shapes = shapes_of(chosen)
    if len(shapes) != 1:
        raise ValueError(
            translate(
                "{count} surfaces are selected. Select one, not two or none, to extend it."
            ).format(count=len(shapes))
        )
    return f"document.make_extended_surface(doc, {object_line(shapes[0])}, 'u1')"


def _shell(chosen: list[Any]) -> str:
    surfaces, edges = _surfaces_and_edges(chosen)
    if not surfaces:
        raise ValueError(
            translate(
                "{edges} edges and no surface are selected. Select the surfaces of a shell, and "
                "the edges at which they end."
            ).format(edges=len(edges))
        )
    at = f", {object_lines(edges)}" if edges else ""
    return f"document.make_trimmed_shell(doc, {object_lines(surfaces)}{at})"


def _intersection(chosen: list[Any]) -> str:
    shapes = shapes_of(chosen)
    if len(shapes) != 2:
        raise ValueError(
            translate("{count} surfaces are selected. Select two that meet.").format(
                count=len(shapes)
            )
        )
    first, second = (object_line(item) for item in shapes)
    return f"document.make_surface_intersection(doc, {first}, {second})"


def _surfaces_and_edges(chosen: list[Any]) -> tuple[list[Any], list[Any]]:
    """What has faces, and what has a shape without."""
    shapes = shapes_of(chosen)
    return (
        [item for item in shapes if item.Shape.Faces],
        [item for item in shapes if not item.Shape.Faces],
    )
