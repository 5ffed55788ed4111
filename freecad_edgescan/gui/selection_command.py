# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that make one object of what is selected."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .command import Command
from .obstacles import no_document
from .recorded_step import object_line, run_as_one_step
from .selected import selected_objects
from .shown import select_only

__all__ = ["SelectionCommand"]


class SelectionCommand(Command):
    """A command that selects nothing itself and has no panel.

    Parameters
    ----------
    name, title, tooltip, hint, obstacle : see `Command`
    line : gives the recorded line for the selected objects, or a ValueError that says what to
        select
    covered : what was selected would hide what is made, and is itself hidden
    """

    def __init__(
        self,
        name: str,
        title: str,
        tooltip: str,
        hint: str,
        line: Callable[[list[Any]], str],
        obstacle: Callable[[], str] = no_document,
        covered: bool = False,
    ) -> None:
        super().__init__(name, title, tooltip, hint, self._make, obstacle)
        self._line = line
        self._covered = covered

    def _make(self, doc: Any) -> None:
        from .compute_beside import computing_beside

        chosen = selected_objects(doc)
        lines = [self._line(chosen)]
        if self._covered:
            lines += [f"{object_line(item)}.Visibility = False" for item in chosen]
        select_only(run_as_one_step(doc, self.title, lines, computing_beside(self.title)))
