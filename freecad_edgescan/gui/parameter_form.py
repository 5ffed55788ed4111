# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of a scan: automatic, each with its value and why; a tick makes it one's own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from freecad_edgescan.scanning import (
    Compensation,
    Pattern,
    ScanParameters,
    Steering,
    Tangent,
)

from .qt import QtCore, QtWidgets
from .quantities import LengthBox
from .translation import translate

__all__ = ["ParameterForm"]

PATCH, PROBE = "patch", "probe"
_NARROW = QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon
_EDITOR = 76  # pixels, in which a length can be read
_INDENT, _BELOW = 20, 5  # pixels round a reason, so that it is seen what it belongs to
_SETTLED = 400  # ms without another change, after which it counts
_UNKNOWN_LENGTH = 0.1  # mm, where nothing is known yet that could be changed


def _lengths() -> dict[str, tuple[str, str, bool]]:
    """Of each length: its name, its tooltip, and whether only a probed scan has it."""
    return {
        "amplitude": (
            translate("Amplitude"),
            translate("Length of a scan line along the surface, half of it on each side"),
            False,
        ),
        "edge_pitch": (translate("Edge pitch"), translate("Distance of the edge points"), False),
        "chord_height": (
            translate("Chord height"),
            translate("Largest deviation of the chord between two edge points from the edge"),
            False,
        ),
        "probe_radius": (
            translate("Probe radius"),
            translate("Radius of the ball whose centres the cloud holds; 0: surface points"),
            False,
        ),
        "line_pitch": (
            translate("Line pitch"),
            translate("Distance of the points on a scan line"),
            True,
        ),
        "tolerance": (
            translate("Tolerance"),
            translate("Scanning tolerance of a line section"),
            True,
        ),
        "prehit_distance": (
            translate("Prehit distance"),
            translate("Where the measuring machine begins to move slowly"),
            True,
        ),
        "search_distance": (
            translate("Search distance"),
            translate("How far the measuring machine goes on looking for the surface"),
            True,
        ),
        "cloud_pitch": (
            translate("Cloud pitch"),
            translate("Distance of the cloud's points, which tells a gap from surface"),
            True,
        ),
    }


def _choices() -> dict[str, tuple[str, str, bool, list[tuple[str, Any]]]]:
    """Of each choice: its name, its tooltip, whether only a probed scan has it, what there is."""
    return {
        "approach": (
            translate("Approach"),
            translate("Direction the probe came along; the air lies against it"),
            False,
            [
                (translate("down, -z"), (0.0, 0.0, -1.0)),
                (translate("up, +z"), (0.0, 0.0, 1.0)),
                (translate("along +x"), (1.0, 0.0, 0.0)),
                (translate("along -x"), (-1.0, 0.0, 0.0)),
                (translate("along +y"), (0.0, 1.0, 0.0)),
                (translate("along -y"), (0.0, -1.0, 0.0)),
            ],
        ),
        "degree": (
            translate("Degree"),
            translate("Degree of a line section"),
            True,
            [
                (translate("1 (line)"), 1),
                (translate("2 (quadratic)"), 2),
                (translate("3 (cubic)"), 3),
            ],
        ),
        "pattern": (
            translate("Pattern"),
            translate("How the scan lines follow each other"),
            True,
            [(translate("square"), Pattern.SQUARE), (translate("zigzag"), Pattern.ZIGZAG)],
        ),
        "tangent": (
            translate("Tangent"),
            translate("How the direction of the edge is found"),
            True,
            [
                (translate("interpolation"), Tangent.INTERPOLATION),
                (translate("planes"), Tangent.PLANES),
                (translate("polynomials"), Tangent.POLYNOMIALS),
            ],
        ),
        "steering": (
            translate("Steering"),
            translate("How the next scan line is placed"),
            True,
            [
                (translate("tangent"), Steering.TANGENT),
                (translate("curvature"), Steering.CURVATURE),
            ],
        ),
        "compensation": (
            translate("Compensation"),
            translate("How the probe radius is taken off"),
            True,
            [
                (translate("point"), Compensation.POINT),
                (translate("curve"), Compensation.CURVE),
                (translate("intersection"), Compensation.INTERSECTION),
                (translate("intersection, as printed"), Compensation.INTERSECTION_PRINTED),
            ],
        ),
    }


