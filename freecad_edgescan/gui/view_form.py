# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the 3D view shows the cloud and the edge while the panel is open."""

from __future__ import annotations

from typing import Any

from .colours import sigma_colours, sigma_range
from .picking import Array
from .qt import QtCore, QtGui, QtWidgets
from .quantities import length_text
from .translation import count_text, translate

__all__ = ["ViewForm"]

_STEPS = 64  # of the colour bar
_LARGEST_POINT = 10


class ViewForm(QtWidgets.QWidget):
    """Choices about the 3D view.

    Signals
    -------
    changed() : one of the choices
    look_along() : the user wants to see the section from the end of the edge
    """

    changed = QtCore.Signal()
    look_along = QtCore.Signal()

    def __init__(self) -> None:
        super().__init__()
        self._sigma = _tick(
            translate("Colour by sigma"),
            translate("Blue: well known. Yellow: the least known points of this edge"),
            True,
        )
        self._bar = _ColourBar()
        self._lines = _tick(
            translate("Scan lines"),
            translate("Show where across the edge each point was measured"),
            True,
        )
        self._slab = _tick(
            translate("Only points at the section"),
            translate("Hide the points before and behind the section that is looked at"),
            False,
        )
        self._look = QtWidgets.QPushButton(translate("Look along the edge"))
        self._look.setToolTip(translate("Turn the view so that the section is seen as it is drawn"))
        self._size = QtWidgets.QSpinBox()
        self._size.setRange(0, _LARGEST_POINT)
        self._size.setSpecialValueText(translate("own"))
        self._size.setToolTip(translate("Of the cloud's points, in pixels; own: as elsewhere"))
        self._cloud = QtWidgets.QLabel()
        self._cloud.setWordWrap(True)
        row = QtWidgets.QFormLayout()
        row.addRow(translate("Point size"), self._size)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        for widget in (self._sigma, self._bar, self._lines, self._slab, self._look):
            column.addWidget(widget)
        column.addLayout(row)
        column.addWidget(self._cloud)
        column.addStretch()
        for tick in (self._sigma, self._lines, self._slab):
            tick.toggled.connect(self.changed)
        self._size.valueChanged.connect(lambda _: self.changed.emit())
        self._look.clicked.connect(self.look_along)
        self.show_sigma(None)

    @property
    def by_sigma(self) -> bool:
        """Whether edge points have the colour of their sigma."""
        return bool(self._sigma.isChecked())

    @property
    def scan_lines(self) -> bool:
        """Whether scan lines are shown."""
        return bool(self._lines.isChecked())

    @property
    def slab_only(self) -> bool:
        """Whether only the points at the section are shown."""
        return bool(self._slab.isChecked())

    @property
    def point_size(self) -> float | None:
        """Size of the cloud's points, pixels; None: the document's."""
        return float(self._size.value()) or None

    def show_sigma(self, sigma: Array | None) -> None:
        """Show what the colours mean for these edge points, or that there are none."""
        self._bar.show_range(None if sigma is None or not len(sigma) else sigma_range(sigma))
        self._look.setEnabled(sigma is not None)

    def show_counts(self, shown: int, whole: int) -> None:
        """Say how many points of the clouds are drawn."""
        text = translate("All {whole} points are shown.")
        if shown < whole:
            text = translate("{shown} of {whole} points are shown; all of them are computed with.")
        self._cloud.setText(text.format(shown=count_text(shown), whole=count_text(whole)))


class _ColourBar(QtWidgets.QWidget):
    """The colours of sigma, from the smallest to the largest."""

    def __init__(self) -> None:
        super().__init__()
        self._range: tuple[float, float] | None = None
        self.setFixedHeight(12 + 2 * self.fontMetrics().height() // 2 + 8)

    def show_range(self, values: tuple[float, float] | None) -> None:
        self._range = values
        self.setVisible(values is not None)
        self.update()

    def paintEvent(self, event: Any) -> None:
        if self._range is None:
            return
        painter = QtGui.QPainter(self)
        low, high = self._range
        shades = sigma_colours([low + (high - low) * k / (_STEPS - 1) for k in range(_STEPS)])
        step = self.width() / _STEPS
        for number, shade in enumerate(shades.tolist()):
            box = QtCore.QRectF(number * step, 0.0, step + 1.0, 12.0)
            painter.fillRect(box, QtGui.QColor.fromRgbF(*shade))
        base = 14 + self.fontMetrics().ascent()
        last = length_text(high)
        painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
        painter.drawText(QtCore.QPointF(0.0, base), length_text(low))
        width = self.fontMetrics().horizontalAdvance(last)
        painter.drawText(QtCore.QPointF(self.width() - width, base), last)
        painter.end()


def _tick(title: str, tooltip: str, on: bool) -> Any:
    tick = QtWidgets.QCheckBox(title)
    tick.setToolTip(tooltip)
    tick.setChecked(on)
    return tick
