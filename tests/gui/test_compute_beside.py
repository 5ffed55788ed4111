# SPDX-License-Identifier: LGPL-2.1-or-later
"""What takes long is computed beside the window, which shows how far it is and may cancel it."""

from __future__ import annotations

import time
from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")

from freecad_edgescan.gui import busy  # noqa: E402
from freecad_edgescan.gui.message import CancelledError  # noqa: E402
from freecad_edgescan.gui.qt import QtWidgets  # noqa: E402
from freecad_edgescan.gui.single_shot import call_later  # noqa: E402


@pytest.fixture(autouse=True)
def impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    """The dialog is shown at once."""
    monkeypatch.setattr(busy, "_PATIENCE", 1)


def slow(steps: int, asked: list[float]) -> Any:
    """A task of 20 ms steps."""

    def task(progress: Any) -> int:
        for number in range(steps):
            time.sleep(0.02)
            asked.append(number)
            if not progress.update((number + 1) / steps, number):
                break
        return number + 1

    return task


def dialogs() -> list[Any]:
    return [own for own in QtWidgets.QApplication.topLevelWidgets() if own.inherits(
        "QProgressDialog") and own.isVisible()]  # fmt: skip


def press_cancel() -> None:
    dialogs()[0].findChild(QtWidgets.QPushButton).click()


def test_the_result_comes_back_and_the_dialog_goes(window: Any) -> None:
    seen: list[int] = []
    call_later(lambda: seen.append(len(dialogs())), 200)
    assert busy.result_of(slow(40, []), "Swept surface") == 40
    window.settle()
    assert seen == [1] and dialogs() == []


def test_cancel_ends_the_task_leaves_no_thread_and_raises_nothing_to_say(window: Any) -> None:
    asked: list[float] = []
    threads = window.threads
    call_later(press_cancel, 200)
    with pytest.raises(CancelledError):
        busy.result_of(slow(1000, asked), "Swept surface")
    assert len(asked) < 500
    assert window.threads <= threads
    window.settle()
    assert dialogs() == []


def test_a_refusal_in_the_task_is_raised_where_the_command_is(window: Any) -> None:
    def task(progress: Any) -> None:
        raise ValueError("The rails are closed.")

    with pytest.raises(ValueError, match="rails are closed"):
        busy.result_of(task, "Swept surface")


def test_a_cancelled_command_leaves_no_trace(
    window: Any, monkeypatch: pytest.MonkeyPatch, problems: list[str]
) -> None:
    from freecad_edgescan.document.cloud_segment import CloudSegmentProxy

    cloud = window.doc.findObjects("Points::Feature")[0]
    plate = window.doc.addObject("Part::Feature", "Plate")
    plate.Shape = Part.makePlane(20, 30, FreeCAD.Vector(-10, -15, 0))
    window.doc.recompute()
    monkeypatch.setattr(CloudSegmentProxy, "task", lambda self, obj: slow(1000, []))
    before = window.trace()
    Gui.Selection.clearSelection()
    for item in (cloud, plate):
        Gui.Selection.addSelection(item)
    call_later(press_cancel, 200)
    Gui.runCommand("EdgeScan_CloudSegment")
    assert window.trace() == before
    assert problems == []