class ParameterForm(QtWidgets.QWidget):
    """Shows and changes the parameters of a scan.

    Signals
    -------
    changed() : the user wants other parameters, and has not touched them for a moment
    """

    changed = QtCore.Signal()

    def __init__(self) -> None:
        super().__init__()
        self._method = QtWidgets.QComboBox()
        self._method.addItem(translate("All points (patch)"), PATCH)
        self._method.addItem(translate("Line by line (probe)"), PROBE)
        self._method.setToolTip(
            translate(
                "All points on both sides are the most accurate; line by line touches the cloud "
                "as a measuring machine touches a part"
            )
        )
        self._method.setSizeAdjustPolicy(_NARROW)
        self._reset = QtWidgets.QPushButton(translate("Reset"))
        self._reset.setToolTip(translate("Make every parameter automatic again"))
        hint = _small(QtWidgets.QLabel(translate("Tick a parameter to set it yourself.")))
        self._rows: dict[str, _Row] = {}
        grid = QtWidgets.QGridLayout()
        grid.setColumnStretch(1, 1)
        grid.setVerticalSpacing(1)
        for field, (title, tooltip, probed) in _lengths().items():
            self._rows[field] = _LengthRow(title, tooltip, probed)
        for field, (title, tooltip, probed, values) in _choices().items():
            self._rows[field] = _ChoiceRow(title, tooltip, probed, values)
        for number, row in enumerate(self._rows.values()):
            row.add_to(grid, 2 * number)
            row.changed.connect(self._wait_a_moment)
        top = QtWidgets.QHBoxLayout()
        top.addWidget(hint, 1)
        top.addWidget(self._reset)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(2, 6, 2, 6)
        column.addWidget(self._method)
        column.addLayout(top)
        column.addLayout(grid)
        column.addStretch()
        self._moment = QtCore.QTimer(self)
        self._moment.setSingleShot(True)
        self._moment.setInterval(_SETTLED)
        self._moment.timeout.connect(self.changed)
        self._method.currentIndexChanged.connect(self._show_method)
        self._reset.clicked.connect(self.reset)
        self._show_method()
        self._allow_reset()

    @property
    def method(self) -> str:
        """Patch or probe."""
        return str(self._method.currentData())

    def given(self) -> ScanParameters:
        """The parameters the user has set; None for the others.

        Raises
        ------
        ScanError: a value that cannot work.
        """
        probed = self.method == PROBE
        return ScanParameters(
            **{
                field: row.value()
                for field, row in self._rows.items()
                if row.own and (probed or not row.probed)
            }
        )

    def row(self, field: str) -> _Row:
        """The row of a parameter."""
        return self._rows[field]

    def show_used(self, used: ScanParameters, reasons: Mapping[str, str]) -> None:
        """Show the values a scan has used, and why."""
        for field, row in self._rows.items():
            row.show_used(getattr(used, field), reasons.get(field, ""))

    def set_given(self, given: ScanParameters, method: str) -> None:
        """Show what is set already, as when a scan is edited; this is no change by the user."""
        self._method.blockSignals(True)
        self._method.setCurrentIndex(self._method.findData(method))
        self._method.blockSignals(False)
        self._show_rows()
        for field, row in self._rows.items():
            value = getattr(given, field)
            row.set_own(value is not None, value)
        self._allow_reset()

    def reset(self) -> None:
        """Make every parameter automatic again."""
        owned = [row for row in self._rows.values() if row.own]
        for row in owned:
            row.set_own(False, None)
        if owned:
            self._wait_a_moment()

    def _show_method(self, *_: object) -> None:
        self._show_rows()
        self._wait_a_moment()

    def _show_rows(self) -> None:
        for row in self._rows.values():
            row.set_visible(self.method == PROBE or not row.probed)

    def _wait_a_moment(self) -> None:
        self._allow_reset()
        self._moment.start()

    def _allow_reset(self) -> None:
        self._reset.setEnabled(any(row.own for row in self._rows.values()))

    def stop_waiting(self) -> None:
        """No change counts any more."""
        self._moment.stop()


