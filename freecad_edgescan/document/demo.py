# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demonstration: a simulated scan of the core box becomes edges, sweeps and lofts.

1. the core-box cloud, as the published case study scanned its part;
2. its rims, each from a start to a gate;
3. per pipe arc profiles from end to end, a sweep of the first and a loft through all, and a sweep
   along both rims, fitted to the cloud;
4. a document, a STEP file, a table of edge points, and pictures.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import FreeCAD
import numpy as np

from ..cloud import CoreBox, TrueEdge
from ..experiments import draw_errors, draw_section
from ..scanning import Gate, Progress, ScannedEdge, ScanParameters, Start
from .appearance import Look, write_appearance
from .cloud_object import make_cloud
from .demo_pipes import DemoSurface, make_pipe
from .export import export_step
from .scanned_edge import make_scanned_edge, scan_again, write_result

__all__ = ["DemoEdge", "make_demo"]

NAME = "corebox"
VIEW = (0.0, -0.7, 1.0)  # from the part towards the viewer
CLOUD_LOOK = Look(colour=(0.75, 0.78, 0.80), transparency=80)
EDGE_LOOK = Look(
    colour=(0.84, 0.37, 0.0),
    line_colour=(0.84, 0.37, 0.0),
    line_width=4.0,
    view=("freecad_edgescan.gui.scanned_edge_view", "ViewProviderScannedEdge"),
)
PROFILE_LOOK = Look(colour=(0.1, 0.1, 0.1), line_colour=(0.1, 0.1, 0.1), line_width=1.0)
LOFT_LOOK = Look(colour=(0.34, 0.71, 0.91), line_colour=(0.0, 0.2, 0.4), visible=False)
COMPUTED_VIEW = ("freecad_edgescan.gui.computed_view", "ViewProviderComputed")
FITTED_LOOK = Look(colour=(0.34, 0.71, 0.91), line_colour=(0.0, 0.2, 0.4), view=COMPUTED_VIEW)
COMPUTED_LOOK = Look(
    colour=(0.1, 0.1, 0.1), line_colour=(0.1, 0.1, 0.1), visible=False, view=COMPUTED_VIEW
)
MAP_LOOK = Look(
    colour=(0.1, 0.1, 0.1),
    visible=False,
    view=("freecad_edgescan.gui.deviation_map_view", "ViewProviderDeviationMap"),
)
SWEEP_LOOK = Look(
    colour=(0.0, 0.62, 0.45),
    line_colour=(0.0, 0.2, 0.1),
    visible=False,
    view=("freecad_edgescan.gui.sweep_view", "ViewProviderSweep"),
)
_BESIDE = 20.0  # pitches, twice the distance of starts and gates from the rims
_PROFILES = 17  # per pipe; fewer, and the loft leaves the wall in the bends


@dataclass(frozen=True)
class DemoEdge:
    """One row of the demonstration's table; lengths mm."""

    truth: TrueEdge
    edge: ScannedEdge
    seconds: float

    @property
    def errors(self) -> np.ndarray:
        """Distances of the edge points from the true edge, (m,) mm."""
        return self.truth.distance(self.edge.points)


def make_demo(
    folder: str | Path = "demo",
    progress: Progress | None = None,
    box: CoreBox | None = None,
    pitch: float = 0.5,
    amplitude: float | None = None,
    profiles: int = _PROFILES,
) -> str:
    """Run the demonstration.

    Parameters
    ----------
    folder : where corebox.FCStd, .step, .csv and the pictures go; made when missing
    progress : told the share that is done; where it answers False, what there is so far is kept
    box : the part; None: the case study's at full size
    pitch : of the simulated scan, mm
    amplitude : of the scan lines, mm; None: automatic
    profiles : how many the loft of each pipe goes through

    Returns
    -------
    The tables that compare edges and surfaces with the truth, and what was written, as text.
    """
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    box = box or CoreBox()
    steps = _Steps(progress, len(box.edges) + 2)
    steps.begin("simulating the scan")
    numbers = box.cloud(pitch)
    doc = FreeCAD.newDocument(NAME)
    try:
        cloud = make_cloud(doc, numbers, name="CoreBox")
        cloud.Label = "Core box"
        places = amplitude or _BESIDE * pitch
        rows, rails = _scan_rims(
            doc, cloud, box, ScanParameters(amplitude=amplitude), places, steps
        )
        steps.begin("sweeping, lofting and fitting")
        surfaces, notes = _make_pipes(doc, cloud, box, rails, profiles)
        notes += _write(target, doc, numbers, rows)
    finally:
        FreeCAD.closeDocument(doc.Name)
    return "\n".join([_table(rows), "", _surface_table(surfaces), "", *notes])


def _scan_rims(
    doc: Any,
    cloud: Any,
    box: CoreBox,
    parameters: ScanParameters,
    places: float,
    steps: _Steps,
) -> tuple[list[DemoEdge], list[Any]]:
    """Scan each rim of the box; a rim that was not found leaves None among the rails."""
    rows: list[DemoEdge] = []
    rails: list[Any] = []
    ways = zip(box.edges, box.starts(places), box.gates(places), strict=True)
    for truth, start, gate in ways:
        steps.begin(truth.name)
        rail = make_scanned_edge(
            doc,
            cloud,
            at=Start(*start),
            gate=Gate(*gate),
            parameters=parameters,
            name=truth.name.title().replace(" ", ""),
        )
        began = perf_counter()
        edge = scan_again(rail, steps)
        seconds = perf_counter() - began
        if len(edge.points) < 2:
            doc.removeObject(rail.Name)
            rails.append(None)
            continue
        write_result(rail, edge)
        rows.append(DemoEdge(truth, edge, seconds))
        rails.append(rail)
    doc.recompute()
    return rows, rails


