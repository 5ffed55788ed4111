# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's preferences, each with the value it has when nothing was chosen.

The page where they are chosen is ``preferences.ui``; its fields write under the same names.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

from .icons import icon_path

__all__ = [
    "PAGE",
    "add_page",
    "import_folder",
    "import_unit",
    "makes_one_network",
    "moves_near_origin",
    "point_size",
    "remember_import_folder",
    "remember_one_network",
    "shades_clouds",
]

PAGE = Path(__file__).with_name("preferences.ui")
UNITS = ("mm", "m", "inch")  # in the order of the page


def add_page() -> None:
    """Add the page to FreeCAD's preferences; FreeCAD looks for its icon among its own."""
    FreeCADGui.addIconPath(str(Path(icon_path("any")).parent))
    FreeCADGui.addPreferencePage(str(PAGE), "EdgeScan")


def _stored() -> Any:
    return FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/EdgeScan")


def import_folder() -> str:
    """Folder of the file that was imported last."""
    return str(_stored().GetString("ImportFolder", ""))


def remember_import_folder(folder: str) -> None:
    """Begin there next time."""
    _stored().SetString("ImportFolder", folder)


def import_unit() -> str:
    """Unit that imported files are taken to be in, unless the user says otherwise."""
    number = _stored().GetInt("ImportUnit", 0)
    return UNITS[number] if 0 <= number < len(UNITS) else UNITS[0]


def moves_near_origin() -> bool:
    """Whether a cloud far away is moved near the origin, unless the user says otherwise."""
    return bool(_stored().GetBool("MoveNearOrigin", True))


def shades_clouds() -> bool:
    """Whether imported clouds are shaded as if light fell on them."""
    return bool(_stored().GetBool("ShadeClouds", True))


def makes_one_network() -> bool:
    """Whether all edges of a cloud became one object the last time."""
    return bool(_stored().GetBool("OneNetwork", True))


def remember_one_network(wanted: bool) -> None:
    """Offer the same next time."""
    _stored().SetBool("OneNetwork", wanted)


def point_size() -> int:
    """Size of the points of new clouds, pixels."""
    return int(_stored().GetInt("PointSize", 3))
