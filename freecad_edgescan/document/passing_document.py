# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hidden document for what FreeCAD only does to documents; it leaves no trace."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import FreeCAD

__all__ = ["passing_document"]


@contextmanager
def passing_document() -> Iterator[Any]:
    """Give an empty hidden document and close it afterwards; the active one stays active."""
    active = FreeCAD.ActiveDocument
    passing = FreeCAD.newDocument("EdgeScanPassing", "EdgeScanPassing", True, True)
    try:
        yield passing
    finally:
        FreeCAD.closeDocument(passing.Name)
        if active is not None:
            FreeCAD.setActiveDocument(active.Name)
