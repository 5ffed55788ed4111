# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scan of a box in a document, one of its edges, and what is scanned in a test."""

from __future__ import annotations

from typing import Any

import pytest

from freecad_edgescan import document
from freecad_edgescan.document import scanned_edge

from .box import box_cloud


@pytest.fixture
def cloud(doc: Any) -> Any:
    return document.make_cloud(doc, box_cloud())


@pytest.fixture
def edge(doc: Any, cloud: Any) -> Any:
    made = document.make_scanned_edge(doc, cloud, at=(10, 0, 10))
    doc.recompute()
    return made


@pytest.fixture
def scans(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the objects that were scanned."""
    names: list[str] = []
    scan_again = scanned_edge.scan_again

    def counted(obj: Any, *rest: Any) -> Any:
        names.append(obj.Name)
        return scan_again(obj, *rest)

    monkeypatch.setattr(scanned_edge, "scan_again", counted)
    return names
