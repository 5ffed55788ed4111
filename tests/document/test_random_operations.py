# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever is done to a document, in whatever order, it stays valid.

The quick run of the suite does 2 times 30 operations. The long one, 20 times 200, is asked for by

    EDGESCAN_RANDOM_RUNS=20 EDGESCAN_RANDOM_OPERATIONS=200 \
        ./edgescan test tests/document/test_random_operations.py
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")
pytest.importorskip("hypothesis")

from hypothesis import HealthCheck, settings  # noqa: E402
from hypothesis import strategies as st  # noqa: E402
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule  # noqa: E402

from freecad_edgescan import document  # noqa: E402

RUNS = int(os.environ.get("EDGESCAN_RANDOM_RUNS", "2"))
OPERATIONS = int(os.environ.get("EDGESCAN_RANDOM_OPERATIONS", "30"))
MOST_OBJECTS = 14  # a user's document, not a heap: recomputes stay quick

PLACEMENTS = (
    FreeCAD.Placement(),
    FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 1, 0), 30)),
)
EDITS = (
    ("Amplitude", (0.0, 6.0, 0.01, 1e4)),
    ("EdgePitch", (0.0, 1.5, 0.05)),
    ("MinAngle", (0.0, 20.0, 170.0)),
    ("At", ((0.0, 0.0, 5.0), (4.0, 1.0, 1.8), (500.0, 0.0, 0.0))),
    ("Pitch", (0.5, 1.5, 0.0, -1.0)),
    ("Noise", (0.0, 0.05, -1.0)),
    ("ProbeRadius", (0.0, 0.5, -2.0)),
    ("Reach", (0.0, 1.0, 1e-6)),
    ("Distance", (1.0, 0.0, 3.0)),
    ("Share", (0.5, 0.0, 1.0, 7.0)),
    ("Placement", PLACEMENTS),
)


def roof() -> np.ndarray:
    """Two slanting sides that meet in the line x = 0, z = 5."""
    random = np.random.default_rng(7)
    x, y = random.uniform((-6, -8), (6, 8), (2500, 2)).T
    return np.column_stack([x, y, 5.0 - 0.8 * np.abs(x) + random.normal(0, 0.01, len(x))])


def of_kind(doc: Any, kind: str) -> list[Any]:
    return [item for item in doc.Objects if item.isDerivedFrom(kind)]


class Operations(RuleBasedStateMachine):
    """What a user does; choices are numbers, taken modulo what there is."""

    def __init__(self) -> None:
        super().__init__()
        self.folder = tempfile.TemporaryDirectory()
        self.doc = FreeCAD.newDocument("Random")
        self.doc.UndoMode = 1

    def teardown(self) -> None:
        FreeCAD.closeDocument(self.doc.Name)
        self.folder.cleanup()

    def step(self, title: str, do: Any) -> None:
        """One undo step; what is refused says a sentence and leaves no trace."""
        self.doc.openTransaction(title)
        try:
            do()
        except ValueError as error:
            assert str(error).rstrip().endswith((".", "?"))
            self.doc.abortTransaction()
        else:
            self.doc.commitTransaction()

    @initialize()
    def begin(self) -> None:
        self.step("Import", lambda: document.make_cloud(self.doc, roof()))
        self.doc.recompute()

    @rule(what=st.integers(0, 9), which=st.integers(0, 99), recompute=st.booleans())
    def create(self, what: int, which: int, recompute: bool) -> None:
        if len(self.doc.Objects) >= MOST_OBJECTS:
            return
        doc = self.doc
        clouds, shapes = of_kind(doc, "Points::Feature"), of_kind(doc, "Part::Feature")
        cloud = clouds[which % len(clouds)] if clouds else None
        shape = shapes[which % len(shapes)] if shapes else None
        other = shapes[(which // 3) % len(shapes)] if shapes else None
        makers = (
            lambda: document.make_cloud(doc, roof()),
            lambda: doc.addObject("Part::Box", "Box"),
            lambda: document.make_scanned_edge(doc, cloud, at=(0.0, 0.0, 5.0)),
            lambda: document.make_scanned_boundary(doc, cloud, (0, 0, 5), (3, 0, 2.6)),
            lambda: document.make_thinned_cloud(doc, cloud, 0.8),
            lambda: document.make_compensated_cloud(doc, cloud),
            lambda: document.make_simulated_cloud(doc, shape, 1.0, noise=0.01),
            lambda: document.make_cloud_section(doc, cloud, shape),
            lambda: document.make_sweep(doc, other, shape),
            lambda: document.make_deviation_map(doc, cloud, shape),
        )
        self.step("Create", makers[what])
        if recompute:
            doc.recompute()

    @rule(which=st.integers(0, 99), edit=st.sampled_from(EDITS), value=st.integers(0, 9))
    def edit(self, which: int, edit: tuple[str, tuple[Any, ...]], value: int) -> None:
        name, values = edit
        having = [item for item in self.doc.Objects if name in item.PropertiesList]
        having = [item for item in having if "ReadOnly" not in item.getEditorMode(name)]
        if having:
            item = having[which % len(having)]
            self.step("Edit", lambda: setattr(item, name, values[value % len(values)]))

    @rule(which=st.integers(0, 99))
    def delete(self, which: int) -> None:
        if self.doc.Objects:
            item = self.doc.Objects[which % len(self.doc.Objects)]
            self.step("Delete", lambda: self.doc.removeObject(item.Name))

    @rule()
    def undo(self) -> None:
        if self.doc.UndoCount:
            self.doc.undo()

    @rule()
    def redo(self) -> None:
        if self.doc.RedoCount:
            self.doc.redo()

    @rule()
    def recompute(self) -> None:
        self.doc.recompute()

    @rule()
    def save_and_reopen(self) -> None:
        path = str(Path(self.folder.name) / "random.FCStd")
        self.doc.recompute()
        before = {item.Name: state_of(item) for item in self.doc.Objects}
        self.doc.saveAs(path)
        FreeCAD.closeDocument(self.doc.Name)
        self.doc = FreeCAD.openDocument(path)
        self.doc.UndoMode = 1
        assert {item.Name: state_of(item) for item in self.doc.Objects} == before

    @invariant()
    def every_object_is_whole(self) -> None:
        for item in self.doc.Objects:
            assert item.Document == self.doc
            assert all(other in self.doc.Objects for other in item.OutList)
            shape = getattr(item, "Shape", None)
            if shape is not None and not shape.isNull():
                assert shape.isValid(), item.Label
            if hasattr(item, "PointCount") and item.isDerivedFrom("Points::Feature"):
                assert item.PointCount == item.Points.CountPoints, item.Label
            if hasattr(item, "Color"):
                assert len(item.Color) in (0, item.Points.CountPoints), item.Label

    @invariant()
    def what_failed_says_why(self) -> None:
        for item in self.doc.Objects:
            if "Invalid" in item.State and hasattr(item, "Message"):
                assert item.Message.rstrip().endswith((".", "?")), (item.Label, item.Message)


def state_of(item: Any) -> tuple[object, ...]:
    """What of an object a file must keep."""
    shape = getattr(item, "Shape", None)
    count = item.Points.CountPoints if item.isDerivedFrom("Points::Feature") else 0
    length = None if shape is None or shape.isNull() else round(shape.Length, 6)
    return item.TypeId, item.Label, count, length, sorted(other.Name for other in item.OutList)


TestRandomOperations = Operations.TestCase
TestRandomOperations.settings = settings(
    max_examples=RUNS,
    stateful_step_count=OPERATIONS,
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=list(HealthCheck),
)
