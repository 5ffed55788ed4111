# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, and where they stand in toolbars and menus."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from .all_edges_command import all_edges_command
from .clicked_commands import clicked_commands
from .cloud_commands import cloud_commands
from .edge_wire_command import edge_wire_command
from .import_cloud_command import import_cloud_command
from .output_commands import output_commands
from .surface_commands import surface_commands
from .sweep_commands import sweep_commands
from .try_it import try_it_command
from .view_provider_observer import start_watching

__all__ = ["TOOLBARS", "for_selection", "menu", "register"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# At most six in each: what a person takes in at a glance.
TOOLBARS = {
    QT_TRANSLATE_NOOP("Workbench", "EdgeScan clouds"): [
        "EdgeScan_ImportCloud",
        "EdgeScan_SimulatedCloud",
        "EdgeScan_CompensateCloud",
        "EdgeScan_ThinCloud",
        "EdgeScan_CloudSegment",
    ],
    QT_TRANSLATE_NOOP("Workbench", "EdgeScan edges"): [
        "EdgeScan_ScanEdge",
        "EdgeScan_ScanBoundary",
        "EdgeScan_ScanAllEdges",
        "EdgeScan_RecommendParameters",
        "EdgeScan_EdgeWire",
    ],
    QT_TRANSLATE_NOOP("Workbench", "EdgeScan sweeps"): [
        "EdgeScan_CloudSection",
        "EdgeScan_Sweep",
        "EdgeScan_Loft",
        "EdgeScan_SweptSurface",
    ],
    QT_TRANSLATE_NOOP("Workbench", "EdgeScan surfaces"): [
        "EdgeScan_FittedSurface",
        "EdgeScan_ExtendSurface",
        "EdgeScan_IntersectSurfaces",
        "EdgeScan_TrimmedShell",
    ],
    QT_TRANSLATE_NOOP("Workbench", "EdgeScan results"): [
        "EdgeScan_DeviationMap",
        "EdgeScan_Export",
        "EdgeScan_Report",
    ],
}
_MENU_ONLY = ["EdgeScan_TryIt"]

_FOR_CLOUDS = [
    "EdgeScan_ScanEdge",
    "EdgeScan_ScanBoundary",
    "EdgeScan_ScanAllEdges",
    "EdgeScan_RecommendParameters",
    "EdgeScan_CompensateCloud",
    "EdgeScan_ThinCloud",
]
_FOR_EDGES = ["EdgeScan_CloudSection", "EdgeScan_Sweep", "EdgeScan_Loft", "EdgeScan_Export"]

_FOR_NETWORKS = [
    *("EdgeScan_EdgeWire", "EdgeScan_Sweep", "EdgeScan_Loft"),
    *("EdgeScan_CloudSegment", "EdgeScan_Export"),
]


def register() -> None:
    """Make the commands known to FreeCAD."""
    for command in (
        import_cloud_command(),
        *cloud_commands(),
        *clicked_commands(),
        all_edges_command(),
        edge_wire_command(),
        *sweep_commands(),
        *surface_commands(),
        *output_commands(),
        try_it_command(),
    ):
        FreeCADGui.addCommand(command.name, command)
    start_watching()


def menu() -> list[str]:
    """All commands in the order of the menu, with separators between their groups."""
    names = list(_MENU_ONLY)
    for group in TOOLBARS.values():
        names += ["Separator", *group]
    return names


def for_selection() -> list[str]:
    """What a right click offers for clouds, edges and networks that are selected."""
    from .selected import clouds_of, is_edge_network, is_scanned_edge

    chosen = FreeCADGui.Selection.getSelection()
    names: list[str] = []
    if clouds_of(chosen):
        names += _FOR_CLOUDS
    edges = [item for item in chosen if is_scanned_edge(item) or hasattr(item, "Sigma")]
    if any(not is_edge_network(item) for item in edges):
        names += _FOR_EDGES
    if any(is_edge_network(item) for item in edges):
        names += [name for name in _FOR_NETWORKS if name not in names]
    return names
