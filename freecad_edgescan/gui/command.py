# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands have in common: texts, an icon, and a reason when they cannot run."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
import FreeCADGui

from .icons import icon_path
from .message import problems_shown
from .obstacles import no_document
from .translation import translate

__all__ = ["Command"]


class Command:
    """A command of the workbench.

    Parameters
    ----------
    name : of the command and of its icon; also the context its texts are translated in
    title : menu text
    tooltip : what it does, and what to select
    hint : for the status bar: what to select, in short
    run : does it, for the active document; a ValueError of it is shown as a sentence
    obstacle : the sentence that says why the command cannot run now, or ""
    """

    def __init__(
        self,
        name: str,
        title: str,
        tooltip: str,
        hint: str,
        run: Callable[[Any], object],
        obstacle: Callable[[], str] = no_document,
    ) -> None:
        self.name, self.tooltip, self.hint = name, tooltip, hint
        self._title, self._run, self._obstacle = title, run, obstacle
        self._shown = ""

    @property
    def title(self) -> str:
        """Menu text in the user's language, for message boxes and the undo list."""
        return translate(self._title, self.name).rstrip("…")

    def GetResources(self) -> dict[str, str]:
        """Icon, menu text, tooltip and status text; FreeCAD translates them."""
        return {
            "Pixmap": icon_path(self.name),
            "MenuText": self._title,
            "ToolTip": self.tooltip,
            "StatusTip": self.hint,
        }

    def IsActive(self) -> bool:
        """Whether it can run; why not is said in tooltip and status bar."""
        reason = self._obstacle()
        if reason != self._shown:
            self._shown = reason
            self._show_reason(reason)
        return not reason

    def Activated(self) -> None:
        """Run it, or say why that cannot be."""
        with problems_shown(self.title):
            self._run(FreeCAD.ActiveDocument)

    def _show_reason(self, reason: str) -> None:
        tooltip = translate(self.tooltip, self.name)
        if reason:
            tooltip = f"{tooltip}<p><i>{reason}</i></p>"
        for action in FreeCADGui.Command.get(self.name).getAction():
            action.setToolTip(f"<p style='white-space:pre-line'><b>{self.title}</b></p>{tooltip}")
            action.setStatusTip(reason or translate(self.hint, self.name))
