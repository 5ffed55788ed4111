# SPDX-License-Identifier: LGPL-2.1-or-later
"""A deviation map's legend is seen while the map is, and goes with it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")
coin = pytest.importorskip("pivy.coin")


@pytest.fixture
def maps(window: Any) -> list[Any]:
    """Two maps of points on both sides of a plate, the second with twice the limit."""
    from freecad_edgescan import document

    doc = window.doc
    x, y, z = np.random.default_rng(0).uniform((0, 0, -0.2), (20, 10, 0.2), (3000, 3)).T
    cloud = document.make_cloud(doc, np.column_stack([x, y, z]))
    plate = doc.addObject("Part::Feature", "Plate")
    plate.Shape = Part.makePlane(20, 10)
    made = [document.make_deviation_map(doc, cloud, plate, limit=own) for own in (0.2, 0.4)]
    doc.recompute()
    return made


def legends_seen(window: Any) -> list[Any]:
    """Switches of the legends in the view's scene that are on."""
    search = coin.SoSearchAction()
    search.setName("EdgeScanLegend")
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(window.view.getSceneGraph())
    paths = search.getPaths()
    nodes = [paths[k].getTail() for k in range(paths.getLength())]
    return [node for node in nodes if node.whichChild.getValue() != coin.SO_SWITCH_NONE]


def words(node: Any) -> list[str]:
    """All words drawn below a node."""
    search = coin.SoSearchAction()
    search.setType(coin.SoText2.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(node)
    paths = search.getPaths()
    return [paths[k].getTail().string[0].getString() for k in range(paths.getLength())]


def test_it_is_seen_with_its_map_and_goes_with_it(window: Any, maps: list[Any]) -> None:
    first, second = maps
    assert len(legends_seen(window)) == 2
    first.ViewObject.hide()
    assert len(legends_seen(window)) == 1
    first.ViewObject.show()
    second.ViewObject.Legend = False
    assert len(legends_seen(window)) == 1
    window.doc.removeObject(first.Name)
    second.ViewObject.Legend = True
    assert len(legends_seen(window)) == 1
    window.doc.removeObject(second.Name)
    assert legends_seen(window) == []


def test_numbers_are_those_of_the_limit_in_the_users_unit(window: Any, maps: list[Any]) -> None:
    parameters = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
    before = parameters.GetInt("UserSchema", 0)
    try:
        FreeCAD.Units.setSchema(0)  # mm
        maps[1].Label = "Upper side"
        said = words(legends_seen(window)[1])
        assert "Upper side" in said and "deviation, mm" in said
        assert {"+0.400", "0", "-0.400"} <= set(said)
        FreeCAD.Units.setSchema(3)  # inch
        maps[1].Label = "In inches"
        said = words(legends_seen(window)[1])
        (unit,) = (text for text in said if text.startswith("deviation"))
        assert "mm" not in unit
    finally:
        FreeCAD.Units.setSchema(before)


def test_it_does_not_change_what_fit_all_shows(window: Any, maps: list[Any]) -> None:
    def seen() -> tuple[float, ...]:
        window.view.fitAll()
        return tuple(window.view.getCameraNode().position.getValue())

    for item in window.doc.Objects:
        item.ViewObject.Visibility = item in maps
    with_legend = seen()
    for own in maps:
        own.ViewObject.Legend = False
    assert seen() == pytest.approx(with_legend)
    window.picture("deviation-legend")


def test_what_it_shows_can_be_saved(
    window: Any, maps: list[Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, problems: Any
) -> None:
    from freecad_edgescan.gui.qt import QtWidgets

    paths = [tmp_path / "map.csv", tmp_path / "map.txt"]
    asked = iter(paths)
    monkeypatch.setattr(QtWidgets.QFileDialog, "getSaveFileName", lambda *_: (str(next(asked)), ""))
    menu = QtWidgets.QMenu()
    maps[0].ViewObject.Proxy.setupContextMenu(maps[0].ViewObject, menu)
    (action,) = menu.actions()
    action.trigger()
    table = np.loadtxt(paths[0], delimiter=",", skiprows=1)
    assert np.allclose(table[:, 3], maps[0].Deviations, atol=1e-6)
    assert np.allclose(np.abs(table[:, 2]), np.abs(table[:, 3]), atol=1e-5)
    action.trigger()
    assert len(problems) == 1 and "write a .csv, .png, .svg or .pdf" in problems[0]
