# SPDX-License-Identifier: LGPL-2.1-or-later
"""The case study as files: document, STEP, table of deviations, and pictures."""

from __future__ import annotations

import csv
from pathlib import Path
from time import perf_counter
from typing import Any

import FreeCAD
import numpy as np

from ..cloud import CoreBox, read_cloud, write_cloud
from ..experiments.casestudy import CaseStudy, run_casestudy
from ..experiments.casestudy_published import GRIDS
from ..experiments.casestudy_tables import casestudy_tables
from ..experiments.deviation_picture import draw_deviations
from ..scanning import Progress
from ..surfacing import SweepModel
from .appearance import write_appearance
from .casestudy_document import casestudy_looks, fill_document
from .cloud_cache import point_cloud
from .cloud_object import make_cloud
from .export import export_step

__all__ = ["make_casestudy"]

NAME = "casestudy"
VIEW = (0.0, -0.7, 1.0)  # from the part towards the viewer


def make_casestudy(
    folder: str | Path = NAME,
    progress: Progress | None = None,
    box: CoreBox | None = None,
    pitch: float = 0.5,
    grids: tuple[tuple[int, int], ...] = GRIDS,
    thinned_pitch: float | None = None,
) -> str:
    """Run the case study.

    Parameters
    ----------
    folder : where casestudy.FCStd, .step, .csv, the raster and the pictures go; made when missing
    progress : told the share that is done; where it answers False, what there is so far is kept
    box : the part; None: that of the published study in our own dimensions
    pitch : of the simulated scan, mm
    grids : control points along the rails and along the profiles; the document gets the last
    thinned_pitch : mm, of the grid of the thinned cloud; None: as published

    Returns
    -------
    The tables of deviations and times, and what was written, as text.
    """
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    box = box or CoreBox()
    if progress is not None:
        progress.update(0.0, "simulating the scan")
    raster = target / f"{NAME}-raster.ply"
    simulated = box.cloud(pitch)
    write_cloud(simulated, raster)
    doc = FreeCAD.newDocument(NAME)
    try:
        began = perf_counter()
        numbers = read_cloud(
            raster, probe_radius=simulated.probe_radius, approach=simulated.approach
        )
        cloud = make_cloud(doc, numbers, name="CoreBox")
        seconds = {"read the cloud": perf_counter() - began}
        options = {} if thinned_pitch is None else {"thinned_pitch": thinned_pitch}
        study = run_casestudy(point_cloud(cloud), box, progress, grids, **options)
        seconds |= study.seconds
        began = perf_counter()
        shapes = fill_document(doc, cloud, box, study)
        notes = _write(target, doc, shapes, study)
        seconds["write all files"] = perf_counter() - began
    finally:
        FreeCAD.closeDocument(doc.Name)
    return "\n".join([casestudy_tables(study, seconds), "", *notes])


def _write(target: Path, doc: Any, shapes: list[Any], study: CaseStudy) -> list[str]:
    """Write all files; the sentences name them, and what is missing."""
    file = target / f"{NAME}.FCStd"
    file.unlink(missing_ok=True)  # FreeCAD would keep the last study as a backup
    doc.saveAs(str(file.resolve()))
    points = np.concatenate([pipe.points for pipe in study.pipes] or [np.zeros((1, 3))])
    write_appearance(file, casestudy_looks(doc), (points.min(axis=0), points.max(axis=0)), VIEW)
    written, notes = [f"{NAME}-raster.ply", f"{NAME}.FCStd"], []
    if shapes:
        export_step(shapes, target / f"{NAME}.step")
        written.append(f"{NAME}.step")
    panels = _panels(study)
    if study.pipes:
        _write_csv(study, target / f"{NAME}.csv")
        written.append(f"{NAME}.csv")
    if panels:
        try:
            draw_deviations(panels, target / f"{NAME}.png")
            written.append(f"{NAME}.png")
        except ValueError as error:
            notes.append(str(error))
    return [*notes, f"Wrote {', '.join(written)} in {target}."]


def _panels(study: CaseStudy) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Points of all pipes and their deviations from the last fit of each model."""
    panels = {}
    for model in SweepModel:
        points, deviations = [], []
        for pipe in study.pipes:
            whole = [own.fit for own in pipe.fits if own.model == model and not own.thinned]
            for fit in whole[-1:]:
                points.append(pipe.points[~fit.outside])
                deviations.append(fit.deviation[~fit.outside])
        if points:
            panels[f"{model} model"] = (np.concatenate(points), np.concatenate(deviations))
    return panels


def _write_csv(study: CaseStudy, path: Path) -> None:
    columns = "pipe rail_poles profile_poles cloud model points average_mm maximum_mm rms_mm"
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([*columns.split(), "true_average_mm", "true_maximum_mm"])
        for pipe in study.pipes:
            for own in pipe.fits:
                fit, cloud = own.fit, "thinned" if own.thinned else "whole"
                count = int((~fit.outside).sum())
                numbers = (fit.average, fit.maximum, fit.rms, own.error.mean(), own.error.max())
                printed = (f"{value:.6f}" for value in numbers)
                writer.writerow([pipe.number, *own.grid, cloud, own.model, count, *printed])
