# SPDX-License-Identifier: LGPL-2.1-or-later
"""German and French are complete, compiled, and seen in the window."""

from __future__ import annotations

import importlib.util
import string
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

LANGUAGES = ("de", "fr")


@pytest.fixture(scope="module")
def update() -> Any:
    """The script that collects and compiles."""
    from freecad_edgescan.gui.translation import TRANSLATIONS

    spec = importlib.util.spec_from_file_location("update", TRANSLATIONS / "update.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def texts(update: Any) -> set[tuple[str, str]]:
    """All texts there are to translate."""
    return {*update.texts_in_code(), *update.texts_of_properties(), *update.texts_of_forms()}


def placeholders(text: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(text) if name}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_is_translated(update: Any, texts: Any, language: str) -> None:
    known = update.read(update.HERE / f"EdgeScan_{language}.ts")
    assert not sorted(texts - set(known)), "run ./edgescan translate, and translate these"
    assert not sorted(set(known) - texts), "run ./edgescan translate"


@pytest.mark.parametrize("language", LANGUAGES)
def test_numbers_and_keys_are_where_they_were(update: Any, language: str) -> None:
    for (_, source), translation in update.read(update.HERE / f"EdgeScan_{language}.ts").items():
        assert placeholders(source) == placeholders(translation)
        assert source.count("&") == translation.count("&")
        assert source.endswith("…") == translation.endswith("…")


@pytest.fixture
def speak(workbench: Any) -> Iterator[Callable[[str], None]]:
    """Sets the language of the window."""
    yield Gui.setLocale
    Gui.setLocale("English")


@pytest.mark.parametrize(("language", "name"), [("de", "German"), ("fr", "French")])
def test_the_compiled_file_holds_the_translations(
    update: Any, speak: Any, language: str, name: str
) -> None:
    speak(name)
    known = update.read(update.HERE / f"EdgeScan_{language}.ts")
    off = {text for text, said in known.items() if FreeCAD.Qt.translate(*text) != said}
    assert not off, "run ./edgescan translate"


def test_the_window_speaks_german(speak: Any, window: Any, problems: list[str]) -> None:
    speak("German")
    (action,) = Gui.Command.get("EdgeScan_ImportCloud").getAction()
    window.wait_until(lambda: action.text() == "Punktwolke importieren…", 5.0)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(window.doc.Objects[0])
    box = window.doc.addObject("Part::Box", "Box")
    window.doc.recompute()
    Gui.Selection.addSelection(box)
    Gui.runCommand("EdgeScan_IntersectSurfaces")
    assert problems == ["1 Flächen sind ausgewählt. Zwei auswählen, die sich treffen."]
    window.picture("german")


def test_a_new_language_begins_unfinished_and_loses_nothing_later(
    update: Any, tmp_path: Path
) -> None:
    file = tmp_path / "EdgeScan_it.ts"
    texts = [("EdgeScan", "Size: <{number}> & more"), ("EdgeScan", "Angle")]
    update.write(file, "it", texts, {})
    assert update.read(file) == {}
    update.write(file, "it", texts, {texts[1]: "Angolo"})
    assert update.read(file) == {texts[1]: "Angolo"}
