# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of the screen in the user's language.

Write texts in English where they are used: ``translate("Click near an edge.")``. Numbers go in
afterwards, by name, so that other languages may order them otherwise:
``translate("{count} clouds are selected.").format(count=2)``. A command's menu text, tooltip and
status text stand in its own context, marked by ``QT_TRANSLATE_NOOP`` with the command's name.
``./edgescan translate`` collects all of them into the .ts files in ``translations``.
"""

from __future__ import annotations

from pathlib import Path

import FreeCAD
import FreeCADGui

import freecad_edgescan

from .qt import QtCore

__all__ = ["TRANSLATIONS", "count_text", "learn_languages", "translate"]

TRANSLATIONS = Path(freecad_edgescan.__file__).resolve().parent.parent / "translations"

_learnt: list[Path] = []


def translate(text: str, context: str = "EdgeScan") -> str:
    """A text in the language of FreeCAD's window; the text itself where there is no translation."""
    return str(FreeCAD.Qt.translate(context, text))


def count_text(count: int) -> str:
    """A whole number as the language writes it."""
    return str(QtCore.QLocale().toString(int(count)))


def learn_languages() -> None:
    """Let FreeCAD know our translations, once."""
    if not _learnt:
        _learnt.append(TRANSLATIONS)
        FreeCADGui.addLanguagePath(str(TRANSLATIONS))
        FreeCADGui.updateLocale()
