# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel shows what an edge rests on: sections, numbers, plots, and only what is asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

from freecad_edgescan.gui.colours import sigma_colours, sigma_range  # noqa: E402
from freecad_edgescan.gui.qt import QtCore, QtGui, QtWidgets  # noqa: E402

ON_THE_RIDGE = (0.3, 2.0, 5.0)


@pytest.fixture
def panel(window: Any) -> Any:
    window.open_panel()
    window.click(ON_THE_RIDGE)
    window.found()
    return window.panel


def ink_of(widget: Any) -> float:
    """Share of a widget's pixels that are not its ground."""
    image = widget.grab().toImage().convertToFormat(QtGui.QImage.Format_RGB32)
    pixels = np.frombuffer(bytes(image.constBits()), dtype=np.uint32)
    ground = np.uint32(widget.palette().color(QtGui.QPalette.Base).rgb())
    return float(np.mean(pixels != ground))


def press_in(widget: Any, x: float, y: float) -> None:
    event = QtGui.QMouseEvent(
        QtCore.QEvent.MouseButtonPress,
        QtCore.QPointF(x, y),
        QtCore.Qt.LeftButton,
        QtCore.Qt.LeftButton,
        QtCore.Qt.NoModifier,
    )
    QtWidgets.QApplication.sendEvent(widget, event)


def press_key(widget: Any, key: Any) -> None:
    event = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, key, QtCore.Qt.NoModifier)
    QtWidgets.QApplication.sendEvent(widget, event)


def test_the_numbers_are_those_of_the_edge_point_shown(panel: Any) -> None:
    edge, evidence = panel._found.edge, panel.form.evidence
    evidence.show_number(11)
    assert f"{np.degrees(edge.angle[11]):.1f}°" in evidence.numbers
    assert FreeCAD.Units.Quantity(f"{edge.sigma[11]} mm").UserString in evidence.numbers


def test_section_and_plots_draw_something_and_nothing_before(window: Any) -> None:
    window.open_panel()
    evidence = window.panel.form.evidence
    before = ink_of(evidence.section), ink_of(evidence.plots)
    window.click(ON_THE_RIDGE)
    window.found()
    window.picture("scan_edge_evidence")
    assert ink_of(evidence.section) > before[0] + 0.01
    assert ink_of(evidence.plots) > before[1] + 0.01


def test_a_click_in_the_plots_goes_there(panel: Any) -> None:
    plots = panel.form.evidence.plots
    press_in(plots, 0.75 * plots.width(), 0.5 * plots.height())
    assert panel.form.evidence.number == pytest.approx(0.75 * len(panel._found.edge), abs=3)


def test_arrow_keys_go_along_the_edge(panel: Any) -> None:
    evidence = panel.form.evidence
    evidence.show_number(5)
    press_key(evidence.section, QtCore.Qt.Key_Right)
    press_key(evidence.plots, QtCore.Qt.Key_Right)
    assert evidence.number == 7
    evidence.show_number(0)
    press_key(evidence.section, QtCore.Qt.Key_Left)
    assert evidence.number == 0


def test_the_section_follows_the_mouse_over_the_edge(window: Any, panel: Any) -> None:
    evidence = panel.form.evidence
    for number in (4, 40):
        window.hover(tuple(panel._found.edge.points[number]))
        window.wait_until(lambda wanted=number: abs(evidence.number - wanted) <= 1, 5.0)
    window.hover((6.0, 0.0, 5.0 - 0.8 * 6.0))
    assert abs(panel.form.evidence.number - 40) <= 1


def test_every_control_can_be_reached_by_keyboard(panel: Any) -> None:
    form = panel.form
    kinds = (QtWidgets.QAbstractButton, QtWidgets.QComboBox, QtWidgets.QSlider)
    controls = [w for w in form.findChildren(QtWidgets.QWidget) if isinstance(w, kinds)]
    controls += [form.evidence.section, form.evidence.plots]
    assert len(controls) > 15
    for control in controls:
        if not isinstance(control.parent(), QtWidgets.QTabBar):
            assert control.focusPolicy() & QtCore.Qt.TabFocus, control


def test_nothing_is_cut_off_in_the_narrowest_panel(panel: Any) -> None:
    assert panel.form.minimumSizeHint().width() <= 215


