# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan sweep``: scanned edges as rails and profiles of a surface, held against the cloud."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from freecad_edgescan.cloud import PointCloud, compensate_cloud
from freecad_edgescan.cloud_file import cloud_of
from freecad_edgescan.cut_by_region import outside_region
from freecad_edgescan.edge_table import edge_table
from freecad_edgescan.geometry import BSplineCurve, BSplineSurface
from freecad_edgescan.output_files import PICTURES, check_output
from freecad_edgescan.place_in_unit import place_in_unit
from freecad_edgescan.scanning import scan_edge
from freecad_edgescan.surfacing import (
    Deviation,
    SweepModel,
    SweptFit,
    SweptSurface,
    compare_sweep_models,
    cross_section,
    deviation,
    fit_swept_surface,
)
from freecad_edgescan.surfacing.compensated_segment import compensated_segment
from freecad_edgescan.terminal_progress import TerminalProgress, exit_code
from freecad_edgescan.told_besides import told_besides

__all__ = ["sweep_file"]

_TOLERANCE = 0.02  # of the cloud's pitch: of the surface against the sweep


def sweep_file(options: argparse.Namespace) -> int:
    """Scan rails and profiles, sweep, fit where there are two rails, write, print."""
    _check(options)
    cloud = cloud_of(options)
    with TerminalProgress("sweep") as progress:
        clicks = [*options.rail, *options.profile]
        edges = {}
        for number, at in enumerate(clicks, 1):
            with told_besides(
                outside_region(at, options.region), place_in_unit(at, cloud, options.unit)
            ):
                edges[number] = scan_edge(cloud, at, progress=progress)
        if progress.cancelled:
            return exit_code(progress, found=False)
        curves = [edge.curve() for edge in edges.values()]
        rails, profiles = curves[: len(options.rail)], curves[len(options.rail) :]
        profiles = profiles or _end_profiles(cloud, rails)
        base = SweptSurface(tuple(rails), tuple(profiles), SweepModel.ROTATE, cut_rails=True)
        surface = base.to_bspline(_TOLERANCE * cloud.pitch)
        points = compensated_segment(cloud, surface, options.distance, progress=progress)
        if len(points) == 0:
            raise ValueError(
                f"No point of the cloud is within {options.distance:g} mm of the sweep; give a "
                "larger --distance, or other rails and profiles."
            )
        if len(rails) == 2:
            fit = _fitted(points, base, options)
            surface, found, message = fit.surface, _as_deviation(fit), fit.message
        else:
            found, message = deviation(points, surface), base.message
    _write(options, surface, points, found)
    print(edge_table(edges))
    print(_said(found, options.distance, fitted=len(rails) == 2))
    if message:
        print(message)
    for path in (*options.output, *([options.picture] if options.picture else [])):
        print(f"Wrote {path}")
    return exit_code(progress)


def _check(options: argparse.Namespace) -> None:
    if len(options.rail) not in (1, 2):
        raise ValueError(
            f"sweep takes one or two --rail X,Y,Z, points near edges, not {len(options.rail)}; "
            "edgescan info FILE --picture part.png draws where they are."
        )
    if len(options.rail) == 1 and not options.profile:
        raise ValueError(
            "Along one --rail a --profile X,Y,Z is swept, a point near an edge across it; give it, "
            "or a second --rail."
        )
    if not options.distance > 0.0:
        raise ValueError(f"The --distance is {options.distance:g} mm; give a positive length.")
    for path in options.output:
        check_output(path, (".step", ".stp", ".csv"), options.file)
    if options.picture:
        check_output(options.picture, PICTURES, options.file)


def _end_profiles(cloud: PointCloud, rails: Sequence[BSplineCurve]) -> list[BSplineCurve]:
    """Sections of the cloud from the first rail's ends to the second rail."""
    surface = compensate_cloud(cloud)
    return [cross_section(surface, rails[0], share, rails[1]).curve for share in (0.0, 1.0)]


def _fitted(points: np.ndarray, base: SweptSurface, options: argparse.Namespace) -> SweptFit:
    control_points = (options.poles[0], options.poles[1])
    if len(base.profiles) > 2:
        return fit_swept_surface(points, base, control_points)
    return next(iter(compare_sweep_models(points, base, control_points).values()))


def _as_deviation(fit: SweptFit) -> Deviation:
    return Deviation(fit.deviation, fit.outside, fit.parameters)


def _said(found: Deviation, distance: float, fitted: bool) -> str:
    inside = np.abs(found.deviation[~found.outside])
    shares = np.percentile(inside, [50, 90, 99])
    return (
        f"{len(inside)} points lie within {distance:g} mm of the "
        f"{'fitted sweep' if fitted else 'sweep, which was not fitted to them'}:\n"
        f"average {found.average:.4f} mm, rms {found.rms:.4f}, maximum {found.maximum:.4f}; half "
        f"within {shares[0]:.4f}, 90 % within {shares[1]:.4f}, 99 % within {shares[2]:.4f}"
    )


def _write(
    options: argparse.Namespace, surface: BSplineSurface, points: np.ndarray, found: Deviation
) -> None:
    for path in options.output:
        if path.suffix.lower() == ".csv":
            found.to_csv(points, path)
        else:
            _write_step(surface, path)
    if options.picture:
        from freecad_edgescan.experiments.deviation_picture import draw_deviations

        inside = ~found.outside
        panels = {"Deviation from the sweep": (points[inside], found.deviation[inside])}
        draw_deviations(panels, options.picture, options.view or (0.0, 0.0, 1.0))


def _write_step(surface: BSplineSurface, path: Path) -> None:
    try:
        from freecad_edgescan.document import export_step
        from freecad_edgescan.document.native_surface import surface_shape
    except ImportError as error:
        raise ValueError(
            f"{path} needs FreeCAD, which did not load ({error}); write .csv instead."
        ) from error
    export_step([surface_shape(surface)], path)
