# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .import_cloud_command import ImportCloudCommand
from .loft_command import LoftCommand
from .scan_edge_command import ScanEdgeCommand
from .surface_commands import surface_commands
from .sweep_command import SweepCommand
from .view_provider_observer import start_watching

__all__ = ["register"]


def register() -> list[str]:
    """Make the commands known to FreeCAD.

    Returns
    -------
    Their names, in the order of the toolbar.
    """
    commands: dict[str, Any] = {
        "EdgeScan_ImportCloud": ImportCloudCommand(),
        "EdgeScan_ScanEdge": ScanEdgeCommand(),
        "EdgeScan_Sweep": SweepCommand(),
        "EdgeScan_Loft": LoftCommand(),
        **surface_commands(),
    }
    for name, command in commands.items():
        FreeCADGui.addCommand(name, command)
    start_watching()
    return list(commands)
