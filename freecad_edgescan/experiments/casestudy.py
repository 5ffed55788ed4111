# SPDX-License-Identifier: LGPL-2.1-or-later
"""The case study again: from the raster of a core box to swept surfaces of its two pipes.

Schreve chapter 7: edges are scanned and become rails, profiles stand at their ends, base surfaces
of both cut the cloud, and sweeps are fitted to what was cut out. Here in both models, to the 5 mm
grid that was used and to the whole compensated cloud; the pipes' exact walls are known.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from ..cloud import CoreBox, PointCloud, compensate_cloud, thin_cloud
from ..geometry import BSplineCurve
from ..scanning import Gate, Progress, ScannedEdge, Start, scan_edge
from ..surfacing import (
    CrossSection,
    SweepModel,
    SweptFit,
    SweptSurface,
    cross_section,
    fit_swept_surface,
)
from ..surfacing.compensated_segment import compensated_segment
from .casestudy_published import GRIDS, SEGMENT_DISTANCE, THINNED_PITCH
from .true_wall import deviation_from_wall, surface_from_wall

__all__ = ["CaseStudy", "CaseStudyFit", "CaseStudyPipe", "casestudy_places", "run_casestudy"]

Array = NDArray[np.float64]

_BESIDE = 20.0  # pitches, twice the distance of starts and gates from the rims


@dataclass(frozen=True, eq=False)
class CaseStudyFit:
    """One sweep fitted to one cloud.

    Attributes
    ----------
    grid : control points along the rails and along the profiles
    model : of the sweep
    thinned : whether to the 5 mm grid; else to the whole cloud
    fit : SweptFit
    error : (k,) mm, distances of places all over the surface from the true wall
    """

    grid: tuple[int, int]
    model: SweepModel
    thinned: bool
    fit: SweptFit
    error: Array = field(repr=False)


@dataclass(frozen=True, eq=False)
class CaseStudyPipe:
    """One pipe.

    Attributes
    ----------
    number : from 1
    rails : curves as scanned, which need not end opposite each other
    sections : of the cloud, from either end of the first rail to the second
    points : (n, 3) mm, compensated points of the wall
    thinned : (m, 3) mm, those of them on the 5 mm grid
    noise : (n,) mm, distances of the points from the true wall
    fits : in the order in which they were made
    """

    number: int
    rails: tuple[BSplineCurve, BSplineCurve]
    sections: tuple[CrossSection, CrossSection]
    points: Array = field(repr=False)
    thinned: Array = field(repr=False)
    noise: Array = field(repr=False)
    fits: tuple[CaseStudyFit, ...] = ()

    def base(self, model: SweepModel) -> SweptSurface:
        """The sweep along the rails as scanned, before it is fitted."""
        return _base(self.rails, self.sections, model)

    def fit(self, model: SweepModel, grid: tuple[int, int], thinned: bool) -> CaseStudyFit | None:
        """The fit of a model and grid, or None when the study was stopped before it."""
        wanted = (model, grid, thinned)
        found = [own for own in self.fits if (own.model, own.grid, own.thinned) == wanted]
        return found[0] if found else None


@dataclass(frozen=True, eq=False)
class CaseStudy:
    """What the study found.

    Attributes
    ----------
    edges : the rims, as far as they were scanned
    pipes : those with two scanned rims
    seconds : of each step, by its name
    cancelled : whether it was stopped before its end
    """

    edges: tuple[ScannedEdge, ...]
    pipes: tuple[CaseStudyPipe, ...]
    seconds: dict[str, float]
    cancelled: bool


def run_casestudy(
    cloud: PointCloud,
    box: CoreBox,
    progress: Progress | None = None,
    grids: Sequence[tuple[int, int]] = GRIDS,
    thinned_pitch: float = THINNED_PITCH,
) -> CaseStudy:
    """Fit swept surfaces to the pipes of a core box.

    Parameters
    ----------
    cloud : PointCloud
        Of the box, such as ``box.cloud()``: centres of its probe.
    box : CoreBox
        Where the scans start and end; its true walls, with which the surfaces are compared.
    progress : object with ``update(fraction, so_far) -> bool``, optional
        Told the share that is done and the step; when it answers False, what there is so far is
        the result.
    grids : numbers of control points along the rails and along the profiles
    thinned_pitch : mm, of the thinned cloud

    Returns
    -------
    CaseStudy

    Raises
    ------
    ValueError: a rim or profile of which the cloud holds too little.
    """
    steps = _Steps(progress, 2.0 * len(box.pipes) + 4.0 + 4.0 * len(box.pipes) * len(grids))
    edges = _scan_edges(cloud, box, steps)
    pipes = [] if steps.cancelled else _pipes(cloud, edges, box, thinned_pitch, steps)
    fitted = [_fitted(pipe, box, grids, steps) for pipe in pipes]
    return CaseStudy(tuple(edges), tuple(fitted), steps.seconds, steps.cancelled)


def casestudy_places(pitch: float, box: CoreBox) -> list[tuple[Sequence[Array], Sequence[Array]]]:
    """For each rim the arguments of `Start` and `Gate` of its scan, given the cloud's pitch, mm."""
    beside = _BESIDE * pitch
    return list(zip(box.starts(beside), box.gates(beside), strict=True))