@pytest.mark.parametrize("dark", [False, True])
def test_pictures_stand_out_on_light_and_dark_ground(panel: Any, dark: bool, window: Any) -> None:
    evidence = panel.form.evidence
    palette = QtGui.QPalette(evidence.palette())
    ground, ink = ("#202020", "#e0e0e0") if dark else ("#ffffff", "#000000")
    palette.setColor(QtGui.QPalette.Base, QtGui.QColor(ground))
    palette.setColor(QtGui.QPalette.Text, QtGui.QColor(ink))
    for widget in (evidence.section, evidence.plots):
        widget.setPalette(palette)
        image = widget.grab().toImage().convertToFormat(QtGui.QImage.Format_RGB32)
        rows = np.frombuffer(bytes(image.constBits()), dtype=np.uint8).reshape(-1, 4)[:, :3]
        light = rows @ [0.114, 0.587, 0.299] / 255
        assert np.median(light) == pytest.approx(QtGui.QColor(ground).lightnessF(), abs=0.02)
        assert np.ptp(light) > 0.5


def test_a_large_cloud_is_thinned_on_the_screen_only(
    window: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    from freecad_edgescan.gui import thinned_clouds

    monkeypatch.setattr(thinned_clouds, "MOST_POINTS", 1000)
    window.open_panel()
    clouds = window.panel._display.clouds
    assert 900 < clouds.count <= 1000
    assert window.cloud.ViewObject.SwitchNode.whichChild.getValue() == -1
    assert window.cloud.ViewObject.Visibility
    window.click(ON_THE_RIDGE)
    window.found()
    # Of the thinned points no edge could be known so well.
    assert np.median(window.panel._found.edge.sigma) < 0.004
    window.button("Cancel").click()
    window.settle()
    assert window.cloud.ViewObject.SwitchNode.whichChild.getValue() == 0


def test_a_cloud_hidden_or_shown_meanwhile_is_followed(window: Any) -> None:
    window.open_panel()
    clouds = window.panel._display.clouds
    whole = clouds.count
    window.cloud.ViewObject.Visibility = False
    window.wait_until(lambda: clouds.count == 0 and window.panel._clicks.ready)
    window.click(ON_THE_RIDGE)
    assert "No point cloud can be seen" in window.sentence
    window.cloud.ViewObject.Visibility = True
    window.wait_until(lambda: clouds.count == whole and window.panel._clicks.ready)
    window.click(ON_THE_RIDGE)
    window.found()
    window.cloud.ViewObject.Visibility = False
    window.settle()
    window.button("Cancel").click()
    window.settle()
    assert window.cloud.ViewObject.SwitchNode.whichChild.getValue() == -1


def test_the_slab_hides_all_points_but_those_at_the_section(window: Any, panel: Any) -> None:
    panel.form.evidence.show_number(20)
    panel.form.tabs.setCurrentIndex(2)
    panel.form.view._slab.click()
    panel.form.view._look.click()
    window.picture("scan_edge_slab")
    first, second = panel._display.clouds._planes
    middle = panel._found.edge.points[20]
    for plane in (first, second):
        assert plane.on.getValue()
        distance = plane.plane.getValue().getDistance(_vector(middle))
        assert 0.2 < distance < 2.0
    direction = np.array(window.view.getViewDirection())
    assert abs(direction @ panel._found.edge.tangents[20]) == pytest.approx(1.0, abs=1e-3)
    panel.form.view._slab.click()
    assert not first.on.getValue()


def test_colours_grow_with_sigma_in_brightness() -> None:
    colours = sigma_colours([0.01, 0.02, 0.03, np.nan], sigma_range([0.01, 0.03]))
    light = colours @ [0.299, 0.587, 0.114]
    assert np.all(np.diff(light[:3]) > 0.1)
    assert light[3] == light[2]
    assert sigma_range([0.01, 0.0101]) == (0.01, 0.02)


def _vector(point: Any) -> Any:
    from pivy import coin

    return coin.SbVec3f(*point.tolist())


def test_the_panel_speaks_in_the_users_unit(window: Any) -> None:
    usual = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("UserSchema", 0)
    try:
        FreeCAD.Units.setSchema(3)  # inches
        window.open_panel()
        window.click(ON_THE_RIDGE)
        window.found()
        form = window.panel.form
        length = window.panel._found.edge.length / 25.4
        assert f", {length:.2f} in;" in form._message.text()
        assert "0.00 in" not in form.figures
    finally:
        FreeCAD.Units.setSchema(usual)
