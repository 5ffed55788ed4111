# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sigma, angle and rounding along a scanned edge, one plot above the other.

A click goes to the edge point there, and so do the arrow keys; the mouse reads values.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from freecad_edgescan.scanning import ScannedEdge

from .canvas import Canvas
from .colours import EDGE
from .picking import Array
from .qt import QtCore, QtGui, QtWidgets
from .quantities import length_scale
from .translation import translate

__all__ = ["EdgePlots"]

_LEFT, _RIGHT = 6, 8  # pixels beside the plots
_LEAST_ANGLES = 2.0  # degrees, of the angles' axis: below it a plot would make much of nothing
_HEADROOM = 1.12


@dataclass(frozen=True)
class _Curve:
    """One plot: its title, values, spread of the values, axis, and how a value is written."""

    title: str
    values: Array
    spread: Array
    low: float
    high: float
    form: str

    def text(self, number: int) -> str:
        value = self.values[number]
        return self.form.format(value) if np.isfinite(value) else "–"


class EdgePlots(QtWidgets.QWidget):
    """Draws what is known of an edge along it.

    Signals
    -------
    chosen(number) : an edge point was clicked on, or reached by an arrow key
    """

    chosen = QtCore.Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self._along: Array = np.zeros(0)
        self._supported = np.zeros(0, dtype=bool)
        self._curves: tuple[_Curve, ...] = ()
        self._axis = ("", 0.0)
        self._number = 0
        self._hovered: int | None = None
        self.setMinimumSize(170, 132)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Preferred)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(translate("Sigma, angle and rounding along the edge"))
        self.setToolTip(translate("Click to see the section there. Arrows: along the edge"))

    def sizeHint(self) -> Any:
        """Three low plots."""
        return QtCore.QSize(240, 156)

    def show_edge(self, edge: ScannedEdge | None) -> None:
        """Draw another edge, or none."""
        self._hovered = None
        self._number = 0
        self._curves = ()
        if edge is not None and len(edge):
            steps = np.linalg.norm(np.diff(edge.points, axis=0), axis=1)
            along = np.append(0.0, np.cumsum(steps))
            factor, unit = length_scale(float(along[-1]))
            self._along = along / factor
            self._axis = (unit, float(self._along[-1]))
            self._supported = np.asarray(edge.supported, dtype=bool)
            self._curves = (_sigma(edge), _angle(edge), _fillet(edge))
        self.update()

    def show_number(self, number: int) -> None:
        """Mark an edge point."""
        self._number = number
        self.update()

    # What Qt calls.

    def paintEvent(self, event: Any) -> None:
        """Draw everything."""
        canvas = Canvas(self)
        if not self._curves:
            canvas.sentence(translate("Sigma, angle and rounding along the edge are shown here."))
        else:
            boxes = self._boxes(canvas)
            for curve, box in zip(self._curves, boxes, strict=True):
                self._draw_curve(canvas, curve, box)
            self._draw_axis(canvas, boxes[-1])
        canvas.end()

    def mousePressEvent(self, event: Any) -> None:
        """Go to the edge point there."""
        self._choose(event)

    def mouseMoveEvent(self, event: Any) -> None:
        """Read the values there, or go along with the button pressed."""
        self._hovered = self._number_at(event.pos().x())
        if event.buttons() != QtCore.Qt.NoButton:
            self._choose(event)
        self.update()

    def leaveEvent(self, event: Any) -> None:
        """Read the values of the chosen point again."""
        self._hovered = None
        self.update()

    def keyPressEvent(self, event: Any) -> None:
        """Go along the edge."""
        last = len(self._along) - 1
        to = {
            QtCore.Qt.Key_Left: self._number - 1,
            QtCore.Qt.Key_Right: self._number + 1,
        }.get(event.key())
        if to is None or not self._curves:
            super().keyPressEvent(event)
        else:
            self.chosen.emit(int(np.clip(to, 0, last)))

    # The rest.

    def _choose(self, event: Any) -> None:
        number = self._number_at(event.pos().x())
        if number is not None:
            self.chosen.emit(number)

    def _number_at(self, x: float) -> int | None:
        if not self._curves:
            return None
        share = (x - _LEFT) / max(self.width() - _LEFT - _RIGHT, 1)
        return int(np.argmin(np.abs(self._along - share * self._along[-1])))

    def _boxes(self, canvas: Canvas) -> list[Any]:
        """Where each curve is drawn, below its title."""
        height = (self.height() - canvas.line_height - 2) / len(self._curves)
        width = self.width() - _LEFT - _RIGHT
        top = canvas.line_height + 2
        return [
            QtCore.QRectF(_LEFT, number * height + top, width, max(height - top - 3, 8))
            for number in range(len(self._curves))
        ]

    def _draw_curve(self, canvas: Canvas, curve: _Curve, box: Any) -> None:
        number = self._number if self._hovered is None else self._hovered
        base = box.top() - 4
        canvas.text(box.left(), base, curve.title)
        shown = curve.text(number)
        canvas.text(box.right() - canvas.width_of(shown), base, shown)
        canvas.pen(canvas.muted, 1.0)
        canvas.painter.drawRect(box)
        x = self._x(box)
        colour = QtGui.QColor.fromRgbF(*EDGE)
        if not np.isfinite(curve.values).any():
            canvas.text(
                box.left() + 6,
                box.center().y() + canvas.small_height / 2,
                translate("none measurable"),
                canvas.muted,
            )
        else:
            self._draw_spread(canvas, curve, box, x, colour)
            y = _y(curve, curve.values, box)
            canvas.pen(colour, 1.6)
            canvas.polyline(np.column_stack([x, np.where(self._supported, y, np.nan)]))
            canvas.pen(colour, 1.2, QtCore.Qt.DotLine)
            canvas.polyline(np.column_stack([x, y]))
            if len(x) <= 0.25 * box.width():
                canvas.pen(colour, 3.0)
                canvas.dots(np.column_stack([x, y]))
        self._draw_marks(canvas, box, x)

    def _draw_spread(self, canvas: Canvas, curve: _Curve, box: Any, x: Array, colour: Any) -> None:
        """One sigma above and below the values."""
        known = np.isfinite(curve.values) & np.isfinite(curve.spread)
        if known.sum() < 2:
            return
        for stretch in np.split(
            np.flatnonzero(known), np.flatnonzero(np.diff(np.flatnonzero(known)) > 1) + 1
        ):
            above, below = (
                _y(curve, curve.values[stretch] + way * curve.spread[stretch], box)
                for way in (1.0, -1.0)
            )
            corners = np.column_stack(
                [np.append(x[stretch], x[stretch][::-1]), np.append(above, below[::-1])]
            )
            canvas.area(corners, colour, 0.2)

    def _draw_marks(self, canvas: Canvas, box: Any, x: Array) -> None:
        canvas.pen(canvas.ink, 1.4)
        canvas.line(x[self._number], box.top(), x[self._number], box.bottom())
        if self._hovered is not None:
            canvas.pen(canvas.muted, 1.2, QtCore.Qt.DashLine)
            canvas.line(x[self._hovered], box.top(), x[self._hovered], box.bottom())

    def _draw_axis(self, canvas: Canvas, box: Any) -> None:
        unit, last = self._axis
        low = self.height() - 5
        end = f"{last:.4g} {unit}"
        canvas.text(box.left(), low, "0", canvas.muted)
        canvas.text(box.right() - canvas.width_of(end), low, end, canvas.muted)
        title = translate("along the edge")
        canvas.text(box.center().x() - canvas.width_of(title) / 2, low, title, canvas.muted)

    def _x(self, box: Any) -> Array:
        return np.asarray(box.left() + self._along / max(self._along[-1], 1e-12) * box.width())


