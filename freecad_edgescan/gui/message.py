# SPDX-License-Identifier: LGPL-2.1-or-later
"""Telling the user that a command could not do what was asked."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD
import FreeCADGui

from .qt import QtWidgets
from .translation import translate

__all__ = ["CancelledError", "problems_shown", "show_problem"]


class CancelledError(Exception):
    """The user does not want what the command was about any more."""


def show_problem(title: str, sentence: str) -> None:
    """Write one sentence to the report view and show it in a message box."""
    FreeCAD.Console.PrintError(f"{title}: {sentence}\n")
    QtWidgets.QMessageBox.warning(FreeCADGui.getMainWindow(), title, sentence)


@contextmanager
def problems_shown(title: str) -> Iterator[None]:
    """Show the problems a user can mend; faults of ours pass through, with their trace."""
    try:
        yield
    except CancelledError:
        pass
    except ModuleNotFoundError as error:
        package = (error.name or "").partition(".")[0]
        show_problem(
            title,
            translate(
                "EdgeScan needs the Python package {package}, which is not installed. Install it "
                "(on Debian: apt install python3-{package}) and start FreeCAD again."
            ).format(package=package),
        )
    except (ValueError, OSError) as error:
        show_problem(title, str(error))
