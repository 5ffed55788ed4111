# SPDX-License-Identifier: LGPL-2.1-or-later
"""Telling the user that a command could not do what was asked."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD
import FreeCADGui

from .qt import QtWidgets

__all__ = ["problems_shown", "show_problem"]


def show_problem(title: str, sentence: str) -> None:
    """Write one sentence to the report view and show it in a message box."""
    FreeCAD.Console.PrintError(f"{title}: {sentence}\n")
    QtWidgets.QMessageBox.warning(FreeCADGui.getMainWindow(), title, sentence)


@contextmanager
def problems_shown(title: str) -> Iterator[None]:
    """Show the problems a user can mend; faults of ours pass through, with their trace."""
    try:
        yield
    except ModuleNotFoundError as error:
        show_problem(
            title,
            f"EdgeScan needs the Python package {error.name}, which is not installed. Install it "
            f"(on Debian: apt install python3-{error.name}) and start FreeCAD again.",
        )
    except (ValueError, OSError) as error:
        show_problem(title, str(error))
