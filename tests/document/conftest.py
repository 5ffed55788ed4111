# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document for one test, which leaves no document behind."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

try:
    import FreeCAD  # noqa: F401
except ImportError:  # not in FreeCAD's Python
    collect_ignore = ["edge_object"]


@pytest.fixture
def doc() -> Iterator[Any]:
    FreeCAD = pytest.importorskip("FreeCAD")
    before = set(FreeCAD.listDocuments())
    made = FreeCAD.newDocument("EdgeScanTest")
    made.UndoMode = 1
    yield made
    for name in set(FreeCAD.listDocuments()) - before:
        FreeCAD.closeDocument(name)