def _scan_edges(cloud: PointCloud, box: CoreBox, steps: _Steps) -> list[ScannedEdge]:
    edges: list[ScannedEdge] = []
    for number, (start, gate) in enumerate(casestudy_places(cloud.pitch, box), 1):
        with steps.step("scan edges", f"rim {number}"):
            edges.append(scan_edge(cloud, Start(*start), Gate(*gate), progress=steps))
        if steps.cancelled:
            break
    return edges


def _pipes(
    cloud: PointCloud, edges: list[ScannedEdge], box: CoreBox, pitch: float, steps: _Steps
) -> list[CaseStudyPipe]:
    pipes = []
    with steps.step("rails"):
        curves = [edge.curve() for edge in edges]
        pairs = list(zip(curves[::2], curves[1::2], strict=True))
    with steps.step("compensate and segment"):
        compensated = compensate_cloud(cloud)
    with steps.step("profiles and base surfaces"):
        sections = [_end_sections(compensated, *rails) for rails in pairs]
    with steps.step("compensate and segment"):
        for number, (rails, own) in enumerate(zip(pairs, sections, strict=True), 1):
            base = _base(rails, own, SweepModel.ROTATE).to_bspline(1e-2)
            points = compensated_segment(cloud, base, SEGMENT_DISTANCE, compensated)
            thinned = thin_cloud(PointCloud(points), pitch).points
            noise = deviation_from_wall(box.pipes[number - 1], points)
            pipes.append(CaseStudyPipe(number, rails, own, points, thinned, noise))
    return pipes


def _end_sections(
    cloud: PointCloud, first: BSplineCurve, second: BSplineCurve
) -> tuple[CrossSection, CrossSection]:
    """The sections from the first rail's ends to the second rail, which may go on beyond them."""
    start, end = (cross_section(cloud, first, share, second) for share in (0.0, 1.0))
    return start, end


def _base(
    rails: tuple[BSplineCurve, BSplineCurve],
    sections: tuple[CrossSection, CrossSection],
    model: SweepModel,
) -> SweptSurface:
    profiles = tuple(section.curve for section in sections)
    return SweptSurface(rails, profiles, model, cut_rails=True)


def _fitted(
    pipe: CaseStudyPipe, box: CoreBox, grids: Sequence[tuple[int, int]], steps: _Steps
) -> CaseStudyPipe:
    fits = []
    bases = {model: pipe.base(model) for model in SweepModel}
    for thinned in (True, False):
        points = pipe.thinned if thinned else pipe.points
        for grid in grids:
            for model, base in bases.items():
                if steps.cancelled:
                    break
                with steps.step("fit swept surfaces", f"pipe {pipe.number}, {model}"):
                    fit = fit_swept_surface(points, base, grid, steps)
                if steps.cancelled:
                    break
                error = surface_from_wall(box.pipes[pipe.number - 1], fit.surface)
                fits.append(CaseStudyFit(grid, model, thinned, fit, error))
    return replace(pipe, fits=tuple(fits))


class _Steps:
    """Progress of several tasks as one, and the time that each kind of task took."""

    def __init__(self, progress: Progress | None, count: float) -> None:
        self._progress, self._count = progress, count
        self._done = 0
        self._task = ""
        self.seconds: dict[str, float] = {}
        self.cancelled = False

    @contextmanager
    def step(self, name: str, task: str | None = None) -> Iterator[None]:
        self._task = name if task is None else task
        began = perf_counter()
        self.update(0.0, None)
        yield
        self._done += 1
        self.seconds[name] = self.seconds.get(name, 0.0) + perf_counter() - began

    def update(self, fraction: float, so_far: object) -> bool:
        share = 0.0 if np.isnan(fraction) else fraction
        whole = min((self._done + share) / self._count, 1.0)
        if self._progress is not None and not self._progress.update(whole, self._task):
            self.cancelled = True
        return not self.cancelled