def _y(curve: _Curve, values: Array, box: Any) -> Array:
    share = (values - curve.low) / max(curve.high - curve.low, 1e-12)
    return np.asarray(box.bottom() - np.clip(share, 0.0, 1.0) * box.height())


def _sigma(edge: ScannedEdge) -> _Curve:
    sigma = np.asarray(edge.sigma, dtype=float)
    factor, unit = length_scale(float(np.nanmax(sigma)) if np.isfinite(sigma).any() else 1.0)
    values = sigma / factor
    high = _HEADROOM * float(np.nanmax(values)) if np.isfinite(values).any() else 1.0
    return _Curve(
        translate("Sigma"), values, np.full(len(values), np.nan), 0.0, high, f"{{:.3g}} {unit}"
    )


def _angle(edge: ScannedEdge) -> _Curve:
    values = np.degrees(np.asarray(edge.angle, dtype=float))
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    more = max(0.5 * (_LEAST_ANGLES - (high - low)), 0.06 * (high - low))
    return _Curve(
        translate("Angle"),
        values,
        np.full(len(values), np.nan),
        low - more,
        high + more,
        "{:.1f}°",
    )


def _fillet(edge: ScannedEdge) -> _Curve:
    radius = np.asarray(edge.fillet_radius, dtype=float)
    largest = float(np.nanmax(radius)) if np.isfinite(radius).any() else 1.0
    factor, unit = length_scale(largest)
    return _Curve(
        translate("Rounding radius"),
        radius / factor,
        np.asarray(edge.fillet_sigma, dtype=float) / factor,
        0.0,
        _HEADROOM * largest / factor,
        f"{{:.3g}} {unit}",
    )
