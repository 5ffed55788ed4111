# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ways out of a panel, for tests that nothing is left behind whichever is taken."""

from __future__ import annotations

from typing import Any

import FreeCADGui as Gui


def by_escape(window: Any) -> None:
    window.press_escape()


def by_cancel(window: Any) -> None:
    window.button("Cancel").click()


def by_the_cross(window: Any) -> None:
    window.close_dock()


def by_freecad(window: Any) -> None:
    Gui.Control.closeDialog()
