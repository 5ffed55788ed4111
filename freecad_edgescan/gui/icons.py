# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the icons are."""

from __future__ import annotations

from pathlib import Path

import freecad_edgescan

__all__ = ["icon_path"]

_FOLDER = Path(freecad_edgescan.__file__).resolve().parent.parent / "icons"


def icon_path(name: str) -> str:
    """Path of the SVG called ``name``, such as ``EdgeScan_ScanEdge``."""
    return str(_FOLDER / f"{name}.svg")
