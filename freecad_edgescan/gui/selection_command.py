# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that make one object of what is selected."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import Any

import FreeCAD
import FreeCADGui

from .compute_beside import CancelledByUserError, computing_beside
from .icons import icon_path
from .message import problems_shown
from .recorded_step import run_as_one_step

__all__ = ["SelectionCommand"]


class SelectionCommand:
    """A command that selects nothing itself and has no panel.

    Parameters
    ----------
    name : of the command and of its icon
    title : menu text
    tooltip : what it does, and what to select
    line : gives the recorded line for the selected objects, or a ValueError that says what to
        select
    """

    def __init__(
        self, name: str, title: str, tooltip: str, line: Callable[[list[Any]], str]
    ) -> None:
        self.name, self.title, self.tooltip, self.line = name, title, tooltip, line

    def GetResources(self) -> dict[str, str]:
        """Icon, menu text and tooltip."""
        return {
            "Pixmap": icon_path(self.name),
            "MenuText": self.title,
            "ToolTip": self.tooltip,
        }

    def IsActive(self) -> bool:
        """With a document; what is to be selected is said when it is not."""
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Make the object."""
        doc = FreeCAD.ActiveDocument
        chosen = list(dict.fromkeys(FreeCADGui.Selection.getSelection(doc.Name)))
        with problems_shown(self.title), suppress(CancelledByUserError):
            beside = computing_beside(self.title)
            run_as_one_step(doc, self.title, [self.line(chosen)], beside)
