# SPDX-License-Identifier: LGPL-2.1-or-later
"""EdgeScan: true sharp edges from scanned point clouds.

The public Python API. Every name is looked up in the package that defines it when it is
first used (PEP 562), so that importing this module costs nothing: FreeCAD imports it at
each start, whether or not anybody scans an edge that day.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from freecad_edgescan import document as document
    from freecad_edgescan import experiments as experiments
    from freecad_edgescan.cloud import CoreBox as CoreBox
    from freecad_edgescan.cloud import PartOfCloud as PartOfCloud
    from freecad_edgescan.cloud import PointCloud as PointCloud
    from freecad_edgescan.cloud import TorusObject as TorusObject
    from freecad_edgescan.cloud import TrueEdge as TrueEdge
    from freecad_edgescan.cloud import compensate_cloud as compensate_cloud
    from freecad_edgescan.cloud import read_cloud as read_cloud
    from freecad_edgescan.cloud import thin_cloud as thin_cloud
    from freecad_edgescan.cloud import write_cloud as write_cloud
    from freecad_edgescan.geometry import BSplineCurve as BSplineCurve
    from freecad_edgescan.geometry import BSplineSurface as BSplineSurface
    from freecad_edgescan.scanning import AnalyticCmm as AnalyticCmm
    from freecad_edgescan.scanning import Cmm as Cmm
    from freecad_edgescan.scanning import EdgeNetwork as EdgeNetwork
    from freecad_edgescan.scanning import Gate as Gate
    from freecad_edgescan.scanning import PointCloudCmm as PointCloudCmm
    from freecad_edgescan.scanning import Progress as Progress
    from freecad_edgescan.scanning import Safeguards as Safeguards
    from freecad_edgescan.scanning import ScanError as ScanError
    from freecad_edgescan.scanning import ScannedEdge as ScannedEdge
    from freecad_edgescan.scanning import ScanParameters as ScanParameters
    from freecad_edgescan.scanning import Section as Section
    from freecad_edgescan.scanning import Start as Start
    from freecad_edgescan.scanning import Stop as Stop
    from freecad_edgescan.scanning import find_edges as find_edges
    from freecad_edgescan.scanning import recommend_parameters as recommend_parameters
    from freecad_edgescan.scanning import scan_boundary as scan_boundary
    from freecad_edgescan.scanning import scan_edge as scan_edge
    from freecad_edgescan.surfacing import BaseSurface as BaseSurface
    from freecad_edgescan.surfacing import CrossSection as CrossSection
    from freecad_edgescan.surfacing import Deviation as Deviation
    from freecad_edgescan.surfacing import SurfaceFit as SurfaceFit
    from freecad_edgescan.surfacing import SurfaceIntersection as SurfaceIntersection
    from freecad_edgescan.surfacing import SweptFit as SweptFit
    from freecad_edgescan.surfacing import SweptSurface as SweptSurface
    from freecad_edgescan.surfacing import base_surface as base_surface
    from freecad_edgescan.surfacing import cross_section as cross_section
    from freecad_edgescan.surfacing import deviation as deviation
    from freecad_edgescan.surfacing import extend_surface as extend_surface
    from freecad_edgescan.surfacing import fit_surface as fit_surface
    from freecad_edgescan.surfacing import fit_swept_surface as fit_swept_surface
    from freecad_edgescan.surfacing import intersect_surfaces as intersect_surfaces
    from freecad_edgescan.surfacing import segment_cloud as segment_cloud

__version__ = "0.1.0"

_HOME_OF = {
    # clouds
    "PointCloud": "cloud",
    "read_cloud": "cloud",
    "write_cloud": "cloud",
    "compensate_cloud": "cloud",
    "thin_cloud": "cloud",
    "PartOfCloud": "cloud",
    # simulated clouds with known truth
    "CoreBox": "cloud",
    "TorusObject": "cloud",
    "TrueEdge": "cloud",
    # scanning
    "scan_edge": "scanning",
    "scan_boundary": "scanning",
    "find_edges": "scanning",
    "EdgeNetwork": "scanning",
    "recommend_parameters": "scanning",
    "ScanParameters": "scanning",
    "Start": "scanning",
    "Gate": "scanning",
    "Stop": "scanning",
    "ScannedEdge": "scanning",
    "ScanError": "scanning",
    "Section": "scanning",
    "Cmm": "scanning",
    "AnalyticCmm": "scanning",
    "PointCloudCmm": "scanning",
    "Safeguards": "scanning",
    "Progress": "scanning",
    # surfacing
    "fit_surface": "surfacing",
    "SurfaceFit": "surfacing",
    "extend_surface": "surfacing",
    "intersect_surfaces": "surfacing",
    "SurfaceIntersection": "surfacing",
    "SweptSurface": "surfacing",
    "fit_swept_surface": "surfacing",
    "SweptFit": "surfacing",
    "base_surface": "surfacing",
    "BaseSurface": "surfacing",
    "cross_section": "surfacing",
    "CrossSection": "surfacing",
    "segment_cloud": "surfacing",
    "deviation": "surfacing",
    "Deviation": "surfacing",
    # geometry
    "BSplineCurve": "geometry",
    "BSplineSurface": "geometry",
}
_PACKAGES = ("experiments", "document")

__all__ = [*_HOME_OF, *_PACKAGES]


def __getattr__(name: str) -> Any:
    """Import the package that defines `name` and answer the name."""
    if name in _PACKAGES:
        return import_module(f"{__name__}.{name}")
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Names of the public API besides what is loaded already."""
    return sorted({*globals(), *__all__})
