# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small table as rich text, for what a panel answers; the theme gives its colours."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

__all__ = ["html_table"]


def html_table(titles: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Rows under their titles; no titles: rows alone."""
    head = _row(titles, "th") if titles else ""
    body = "".join(_row(row, "td") for row in rows)
    return f"<table cellpadding='3' width='100%'>{head}{body}</table>"


def _row(texts: Sequence[str], tag: str) -> str:
    return (
        "<tr>" + "".join(f"<{tag} align='left'>{escape(text)}</{tag}>" for text in texts) + "</tr>"
    )
