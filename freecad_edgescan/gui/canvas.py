# SPDX-License-Identifier: LGPL-2.1-or-later
"""A widget's painter with the colours of the user's theme, and the few shapes our pictures need.

Everything is in logical pixels, so that it is as large and as sharp on any screen.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .colours import GATE, SIDES, Colour
from .picking import Array
from .qt import QtCore, QtGui, as_int

__all__ = ["Canvas", "flow", "round_steps"]

_SMALL = 0.88  # of the window's font
_SYMBOL = 16  # pixels, width of a legend's symbol


class Canvas:
    """Paints on a widget until ``end``.

    Attributes
    ----------
    painter : Qt's
    ink, muted, accent : colours for what is drawn, what matters less, and what stands out
    """

    def __init__(self, widget: Any) -> None:
        palette = widget.palette()
        ground = palette.color(QtGui.QPalette.Base)
        self.dark = ground.lightnessF() < 0.5
        self.ink = palette.color(QtGui.QPalette.Text)
        self.muted = _mixed(self.ink, ground, 0.45)
        self.accent = _colour(GATE)
        self.painter = QtGui.QPainter(widget)
        self.painter.setRenderHint(QtGui.QPainter.Antialiasing)
        self.painter.fillRect(widget.rect(), ground)
        self._ground = ground
        self._rect = widget.rect()
        font = widget.font()
        font.setPointSizeF(_SMALL * font.pointSizeF())
        self.painter.setFont(font)
        self._metrics = QtGui.QFontMetrics(font)
        self._pen_colour = self.ink

    def end(self) -> None:
        """Paint no more."""
        self.painter.end()

    @property
    def small_height(self) -> int:
        """Height of a line of text."""
        return int(self._metrics.ascent())

    @property
    def line_height(self) -> int:
        """Distance of two lines of text."""
        return int(self._metrics.lineSpacing())

    def side(self, number: int) -> Any:
        """Colour of one of the two surfaces."""
        return _colour(SIDES[self.dark][number])

    def width_of(self, text: str) -> int:
        """Of a text, pixels."""
        return int(self._metrics.horizontalAdvance(text))

    def pen(
        self, colour: Any, width: float, style: Any = QtCore.Qt.SolidLine, alpha: float = 1.0
    ) -> None:
        """Draw from now on like this."""
        shade = QtGui.QColor(colour)
        shade.setAlphaF(alpha)
        pen = QtGui.QPen(shade, width, style)
        pen.setCapStyle(QtCore.Qt.RoundCap)
        pen.setJoinStyle(QtCore.Qt.RoundJoin)
        self.painter.setPen(pen)
        self.painter.setBrush(QtCore.Qt.NoBrush)

    def line(self, x0: float, y0: float, x1: float, y1: float) -> None:
        """Draw a straight line."""
        self.painter.drawLine(QtCore.QPointF(x0, y0), QtCore.QPointF(x1, y1))

    def polyline(self, pixels: Array) -> None:
        """Draw from pixel to pixel, (k, 2); where one is nan there is a gap."""
        path: list[Any] = []
        for x, y in np.asarray(pixels, dtype=float).tolist():
            if np.isfinite(x) and np.isfinite(y) and abs(x) < 1e6 and abs(y) < 1e6:
                path.append(QtCore.QPointF(x, y))
            elif path:
                self.painter.drawPolyline(QtGui.QPolygonF(path))
                path = []
        if path:
            self.painter.drawPolyline(QtGui.QPolygonF(path))

    def area(self, pixels: Array, colour: Any, alpha: float) -> None:
        """Fill a polygon, (k, 2)."""
        shade = QtGui.QColor(colour)
        shade.setAlphaF(alpha)
        corners = [QtCore.QPointF(x, y) for x, y in pixels.tolist()]
        self.painter.setPen(QtCore.Qt.NoPen)
        self.painter.setBrush(shade)
        self.painter.drawPolygon(QtGui.QPolygonF(corners))

    def dots(self, pixels: Array) -> None:
        """Draw points, (n, 2)."""
        inside = self._visible(pixels)
        if len(inside):
            corners = [QtCore.QPointF(x, y) for x, y in inside.tolist()]
            self.painter.drawPoints(QtGui.QPolygonF(corners))

    def crosses(self, pixels: Array, size: float) -> None:
        """Draw diagonal crosses, (n, 2)."""
        for x, y in self._visible(pixels).tolist():
            self.line(x - size, y - size, x + size, y + size)
            self.line(x - size, y + size, x + size, y - size)

    def plus(self, pixel: Array, size: float) -> None:
        """Draw an upright cross."""
        x, y = (float(value) for value in pixel)
        if np.isfinite(x + y) and abs(x) < 1e6 and abs(y) < 1e6:
            self.line(x - size, y, x + size, y)
            self.line(x, y - size, x, y + size)

    def frame(self, box: Any) -> None:
        """A box on which something of its own is drawn."""
        ground = QtGui.QColor(self._ground)
        ground.setAlphaF(0.85)
        self.painter.setPen(QtGui.QPen(self.muted, 1.0))
        self.painter.setBrush(ground)
        self.painter.drawRect(box)

    def text(self, x: float, y: float, text: str, colour: Any = None, small: bool = False) -> None:
        """Write from x on, with the base line at y."""
        self.painter.setPen(self.ink if colour is None else colour)
        if not small:
            self.painter.drawText(QtCore.QPointF(x, y), text)
            return
        usual = self.painter.font()
        font = QtGui.QFont(usual)
        font.setPointSizeF(_SMALL * font.pointSizeF())
        self.painter.setFont(font)
        self.painter.drawText(QtCore.QPointF(x, y), text)
        self.painter.setFont(usual)

    def sentence(self, text: str) -> None:
        """Say something where there is nothing to draw."""
        self.painter.setPen(self.muted)
        flags = as_int(QtCore.Qt.AlignCenter) | as_int(QtCore.Qt.TextWordWrap)
        self.painter.drawText(self._rect.adjusted(12, 12, -12, -12), flags, text)

    def _visible(self, pixels: Array) -> Array:
        pixels = np.asarray(pixels, dtype=float).reshape(-1, 2)
        far = np.array([self._rect.width(), self._rect.height()]) + 20.0
        return pixels[np.all((pixels > -20.0) & (pixels < far), axis=1)]


def flow(canvas: Canvas, entries: Sequence[tuple[str, str, Any, Any]], rect: Any) -> int:
    """Write a legend at the lower end of a rectangle, in as many lines as it takes.

    Parameters
    ----------
    entries : kind of symbol, text, colour and second colour or None, each

    Returns
    -------
    Its height, pixels.
    """
    room, step = rect.width() - 8, canvas.line_height + 1
    places, x, line = [], 0, 0
    for entry in entries:
        width = _SYMBOL + 4 + canvas.width_of(entry[1]) + 10
        if x and x + width > room:
            x, line = 0, line + 1
        places.append((x, line))
        x += width
    height = (line + 1) * step + 6
    top = rect.bottom() - height + 4
    for (kind, text, colour, second), (x, line) in zip(entries, places, strict=True):
        left, middle = 6 + x, top + line * step + step // 2
        _draw_symbol(canvas, kind, left, middle, colour, second or colour)
        canvas.text(left + _SYMBOL + 4, middle + canvas.small_height // 2 - 1, text)
    return height


def round_steps(value: float) -> float:
    """The largest of 1, 2, 5, 10 … that is not above a value."""
    if not value > 0.0 or not np.isfinite(value):
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    return float(max(step for step in (1.0, 2.0, 5.0) if step * power <= value * 1.0001) * power)


def _draw_symbol(canvas: Canvas, kind: str, x: float, y: float, first: Any, second: Any) -> None:
    half = _SYMBOL / 2
    styles = {
        "line": QtCore.Qt.SolidLine,
        "dashes": QtCore.Qt.DashLine,
        "dash-dot": QtCore.Qt.DashDotLine,
    }
    if kind in styles:
        for colour, start, stop in ((first, 0.0, half), (second, half, _SYMBOL)):
            canvas.pen(colour, 1.6, styles[kind])
            if first is second:
                start, stop = 0.0, _SYMBOL
            canvas.line(x + start, y, x + stop, y)
    elif kind == "dots":
        for colour, place in ((first, 0.25), (second, 0.75)):
            canvas.pen(colour, 4.0)
            canvas.dots(np.array([[x + place * _SYMBOL, y]]))
    elif kind == "cross":
        canvas.pen(first, 1.0)
        canvas.crosses(np.array([[x + half, y]]), 2)
    elif kind == "ring":
        canvas.pen(first, 1.2)
        canvas.painter.drawEllipse(QtCore.QPointF(x + half, y), 4.0, 4.0)


def _colour(colour: Colour) -> Any:
    return QtGui.QColor.fromRgbF(*colour)


def _mixed(first: Any, second: Any, share: float) -> Any:
    """A colour between two; share of the second."""
    parts = zip(first.getRgbF()[:3], second.getRgbF()[:3], strict=True)
    return _colour(tuple((1.0 - share) * a + share * b for a, b in parts))  # type: ignore[arg-type]
