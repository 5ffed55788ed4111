# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collects the texts of the screen into the .ts files, and compiles these for FreeCAD.

Run by ``./edgescan translate``. Texts come from three places:

1. calls of ``translate`` and ``QT_TRANSLATE_NOOP`` in the package ``gui``;
2. the tooltips of all declared properties in the package ``document`` (context ``App::Property``);
3. the strings of the .ui files (context: the name of their class).

A translation stays as long as its text does. What has none is marked unfinished, for Qt Linguist
or any text editor. ``lrelease``, which belongs to Qt, makes of each .ts the .qm that FreeCAD reads.
"""

from __future__ import annotations

import ast
import importlib
import pkgutil
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

HERE = Path(__file__).resolve().parent
PACKAGE = HERE.parent / "freecad_edgescan"
NAME = "EdgeScan"
DEFAULT_CONTEXT = "EdgeScan"

Text = tuple[str, str]  # context and source


def main(languages: list[str]) -> int:
    """Bring all languages and those named up to date; the number of texts that are missing."""
    texts = sorted({*texts_in_code(), *texts_of_properties(), *texts_of_forms()})
    known = {file.stem.partition("_")[2] for file in HERE.glob(f"{NAME}_*.ts")}
    missing = 0
    for language in sorted(known | set(languages)):
        file = HERE / f"{NAME}_{language}.ts"
        translations = read(file)
        write(file, language, texts, translations)
        unfinished = sum(not translations.get(text) for text in texts)
        missing += unfinished
        print(f"{file.name}: {len(texts)} texts, {unfinished} unfinished")
    compile_all()
    return missing


def texts_in_code() -> Iterator[Text]:
    """What is marked in the code of the screen."""
    for file in (*sorted((PACKAGE / "gui").glob("*.py")), PACKAGE.parent / "InitGui.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call):
                continue
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            words = [own.value for own in node.args if isinstance(own, ast.Constant)]
            if name == "translate" and isinstance(node.args[0], ast.Constant):
                yield (words[1] if len(words) > 1 else DEFAULT_CONTEXT), words[0]
            elif name == "QT_TRANSLATE_NOOP":
                yield words[0], words[1]


def texts_of_properties() -> Iterator[Text]:
    """Tooltips of the properties of our objects, as FreeCAD's property editor asks for them."""
    import FreeCAD  # noqa: F401 (before Part, which ends the process otherwise)

    from freecad_edgescan import document, gui
    from freecad_edgescan.document.declared_properties import Declared

    for module in pkgutil.iter_modules(document.__path__):
        for value in vars(importlib.import_module(f"{document.__name__}.{module.name}")).values():
            every = value if isinstance(value, tuple) else (value,)
            for own in every:
                if isinstance(own, Declared):
                    yield "App::Property", own.tooltip
    # The screen declares one, too; its modules need a window, so its text is read from the code.
    for file in Path(gui.__path__[0]).glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Declared":
                yield "App::Property", ast.literal_eval(node.args[3])


def texts_of_forms() -> Iterator[Text]:
    """What stands in the .ui files."""
    for file in (PACKAGE / "gui").glob("*.ui"):
        root = ElementTree.parse(file).getroot()
        context = root.findtext("class") or ""
        for string in root.iter("string"):
            if string.text and string.get("notr") != "true":
                yield context, string.text


def read(file: Path) -> dict[Text, str]:
    """The finished translations in a .ts file."""
    if not file.exists():
        return {}
    found = {}
    for context in ElementTree.parse(file).getroot().iter("context"):
        name = context.findtext("name") or ""
        for message in context.iter("message"):
            translation = message.find("translation")
            if translation is not None and translation.get("type") is None:
                found[(name, message.findtext("source") or "")] = translation.text or ""
    return found


def write(file: Path, language: str, texts: list[Text], translations: dict[Text, str]) -> None:
    """Write a .ts file as Qt's own tools do."""
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    contexts: dict[str, ElementTree.Element] = {}
    for name, source in texts:
        if name not in contexts:
            contexts[name] = ElementTree.SubElement(root, "context")
            ElementTree.SubElement(contexts[name], "name").text = name
        message = ElementTree.SubElement(contexts[name], "message")
        ElementTree.SubElement(message, "source").text = source
        translation = ElementTree.SubElement(message, "translation")
        translated = translations.get((name, source))
        if translated:
            translation.text = translated
        else:
            translation.set("type", "unfinished")
    ElementTree.indent(root, "  ")
    body = ElementTree.tostring(root, encoding="unicode")
    file.write_text(
        f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{body}\n', encoding="utf-8"
    )


def compile_all() -> None:
    """Make the .qm files, when Qt's lrelease is there."""
    lrelease = shutil.which("lrelease") or shutil.which("lrelease", path="/usr/lib/qt5/bin")
    lrelease = lrelease or shutil.which("lrelease", path="/usr/lib/qt6/bin")
    if lrelease is None:
        print("lrelease is missing (Debian: qttools5-dev-tools); the .qm files were not renewed.")
        return
    for file in sorted(HERE.glob(f"{NAME}_*.ts")):
        subprocess.run([lrelease, "-silent", str(file)], check=True)


if __name__ == "__main__":
    sys.exit(1 if main(sys.argv[1:]) else 0)
