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

from .parameter_rows import NARROW, ChoiceRow, LengthRow, Row, small_label
from .qt import QtCore, QtWidgets
from .single_shot import single_shot
from .translation import translate

__all__ = ["ParameterForm"]

PATCH, PROBE = "patch", "probe"
_SETTLED = 400  # ms without another change, after which it counts


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
        self._method.setSizeAdjustPolicy(NARROW)
        self._reset = QtWidgets.QPushButton(translate("Reset"))
        self._reset.setToolTip(translate("Make every parameter automatic again"))
        hint = small_label(QtWidgets.QLabel(translate("Tick a parameter to set it yourself.")))
        self._rows: dict[str, Row] = {}
        grid = QtWidgets.QGridLayout()
        grid.setColumnStretch(1, 1)
        grid.setVerticalSpacing(1)
        for field, (title, tooltip, probed) in _lengths().items():
            self._rows[field] = LengthRow(title, tooltip, probed)
        for field, (title, tooltip, probed, values) in _choices().items():
            self._rows[field] = ChoiceRow(title, tooltip, probed, values)
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
        self._moment = single_shot(self, _SETTLED, self.changed)
        self._method.currentIndexChanged.connect(self._show_method)
        self._reset.clicked.connect(self.reset)
        self._show_rows()
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

    def row(self, field: str) -> Row:
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
