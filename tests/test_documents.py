# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documents name what there is, and link to what there is."""

from __future__ import annotations

import re
from dataclasses import fields
from pathlib import Path

import pytest

from freecad_edgescan.scanning import Safeguards, Stop

CHECKOUT = Path(__file__).resolve().parents[1]
DOCUMENTS = [*CHECKOUT.glob("*.md"), *(CHECKOUT / "docs").glob("*.md")]


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_links_lead_somewhere(document: Path) -> None:
    targets = re.findall(r"\]\((?!https?:)([^)#]+)", document.read_text(encoding="utf-8"))
    missing = [target for target in targets if not (document.parent / target).exists()]
    assert missing == []


def test_every_safeguard_is_explained() -> None:
    explained = re.findall(r"^\| `(\w+)` \|", (CHECKOUT / "docs/probe.md").read_text(), re.M)
    assert set(explained) >= {field.name for field in fields(Safeguards)}


def test_every_stop_is_explained() -> None:
    guide = (CHECKOUT / "docs/guide.md").read_text()
    rows = " ".join(re.findall(r"^\| ([A-Z_, ]+) \|", guide, re.M))
    assert {stop.name for stop in Stop} <= set(re.findall(r"\w+", rows))