def _make_pipes(
    doc: Any, cloud: Any, box: CoreBox, rails: list[Any], profiles: int
) -> tuple[list[DemoSurface], list[str]]:
    """Sweep and loft between each pair of rails; what could not be made, as sentences."""
    surfaces, notes = [], []
    pairs = zip(rails[::2], rails[1::2], box.pipes, strict=True)
    for number, (left, right, pipe) in enumerate(pairs, start=1):
        if left is None or right is None:
            continue
        try:
            surfaces += make_pipe(doc, cloud, (left, right), pipe, number, profiles)
        except ValueError as error:
            notes.append(f"Pipe {number}: {error}")
    return surfaces, notes


def _write(target: Path, doc: Any, numbers: Any, rows: list[DemoEdge]) -> list[str]:
    """Write all files; the sentences name them, and what is missing."""
    notes = []
    file = target / f"{NAME}.FCStd"
    file.unlink(missing_ok=True)  # FreeCAD would keep the last demonstration as a backup
    doc.saveAs(str(file.resolve()))
    write_appearance(file, _looks(doc), numbers.bounds, VIEW)
    shapes = [
        obj
        for obj in doc.Objects
        if hasattr(obj, "Shape") and not obj.Shape.isNull() and "Invalid" not in obj.State
    ]
    written = [f"{NAME}.FCStd"]
    if shapes:
        export_step(shapes, target / f"{NAME}.step")
        written.append(f"{NAME}.step")
    _write_csv(rows, target / f"{NAME}.csv")
    written.append(f"{NAME}.csv")
    if rows:
        try:
            edges = [row.edge for row in rows]
            draw_errors(numbers, edges, [row.truth for row in rows], target / f"{NAME}.png")
            draw_section(edges[-1], len(edges[-1].points) // 2, target / f"{NAME}-section.png")
            written += [f"{NAME}.png", f"{NAME}-section.png"]
        except ValueError as error:
            notes.append(str(error))
    return [*notes, f"Wrote {', '.join(written)} in {target}."]


def _looks(doc: Any) -> dict[str, Look]:
    """Edges and fitted sweeps shine through the probe centres; what leads to them is hidden."""
    look_of = {
        "Points::Feature": CLOUD_LOOK,
        "ScannedEdgeProxy": EDGE_LOOK,
        "Part::Feature": PROFILE_LOOK,
        "SweepProxy": SWEEP_LOOK,
        "SweptSurfaceProxy": FITTED_LOOK,
        "CloudSectionProxy": COMPUTED_LOOK,
        "CloudSegmentProxy": COMPUTED_LOOK,
        "DeviationMapProxy": MAP_LOOK,
        "Part::Loft": LOFT_LOOK,
    }
    kinds = {
        obj.Name: type(obj.Proxy).__name__ if hasattr(obj, "Proxy") else obj.TypeId
        for obj in doc.Objects
    }
    looks = {name: look_of[kind] for name, kind in kinds.items() if kind in look_of}
    bases = {name: COMPUTED_LOOK for name in looks if name.endswith("Base")}
    return {**looks, **bases}


def _write_csv(rows: list[DemoEdge], path: Path) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["edge", "x_mm", "y_mm", "z_mm", "sigma_mm", "error_mm"])
        for row in rows:
            values = np.column_stack([row.edge.points, row.edge.sigma, row.errors])
            writer.writerows([row.truth.name, *(f"{x:.6f}" for x in line)] for line in values)


def _table(rows: list[DemoEdge]) -> str:
    lines = [
        "edge     points   stop     average   maximum   mean sigma   seconds",
        "                           error mm  error mm  mm",
    ]
    lines += [
        f"{row.truth.name:<8} {len(row.edge.points):6d}   {row.edge.stops[1].name:<8} "
        f"{row.errors.mean():8.4f}  {row.errors.max():8.4f}  {row.edge.sigma.mean():8.4f}   "
        f"{row.seconds:8.2f}"
        for row in rows
    ]
    return "\n".join(lines)


def _surface_table(surfaces: list[DemoSurface]) -> str:
    lines = [
        "surface        profiles   valid   average   maximum",
        "                                  distance from the true wall, mm",
    ]
    for surface in surfaces:
        valid = "yes" if surface.valid else "no"
        line = f"{surface.name:<14} {surface.profiles:8d}   {valid:<5}"
        if surface.valid:
            line += f"  {surface.deviation.mean():8.4f}  {surface.deviation.max():8.4f}"
        lines.append(line)
    lines.append("A sweep moves one profile: it cannot follow the pipes, which narrow.")
    lines += [
        f"{surface.name}: the cloud's points are {surface.from_cloud[0]:.4f} mm from it on "
        f"average, {surface.from_cloud[1]:.4f} mm at most."
        for surface in surfaces
        if surface.from_cloud is not None
    ]
    return "\n".join(lines)


class _Steps:
    """Progress of several tasks as one."""

    def __init__(self, progress: Progress | None, count: int) -> None:
        self._progress = progress
        self._count = count
        self._done = -1

    def begin(self, task: str) -> None:
        self._done += 1
        self.update(0.0, task)

    def update(self, fraction: float, so_far: object) -> bool:
        if self._progress is None:
            return True
        share = 0.0 if np.isnan(fraction) else fraction
        return self._progress.update((self._done + share) / self._count, so_far)
