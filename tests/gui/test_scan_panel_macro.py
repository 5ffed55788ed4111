# SPDX-License-Identifier: LGPL-2.1-or-later
"""A macro recorded by clicking makes the same edge without a window, bit for bit."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

from freecad_edgescan.gui.picked_places import Way  # noqa: E402

REPOSITORY = Path(__file__).resolve().parents[2]


def on_the_roof(x: float, y: float) -> tuple[float, float, float]:
    return (x, y, 5.0 - 0.8 * abs(x))


def one_click(window: Any) -> None:
    window.click(on_the_roof(0.3, 2.0))
    window.found()


def start_gate_and_parameters(window: Any) -> None:
    window.panel.form.choose_way(Way.START_AND_GATE)
    form = window.panel.form.parameters
    form.row("amplitude").tick.click()
    form.row("amplitude").box.widget.setProperty("rawValue", 7.3)
    form.row("approach").tick.click()
    form.row("approach").box.setCurrentIndex(0)
    places = [(3.0, -8.0), (-3.0, -8.0), (3.0, -4.0), (3.0, 6.0), (-3.0, 6.0)]
    for place in places:
        window.click(on_the_roof(*place))
    window.wait_until(lambda: "OK keeps this edge" in window.sentence)


def probed(window: Any) -> None:
    window.panel.form.parameters._method.setCurrentIndex(1)
    one_click(window)


def console() -> str:
    return next(name for name in ("freecadcmd", "FreeCADCmd") if shutil.which(name))


def replayed(macro: Path, home: Path) -> None:
    """Run a macro in a FreeCAD without a window."""
    (home / "Mod").mkdir(parents=True)
    (home / "Mod" / "EdgeScan").symlink_to(REPOSITORY)
    (home / "user.cfg").touch()
    environment = {**os.environ, "FREECAD_USER_HOME": str(home)}
    environment.pop("DISPLAY", None)
    subprocess.run(
        [console(), "-u", str(home / "user.cfg"), str(macro)],
        env=environment,
        check=True,
        timeout=120,
        stdout=subprocess.DEVNULL,
        stdin=subprocess.DEVNULL,
    )


@pytest.mark.slow
@pytest.mark.parametrize("clicks", [one_click, start_gate_and_parameters, probed])
def test_a_macro_replays_without_a_window_bit_for_bit(
    window: Any,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    clicks: Callable[[Any], None],
) -> None:
    path = tmp_path / "roof.FCStd"
    window.doc.saveAs(str(path))
    window.view.viewTop()
    window.view.fitAll()
    window.settle()
    lines: list[str] = []
    run = Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (lines.append(line), run(line)))
    window.open_panel()
    clicks(window)
    window.ok()
    (edge,) = window.edges
    out = tmp_path / "edge.txt"
    macro = tmp_path / "recorded_by_clicking.py"
    told = [
        "import FreeCAD",
        f"FreeCAD.openDocument({str(path)!r})",
        *(line.replace(repr(window.doc.Name), "FreeCAD.ActiveDocument.Name") for line in lines),
        f"edge = doc.getObject({edge.Name!r})",
        "text = repr([tuple(p) for p in edge.Points]) + edge.Shape.exportBrepToString()",
        f"open({str(out)!r}, 'w').write(text)",
        "import sys; sys.exit(0)",
    ]
    macro.write_text("\n".join(told), encoding="utf-8")
    replayed(macro, tmp_path / "home")
    expected = repr([tuple(p) for p in edge.Points]) + edge.Shape.exportBrepToString()
    assert out.read_text() == expected
