# SPDX-License-Identifier: LGPL-2.1-or-later
"""The evidence for a scanned edge: the section at one edge point, and what is known along it."""

from __future__ import annotations

import numpy as np

from freecad_edgescan.scanning import ScannedEdge, section_outline

from .edge_plots import EdgePlots
from .qt import QtCore, QtWidgets
from .quantities import angle_text, length_scale, length_text
from .section_view import SectionView
from .translation import translate

__all__ = ["EvidenceForm"]


class EvidenceForm(QtWidgets.QWidget):
    """Section, slider, numbers and plots of one edge; they always show the same edge point.

    Attributes
    ----------
    section, slider, plots : the widgets
    number : of the edge point that is shown

    Signals
    -------
    chosen(number) : another edge point is shown
    """

    chosen = QtCore.Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self._edge: ScannedEdge | None = None
        self.section = SectionView()
        self.section.stepped.connect(lambda steps: self.show_number(self.number + steps))
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setToolTip(translate("Go along the edge"))
        self.slider.setAccessibleName(translate("Edge point"))
        self.slider.valueChanged.connect(self._show)
        self._where = QtWidgets.QLabel()
        self._numbers = QtWidgets.QLabel()
        self._numbers.setWordWrap(True)
        for label in (self._where, self._numbers):
            label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self.plots = EdgePlots()
        self.plots.chosen.connect(self.show_number)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 4, 0, 0)
        column.setSpacing(4)
        column.addWidget(self.section, 3)
        along = QtWidgets.QHBoxLayout()
        along.addWidget(self.slider, 1)
        along.addWidget(self._where)
        column.addLayout(along)
        column.addWidget(self._numbers)
        column.addWidget(self.plots, 2)
        self.show_edge(None)

    @property
    def number(self) -> int:
        """The edge point that is shown."""
        return int(self.slider.value())

    @property
    def numbers(self) -> str:
        """What is said about it."""
        return str(self._numbers.text())

    def show_edge(self, edge: ScannedEdge | None) -> None:
        """Show another edge at its middle, or none."""
        self._edge = edge if edge is not None and len(edge) else None
        self.section.show_all()
        self.plots.show_edge(self._edge)
        self.slider.blockSignals(True)
        self.slider.setRange(0, 0 if self._edge is None else len(self._edge) - 1)
        self.slider.setValue(self.slider.maximum() // 2)
        self.slider.blockSignals(False)
        self.slider.setEnabled(self._edge is not None)
        self._show(self.number)

    def show_number(self, number: int) -> None:
        """Show another edge point."""
        self.slider.setValue(int(np.clip(number, 0, self.slider.maximum())))

    def _show(self, number: int) -> None:
        edge = self._edge
        self.section.show_outline(None if edge is None else section_outline(edge, number))
        if edge is None:
            self._where.setText("")
            self._numbers.setText("")
            return
        self.plots.show_number(number)
        self._where.setText(
            translate("{number} of {count}").format(number=number + 1, count=len(edge))
        )
        self._numbers.setText(_numbers_of(edge, number))
        self.chosen.emit(number)


def _numbers_of(edge: ScannedEdge, number: int) -> str:
    radius, spread = float(edge.fillet_radius[number]), float(edge.fillet_sigma[number])
    sigma = translate("sigma {length}").format(length=length_text(float(edge.sigma[number])))
    angle = translate("angle {angle}").format(angle=angle_text(float(edge.angle[number])))
    rounding = translate("no rounding measurable")
    if np.isfinite(radius):
        factor, unit = length_scale(radius)
        rounding = translate("rounding {radius} ± {sigma} {unit}").format(
            radius=f"{radius / factor:.2f}", sigma=f"{spread / factor:.2f}", unit=unit
        )
    parts = [sigma, angle, rounding]
    if not edge.supported[number]:
        parts.append(translate("rests on its neighbours"))
    return " · ".join(parts)
