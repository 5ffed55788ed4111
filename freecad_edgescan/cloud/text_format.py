# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds as plain text: .xyz, .txt, .asc, .csv.

One point a line, x y z and whatever follows. How the numbers are written (separator, decimal
comma, names of the columns, a count in the first line) is read off the first lines of the file.
"""

from __future__ import annotations

import codecs
import re
from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path

from .blocks import ROWS, Blocks
from .text_rows import Row, holds_data, row_blocks

__all__ = ["looks_like_text_cloud", "text_blocks"]

LONGEST_HEADER = 100  # lines
SAMPLE = 50  # lines the separator is judged by

_WITH_DECIMAL_COMMA = re.compile(r"[^,]+(,\d+([eE][-+]?\d+)?)?")

_BYTE_ORDER_MARKS = {
    codecs.BOM_UTF8: "utf-8-sig",
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}


@dataclass(frozen=True)
class _Layout:
    """What the first lines tell: how many of them are no points, and how a row is written."""

    header: int  # lines before the first point
    named: bool  # the header has text that is neither a comment nor a count
    row: Row


def text_blocks(path: Path, rows: int = ROWS) -> Blocks:
    """Points of a text file in blocks of so many lines, mm.

    Raises
    ------
    ValueError: not text, no points, or a line without three numbers.
    """
    head = _head(path)
    encoding = _encoding(head)
    if encoding != "utf-16" and b"\0" in head:
        raise ValueError(
            f"{path.name} is not text: it holds binary data. Give it the ending of its format, "
            "or export it as text with one point x y z a line."
        )
    with path.open(encoding=encoding, errors="replace") as stream:
        layout = _layout(list(islice(stream, LONGEST_HEADER + SAMPLE)), path.name)
    with path.open(encoding=encoding, errors="replace") as stream:
        for _ in range(layout.header):
            next(stream)
        yield from row_blocks(
            stream, layout.row, name=path.name, first_line=layout.header + 1, rows=rows
        )


def looks_like_text_cloud(path: Path) -> bool:
    """Whether the file is a table of numbers without any titles, whatever it is called."""
    head = _head(path)
    encoding = _encoding(head)
    if encoding != "utf-16" and b"\0" in head:
        return False
    with path.open(encoding=encoding, errors="replace") as stream:
        lines = list(islice(stream, LONGEST_HEADER + SAMPLE))
    try:
        layout = _layout(lines, path.name)
    except ValueError:
        return False
    fields = [layout.row.fields(line) for line in lines[layout.header :] if holds_data(line)]
    return not layout.named and all(
        len(texts) >= 3 and all(_is_number(text) for text in texts[:3]) for texts in fields
    )


def _head(path: Path) -> bytes:
    with path.open("rb") as stream:
        return stream.read(65536)


def _encoding(head: bytes) -> str:
    for mark, encoding in _BYTE_ORDER_MARKS.items():
        if head.startswith(mark):
            return encoding
    return "utf-8"


def _layout(lines: list[str], name: str) -> _Layout:
    titles: list[str] = []
    named = False
    counted = False
    for header, line in enumerate(lines[:LONGEST_HEADER]):
        words = _words(line)
        if not words:
            continue
        if holds_data(line) and _begins_with_number(words[0]):
            if counted or not line.strip().isdigit():
                return _Layout(header, named, _row(lines[header:], titles))
            counted = True  # a number alone in the first line: how many points follow
            continue
        named = named or holds_data(line)
        titles = words if {"x", "y", "z"} <= set(_names(words)) else titles
    shown = next((line.strip()[:60] for line in lines if line.strip()), "")
    raise ValueError(
        f"{name} has no line of numbers x y z"
        + (f"; it begins with '{shown}'." if shown else ".")
        + " Write one point a line, separated by blanks, tabs, commas or semicolons."
    )


def _row(lines: list[str], titles: list[str]) -> Row:
    sample = [line for line in lines if holds_data(line)][:SAMPLE]
    if ";" in sample[0]:
        row = Row(separator=";", decimal_comma=True)
    elif not any("," in line for line in sample):
        row = Row()
    elif all(_has_decimal_commas(line) for line in sample):
        row = Row(decimal_comma=True)
    else:
        row = Row(separator=",")
    if not titles or len(titles) > len(row.fields(sample[0])):
        return row
    names = _names(titles)
    return replace(row, columns=(names.index("x"), names.index("y"), names.index("z")))


def _has_decimal_commas(line: str) -> bool:
    """Whether blanks separate the numbers, so that a comma can only be inside one."""
    words = line.split()
    return len(words) >= 3 and all(_WITH_DECIMAL_COMMA.fullmatch(word) for word in words)


def _names(titles: list[str]) -> list[str]:
    return [title.strip("\"'[]()").lower() for title in titles]


def _words(line: str) -> list[str]:
    text = line.strip().lstrip("#/% ")
    separator = next((mark for mark in (";", ",", "\t") if mark in text), None)
    return [word.strip() for word in text.split(separator)] if text else []


def _begins_with_number(text: str) -> bool:
    words = text.replace(",", ".").split()
    return bool(words) and _is_number(words[0])


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
