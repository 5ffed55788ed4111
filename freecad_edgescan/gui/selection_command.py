# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that make one object of what is selected."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .command import Command
from .obstacles import no_document
from .recorded_step import run_as_one_step
from .selected import selected_objects

__all__ = ["SelectionCommand"]


class SelectionCommand(Command):
    """A command that selects nothing itself and has no panel.

    Parameters
    ----------
    name, title, tooltip, hint, obstacle : see `Command`
    line : gives the recorded line for the selected objects, or a ValueError that says what to
        select
    """

    def __init__(
        self,
        name: str,
        title: str,
        tooltip: str,
        hint: str,
        line: Callable[[list[Any]], str],
        obstacle: Callable[[], str] = no_document,
    ) -> None:
        super().__init__(name, title, tooltip, hint, self._make, obstacle)
        self._line = line

    def _make(self, doc: Any) -> None:
        from .compute_beside import computing_beside

        line = self._line(selected_objects(doc))
        run_as_one_step(doc, self.title, [line], computing_beside(self.title))