class _Row(QtCore.QObject):
    """A parameter: a tick and its name, an editor, and the reason below.

    Signals
    -------
    changed() : by the user
    """

    changed = QtCore.Signal()

    def __init__(self, title: str, tooltip: str, probed: bool, editor: Any) -> None:
        super().__init__()
        self.probed = probed
        self.tick = QtWidgets.QCheckBox(title)
        self.tick.setToolTip(tooltip)
        self.editor = editor
        self.editor.setToolTip(tooltip)
        self.editor.setAccessibleName(title)
        self.editor.setMinimumWidth(_EDITOR)
        self.reason = _small(QtWidgets.QLabel(translate("chosen with the first click")))
        self.reason.setContentsMargins(_INDENT, 0, 0, _BELOW)
        self.tick.toggled.connect(self._toggled)
        self.unlock(False)

    @property
    def own(self) -> bool:
        """Whether the user sets the value."""
        return bool(self.tick.isChecked())

    def add_to(self, grid: Any, line: int) -> None:
        """Take two lines of a grid."""
        grid.addWidget(self.tick, line, 0)
        grid.addWidget(self.editor, line, 1)
        grid.addWidget(self.reason, line + 1, 0, 1, 2)

    def set_visible(self, wanted: bool) -> None:
        """Show or hide the row."""
        for widget in (self.tick, self.editor, self.reason):
            widget.setVisible(wanted)

    def set_own(self, own: bool, value: Any) -> None:
        """Set the tick and the value; this is no change by the user."""
        self.tick.blockSignals(True)
        self.tick.setChecked(own)
        self.tick.blockSignals(False)
        self.unlock(own)
        if own:
            self.show_value(value)
            self.reason.setText(translate("set by you"))

    def show_used(self, value: Any, reason: str) -> None:
        """Show what a scan has used, unless the user sets the value."""
        if self.own:
            more = reason.removeprefix("given").lstrip("; ")
            self.reason.setText(more or translate("set by you"))
            return
        self.show_value(value)
        self.reason.setText(reason or translate("not used"))

    def value(self) -> Any:
        """The value in the editor."""
        raise NotImplementedError

    def show_value(self, value: Any) -> None:
        """Put a value into the editor; None: none."""
        raise NotImplementedError

    def unlock(self, own: bool) -> None:
        """Let the user change the value, or only read it."""
        raise NotImplementedError

    def _toggled(self, own: bool) -> None:
        self.unlock(own)
        if own:
            self.reason.setText(translate("set by you"))
            self.editor.setFocus()
        self.changed.emit()


class _LengthRow(_Row):
    """A parameter that is a length."""

    def __init__(self, title: str, tooltip: str, probed: bool) -> None:
        self._known = False
        self.box = LengthBox()
        self.box.widget.setButtonSymbols(QtWidgets.QAbstractSpinBox.NoButtons)  # room to read
        super().__init__(title, tooltip, probed, self.box.widget)
        self.box.changed.connect(self.changed)

    def value(self) -> float:
        return self.box.value

    def show_value(self, value: float | None) -> None:
        self._known = value is not None
        self.box.set(0.0 if value is None else float(value))

    def unlock(self, own: bool) -> None:
        # Not disabled: what is automatic is to be read, too.
        self.box.widget.setReadOnly(not own)

    def _toggled(self, own: bool) -> None:
        if own and not self._known:
            self.show_value(_UNKNOWN_LENGTH)
        super()._toggled(own)


class _ChoiceRow(_Row):
    """A parameter that is one of a few."""

    def __init__(
        self, title: str, tooltip: str, probed: bool, values: list[tuple[str, Any]]
    ) -> None:
        self.box = QtWidgets.QComboBox()
        self._values = [value for _, value in values]
        for name, _ in values:
            self.box.addItem(name)
        self.box.setSizeAdjustPolicy(_NARROW)
        super().__init__(title, tooltip, probed, self.box)
        self.box.activated.connect(lambda _: self.changed.emit())

    def unlock(self, own: bool) -> None:
        self.box.setEnabled(own)

    def value(self) -> Any:
        return self._values[max(self.box.currentIndex(), 0)]

    def show_value(self, value: Any) -> None:
        if value is not None and value not in self._values:
            self._values.append(value)
            self.box.addItem(_as_text(value))
        self.box.setCurrentIndex(-1 if value is None else self._values.index(value))


def _as_text(value: Any) -> str:
    if isinstance(value, tuple):
        return "(" + ", ".join(f"{part:.3g}" for part in value) + ")"
    return str(value)


def _small(label: Any) -> Any:
    """A label for what need not be read first: smaller, wrapped."""
    font = label.font()
    font.setPointSizeF(0.88 * font.pointSizeF())
    label.setFont(font)
    label.setWordWrap(True)
    return label
