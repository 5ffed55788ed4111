# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/functions.md: every function for documents is in its list, and its example works."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

FreeCAD = pytest.importorskip("FreeCAD")

from freecad_edgescan import document  # noqa: E402

PAGE = (Path(__file__).parents[2] / "docs" / "functions.md").read_text(encoding="utf-8")


def test_the_list_holds_every_function_once() -> None:
    listed = re.findall(r"^\| `(\w+)\(", PAGE, re.M)
    assert sorted(listed) == sorted(document.__all__)


def test_the_example_leads_from_a_part_to_a_sweep(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (example,) = re.findall(r"```python\n(.*?)```", PAGE, re.S)
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    exec(compile(example, "functions.md", "exec"), names)
    doc, sweep, wire = names["doc"], names["sweep"], names["wire"]
    assert all(obj.isValid() for obj in doc.Objects)
    assert len(wire.Shape.Edges) == 2
    assert len(sweep.Shape.Faces) >= 2 and sweep.Shape.isValid()
    assert {path.name for path in tmp_path.iterdir()} == {"part.ply", "part.step", "edges.csv"}
    FreeCAD.closeDocument(doc.Name)
