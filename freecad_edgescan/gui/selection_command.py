# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that make one object of what is selected."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .command import Command
from .obstacles import no_document
from .picked_edges import wire_lines
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
    joins : whether edges of a network that are selected one by one and follow each other are one
        wire; False: each is one
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
        joins: bool = False,
        covered: bool = False,
    ) -> None:
        super().__init__(name, title, tooltip, hint, self._make, obstacle)
        self._line, self._joins, self._covered = line, joins, covered

    def _make(self, doc: Any) -> None:
        from .compute_beside import computing_beside

        chosen = selected_objects(doc)
        wires = {item.Name: wire_lines(doc, item, self._joins) for item in chosen}
        first = [line for made in wires.values() for line in made]
        before = len(doc.Objects)

        def then() -> str:
            made = iter(doc.Objects[before:])
            return self._line(
                [
                    part
                    for item in chosen
                    for part in ([next(made) for _ in wires[item.Name]] or [item])
                ]
            )

        lines: list[str | Callable[[], str]] = [*first, "doc.recompute()", then]
        if not first:
            lines = [self._line(chosen)]
        if self._covered:
            lines += [f"{object_line(item)}.Visibility = False" for item in chosen]
        made = run_as_one_step(doc, self.title, lines, computing_beside(self.title))
        select_only(made[len(first) :])
