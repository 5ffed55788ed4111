# SPDX-License-Identifier: LGPL-2.1-or-later
"""How surfaces, sections, segments and deviation maps look in the tree and in the 3D view."""

from __future__ import annotations

from typing import Any

from .colours import EDGE
from .icons import icon_path
from .preferences import point_size

__all__ = ["ViewProviderComputed"]

_ICONS = {
    "SweptSurfaceProxy": "EdgeScan_SweptSurface",
    "FittedSurfaceProxy": "EdgeScan_FittedSurface",
    "ExtendedSurfaceProxy": "EdgeScan_ExtendSurface",
    "SurfaceIntersectionProxy": "EdgeScan_IntersectSurfaces",
    "CloudSegmentProxy": "EdgeScan_CloudSegment",
    "CloudSectionProxy": "EdgeScan_CloudSection",
    "TrimmedShellProxy": "EdgeScan_TrimmedShell",
    "DeviationMapProxy": "EdgeScan_DeviationMap",
    "SimulatedCloudProxy": "EdgeScan_SimulatedCloud",
    "ThinnedCloudProxy": "EdgeScan_ThinCloud",
    "CompensatedCloudProxy": "EdgeScan_CompensateCloud",
    "ScannedBoundaryProxy": "EdgeScan_ScanBoundary",
    "EdgeNetworkProxy": "EdgeScan_ScanAllEdges",
    "EdgeWireProxy": "EdgeScan_EdgeWire",
}
_EDGES = ("ScannedBoundaryProxy", "EdgeNetworkProxy", "EdgeWireProxy")
_SHADED = ("SimulatedCloudProxy", "ThinnedCloudProxy", "CompensatedCloudProxy")


class ViewProviderComputed:
    """View provider of such an object. It keeps no state: everything lives in properties.

    The name of this class and of its module are written into users' files.
    """

    def __init__(self, view_object: Any) -> None:
        view_object.Proxy = self
        self.attach(view_object)
        if hasattr(view_object, "PointSize"):
            view_object.PointSize = float(point_size())
        if type(view_object.Object.Proxy).__name__ in _EDGES:
            view_object.LineColor, view_object.LineWidth = EDGE, 3.0

    def attach(self, view_object: Any) -> None:
        """FreeCAD shows the object for the first time; it draws shape and points itself."""
        self.object = view_object.Object

    def updateData(self, obj: Any, name: str) -> None:
        """A map shows its colours as soon as it has them; points have no mode of their own."""
        if name == "Points" and type(getattr(obj, "Proxy", None)).__name__ in _SHADED:
            from .cloud_looks import shade

            shade(obj)
        if name in ("Color", "Points") and _is_cloud_of_ours(obj):
            _show_points(obj.ViewObject, coloured=hasattr(obj, "Color"))

    def getIcon(self) -> str:
        """Icon in the tree."""
        return icon_path(_ICONS[type(self.object.Proxy).__name__])

    def dumps(self) -> None:
        """Nothing to write into the file."""
        return None

    def loads(self, state: object) -> None:
        """Nothing to read from the file."""

    # FreeCAD before 0.21.2 asks for these instead.
    __getstate__ = dumps
    __setstate__ = loads


def _is_cloud_of_ours(obj: Any) -> bool:
    kind = type(getattr(obj, "Proxy", None)).__name__
    return kind in _ICONS and bool(obj.isDerivedFrom("Points::Feature"))


def _show_points(view_object: Any, coloured: bool) -> None:
    modes = view_object.listDisplayModes()
    wanted = "Color" if coloured and "Color" in modes else "Points"
    if wanted in modes:
        view_object.DisplayMode = wanted
