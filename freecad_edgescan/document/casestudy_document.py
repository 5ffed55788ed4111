# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the case study found, as parametric objects that have nothing left to compute."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from ..cloud import CoreBox
from ..experiments.casestudy import CaseStudy, CaseStudyPipe, casestudy_places
from ..scanning import Gate, Start
from ..surfacing import SweepModel
from .appearance import Look
from .cloud_cache import point_cloud
from .cloud_section import make_cloud_section
from .cloud_segment import make_cloud_segment
from .computed_object import write_computed
from .deviation_map import make_deviation_map
from .scanned_edge import make_scanned_edge, write_result
from .swept_surface import make_swept_surface

__all__ = ["casestudy_looks", "fill_document"]

_VIEW = ("freecad_edgescan.gui.computed_view", "ViewProviderComputed")
_EDGE = Look(
    colour=(0.84, 0.37, 0.0),
    line_colour=(0.84, 0.37, 0.0),
    line_width=4.0,
    view=("freecad_edgescan.gui.scanned_edge_view", "ViewProviderScannedEdge"),
)
_CLOUD = Look(colour=(0.75, 0.78, 0.80), transparency=80)
_SEGMENT = Look(colour=(0.0, 0.45, 0.70), visible=False, view=_VIEW)
_MAP = replace(
    _SEGMENT, view=("freecad_edgescan.gui.deviation_map_view", "ViewProviderDeviationMap")
)
_PROFILE = Look(colour=(0.1, 0.1, 0.1), line_colour=(0.1, 0.1, 0.1), line_width=2.0, view=_VIEW)
_SURFACES = {
    "Base": Look(colour=(0.8, 0.8, 0.8), line_colour=(0.4, 0.4, 0.4), visible=False, view=_VIEW),
    "Rotate": Look(colour=(0.34, 0.71, 0.91), line_colour=(0.0, 0.2, 0.4), view=_VIEW),
    "Blend": Look(colour=(0.9, 0.6, 0.0), line_colour=(0.4, 0.2, 0.0), visible=False, view=_VIEW),
}


def fill_document(doc: Any, cloud: Any, box: CoreBox, study: CaseStudy) -> list[Any]:
    """Put edges, profiles, base surfaces, segments and fitted sweeps into a document.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature that was studied
    box : CoreBox
    study : CaseStudy of the cloud

    Returns
    -------
    The edges and the fitted surfaces in the rotate model.
    """
    places = casestudy_places(point_cloud(cloud).pitch, box)
    edges = []
    for number, (edge, (start, gate)) in enumerate(zip(study.edges, places, strict=False), 1):
        if len(edge.points) < 2:
            break
        rim = make_scanned_edge(doc, cloud, Start(*start), Gate(*gate), name=f"Rim{number}")
        write_result(rim, edge)
        edges.append(rim)
    shapes = list(edges)
    for pipe in study.pipes:
        rails = edges[2 * pipe.number - 2 : 2 * pipe.number]
        shapes += _make_surfaces(doc, cloud, rails, pipe)
    doc.recompute()
    return shapes


def _make_surfaces(doc: Any, cloud: Any, rails: list[Any], pipe: CaseStudyPipe) -> list[Any]:
    profiles = []
    for end, section in enumerate(pipe.sections):
        name = f"Pipe{pipe.number}Profile{end + 1}"
        profile = make_cloud_section(doc, cloud, rails[0], float(end), rails[1], name=name)
        write_computed(profile, section)
        profiles.append(profile)
    base = make_swept_surface(doc, rails, profiles, model="rotate", name=f"Pipe{pipe.number}Base")
    base.Tolerance = 1e-2
    write_computed(base, pipe.base(SweepModel.ROTATE))
    segment = make_cloud_segment(doc, cloud, base, name=f"Pipe{pipe.number}Points")
    write_computed(segment, pipe.points)
    made = []
    for model in SweepModel:
        whole = [own for own in pipe.fits if own.model == model and not own.thinned]
        if not whole:
            continue
        surface = make_swept_surface(
            doc,
            rails,
            profiles,
            segment,
            model.value,
            whole[-1].grid,
            name=f"Pipe{pipe.number}{model.value.title()}",
        )
        write_computed(surface, whole[-1].fit)
        if model is SweepModel.ROTATE:
            made.append(surface)
            make_deviation_map(doc, segment, surface, name=f"Pipe{pipe.number}Deviations")
    return made


def casestudy_looks(doc: Any) -> dict[str, Look]:
    """Looks of the document's objects, by their names."""
    looks = {}
    for obj in doc.Objects:
        kind = type(obj.Proxy).__name__ if hasattr(obj, "Proxy") else obj.TypeId
        if kind == "SweptSurfaceProxy":
            looks[obj.Name] = next(look for end, look in _SURFACES.items() if end in obj.Name)
        else:
            looks[obj.Name] = {
                "ScannedEdgeProxy": _EDGE,
                "CloudSegmentProxy": _SEGMENT,
                "DeviationMapProxy": _MAP,
                "Points::Feature": _CLOUD,
            }.get(kind, _PROFILE)
    return looks
