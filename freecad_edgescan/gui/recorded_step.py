# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands as macro lines, run as one undo step.

Everything a command does to a document it does by lines of Python that FreeCAD records. They
mention neither the screen nor the mouse, so that a recorded macro replays in ``freecadcmd``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from .translation import translate

__all__ = ["as_literal", "object_line", "object_lines", "run_as_one_step"]


def as_literal(point: Any) -> str:
    """Three numbers as the tuple that reads back bit for bit."""
    x, y, z = (float(value) for value in point)
    return f"({x!r}, {y!r}, {z!r})"


def object_line(item: Any) -> str:
    """The expression that finds a document object again, given ``doc``."""
    return f"doc.getObject({item.Name!r})"


def object_lines(items: list[Any]) -> str:
    """The expression that finds document objects again, as a list."""
    return f"[{', '.join(object_line(item) for item in items)}]"


def run_as_one_step(
    doc: Any,
    title: str,
    lines: Sequence[str | Callable[[], str]],
    before_recompute: Callable[[list[Any]], None] | None = None,
    changed: Sequence[Any] = (),
) -> list[Any]:
    """Run recorded lines and recompute, all in one undo step, or leave no trace.

    Parameters
    ----------
    doc : App.Document, which the lines know as ``doc``; they know ``document`` as our package
    title : what the undo menu calls the step
    lines : Python statements; one that depends on what those before it have made is a function
    before_recompute : gets the objects that were made, to write results into them that are known
        already, or to dress them; it is not recorded, so it must only save time or change looks
    changed : objects the lines change, which must be valid afterwards, too

    Returns
    -------
    The objects the lines have made.

    Raises
    ------
    ValueError: an object the lines made or changed could not be computed; the text says which and
        why.
    Whatever the lines raise.
    """
    before = {item.Name for item in doc.Objects}
    doc.openTransaction(title)
    try:
        FreeCADGui.doCommand("from freecad_edgescan import document")
        FreeCADGui.doCommand(f"doc = FreeCAD.getDocument({doc.Name!r})")
        for line in lines:
            FreeCADGui.doCommand(line if isinstance(line, str) else line())
        made = [item for item in doc.Objects if item.Name not in before]
        if before_recompute is not None:
            before_recompute(made)
        FreeCADGui.doCommand("doc.recompute()")
        _require_valid([*made, *changed])
    except BaseException:
        doc.abortTransaction()
        raise
    doc.commitTransaction()
    FreeCAD.Console.PrintLog(f"{title}: {', '.join(item.Label for item in [*made, *changed])}\n")
    return made


def _require_valid(made: list[Any]) -> None:
    for item in made:
        if "Invalid" in item.State:
            sentence = translate("{label} could not be computed: {reason}")
            raise ValueError(sentence.format(label=item.Label, reason=item.getStatusString()))
