# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cross-section of a scanned edge, drawn: the evidence for one edge point.

The wheel zooms, a drag moves, a double click shows all of it again; the arrow keys go along the
edge. The edge point is mostly known far better than a pixel: an inset magnifies its ellipses.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from freecad_edgescan.scanning import SectionOutline
from freecad_edgescan.scanning.section_outline import circle_points

from .canvas import Canvas, flow, round_steps
from .picking import Array
from .qt import QtCore, QtWidgets
from .quantities import length_text
from .translation import translate

__all__ = ["SectionView"]

_MARGIN = 8  # pixels
_INSET = 78  # pixels, side of the magnified edge point
_CLEAR = 10  # pixels between the inset and the edge point itself
_INSET_SIGMAS = 6.0  # across the inset
_NEAREST, _FARTHEST = 0.5, 2000.0  # zoom


class SectionView(QtWidgets.QWidget):
    """Draws a SectionOutline.

    Signals
    -------
    stepped(steps) : an arrow key asks for another edge point
    """

    stepped = QtCore.Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self._outline: SectionOutline | None = None
        self._zoom = 1.0
        self._shift = QtCore.QPointF(0.0, 0.0)
        self._pressed: Any = None
        self._mouse: Any = None
        self.setMinimumSize(170, 160)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Expanding)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(translate("Cross-section of the edge"))
        self.setToolTip(translate("Wheel: zoom. Drag: move. Double click: show all. Arrows: along"))

    def sizeHint(self) -> Any:
        """As wide as there is room, and not too high for a small screen."""
        return QtCore.QSize(240, 215)

    def show_outline(self, outline: SectionOutline | None) -> None:
        """Draw another section, or none."""
        self._outline = outline
        self.update()

    def show_all(self) -> None:
        """Forget zoom and shift."""
        self._zoom, self._shift = 1.0, QtCore.QPointF(0.0, 0.0)
        self.update()

    # What Qt calls.

    def paintEvent(self, event: Any) -> None:
        """Draw everything."""
        canvas = Canvas(self)
        if self._outline is None:
            canvas.sentence(translate("The section across the edge is shown here."))
            canvas.end()
            return
        legend = self._legend(canvas, self._outline)
        area = self.rect().adjusted(0, 0, 0, -legend)
        canvas.painter.save()
        canvas.painter.setClipRect(area)
        to_pixel = self._mapping(area)
        _draw_outline(canvas, self._outline, to_pixel)
        corners = _by_emptiness(area, _shape_of(self._outline, to_pixel))
        self._draw_inset(canvas, corners[0], self._outline)
        self._draw_scale_bar(canvas, next(b for b in corners if not b.intersects(corners[0])))
        self._draw_place(canvas, area)
        canvas.painter.restore()
        canvas.end()

    def wheelEvent(self, event: Any) -> None:
        """Zoom about the cursor."""
        factor = 1.0015 ** event.angleDelta().y()
        zoom = float(np.clip(self._zoom * factor, _NEAREST, _FARTHEST))
        factor = zoom / self._zoom
        place = event.position() if hasattr(event, "position") else event.posF()
        centre = QtCore.QPointF(self._area().center())
        self._shift = place - centre - (place - centre - self._shift) * factor
        self._zoom = zoom
        event.accept()
        self.update()

    def mousePressEvent(self, event: Any) -> None:
        """Begin to move."""
        self._pressed = event.pos()

    def mouseMoveEvent(self, event: Any) -> None:
        """Move, or tell where the mouse is."""
        if self._pressed is not None:
            self._shift += QtCore.QPointF(event.pos() - self._pressed)
            self._pressed = event.pos()
        self._mouse = event.pos()
        self.update()

    def mouseReleaseEvent(self, event: Any) -> None:
        """Moved."""
        self._pressed = None

    def mouseDoubleClickEvent(self, event: Any) -> None:
        """Show all."""
        self.show_all()

    def leaveEvent(self, event: Any) -> None:
        """No place to tell any more."""
        self._mouse = None
        self.update()

    def keyPressEvent(self, event: Any) -> None:
        """Go along the edge."""
        steps = {QtCore.Qt.Key_Left: -1, QtCore.Qt.Key_Right: 1}.get(event.key())
        if steps is None:
            super().keyPressEvent(event)
        else:
            self.stepped.emit(steps)

    # Where things are.

    def _area(self) -> Any:
        return self.rect().adjusted(0, 0, 0, -self._legend_height)

    _legend_height = 0

    def _mapping(self, area: Any) -> _Mapping:
        assert self._outline is not None
        low, high = _extent(self._outline)
        room = np.maximum(np.array([area.width(), area.height()]) - 2 * _MARGIN, 10)
        scale = float((room / np.maximum(high - low, 1e-9)).min()) * self._zoom
        centre = area.center()
        origin = np.array([centre.x() + self._shift.x(), centre.y() + self._shift.y()])
        return _Mapping((low + high) / 2.0, scale, origin)

    # What is drawn.

    def _legend(self, canvas: Canvas, outline: SectionOutline) -> int:
        entries = [
            ("dots", translate("points"), canvas.side(0), canvas.side(1)),
            ("cross", translate("of no side"), canvas.muted, None),
            ("line", translate("fitted sides"), canvas.side(0), canvas.side(1)),
        ]
        if outline.probe_radius:
            entries.append(("dashes", translate("surface"), canvas.ink, None))
            entries.append(("ring", translate("probe"), canvas.accent, None))
        if outline.fillet is not None:
            entries.append(("dash-dot", translate("rounding"), canvas.ink, None))
        self._legend_height = flow(canvas, entries, self.rect())
        return self._legend_height

    def _draw_scale_bar(self, canvas: Canvas, box: Any) -> None:
        scale = self._mapping(self._area()).scale
        length = round_steps(box.width() / scale)
        pixels = length * scale
        left, low = box.center().x() - 0.5 * pixels, box.center().y()
        canvas.pen(canvas.ink, 1.5)
        canvas.line(left, low, left + pixels, low)
        canvas.line(left, low - 3, left, low + 3)
        canvas.line(left + pixels, low - 3, left + pixels, low + 3)
        text = length_text(length)
        canvas.text(box.center().x() - canvas.width_of(text) / 2, low - 6, text)

    def _draw_inset(self, canvas: Canvas, box: Any, outline: SectionOutline) -> None:
        half = np.sqrt(max(float(np.linalg.eigvalsh(outline.covariance)[-1]), 0.0))
        if not np.isfinite(half) or half <= 0.0:
            return
        canvas.frame(box)
        scale = _INSET / (_INSET_SIGMAS * half)
        middle = np.array([box.center().x(), box.center().y()])
        for sigmas, style in ((2.0, QtCore.Qt.SolidLine), (1.0, QtCore.Qt.DotLine)):
            ring = outline.ellipse(sigmas) - outline.line.edge_point
            canvas.pen(canvas.ink, 1.2, style)
            canvas.polyline(middle + ring * [scale, -scale])
        canvas.pen(canvas.ink, 1.2)
        canvas.plus(middle, 4)
        canvas.text(box.left() + 3, box.bottom() - 4, f"2σ = {length_text(2.0 * half)}", small=True)

    def _draw_place(self, canvas: Canvas, area: Any) -> None:
        """Coordinates of the mouse, from the edge point."""
        if self._mouse is None or not area.contains(self._mouse) or self._outline is None:
            return
        mapping = self._mapping(area)
        place = mapping.back(np.array([self._mouse.x(), self._mouse.y()]))
        across, out = place - self._outline.line.edge_point
        text = translate("{across} across, {out} out").format(
            across=length_text(across), out=length_text(out)
        )
        canvas.text(area.left() + _MARGIN, area.top() + _MARGIN + canvas.small_height, text)


class _Mapping:
    """From the section's plane to pixels: the same scale both ways, upwards is up."""

    def __init__(self, middle: Array, scale: float, origin: Array) -> None:
        self.middle, self.scale, self.origin = middle, scale, origin

    def __call__(self, places: Array) -> Array:
        return np.asarray(self.origin + (places - self.middle) * [self.scale, -self.scale])

    def back(self, pixel: Array) -> Array:
        return np.asarray((pixel - self.origin) / [self.scale, -self.scale] + self.middle)


def _extent(outline: SectionOutline) -> tuple[Array, Array]:
    """Lowest and highest corner of what is shown at first, with the edge point in the middle."""
    places = _shape_of(outline, lambda places: places)
    low, high = places.min(axis=0), places.max(axis=0)
    middle = outline.line.edge_point[0]
    half = max(high[0] - middle, middle - low[0])
    return np.array([middle - half, low[1]]), np.array([middle + half, high[1]])


def _shape_of(outline: SectionOutline, to_pixel: Callable[[Array], Array]) -> Array:
    """Places of everything that matters in a section, (n, 2)."""
    line = outline.line
    balls = [circle_points(centre, outline.probe_radius)[::10] for centre in outline.balls]
    parts = [line.points, *line.curves, *outline.surfaces, *balls, line.edge_point[None]]
    return to_pixel(np.vstack(parts))


def _by_emptiness(area: Any, pixels: Array) -> list[Any]:
    """The corners of an area, and the middles above and below, as boxes; the emptiest first."""
    lefts = (
        area.left() + _MARGIN,
        area.center().x() - _INSET / 2,
        area.right() - _INSET - _MARGIN,
    )
    tops = (area.top() + _MARGIN, area.bottom() - _INSET - _MARGIN)
    boxes = [QtCore.QRectF(left, top, _INSET, _INSET) for top in tops for left in lefts[::-1]]

    def crowd(box: Any) -> int:
        low = np.array([box.left(), box.top()])
        inside = int(np.all((pixels > low) & (pixels < low + _INSET), axis=1).sum())
        # The last one is the edge point, which nothing may cover.
        clear = np.any((pixels[-1] < low - _CLEAR) | (pixels[-1] > low + _INSET + _CLEAR))
        return inside if clear else inside + len(pixels)

    return sorted(boxes, key=crowd)


def _draw_outline(canvas: Canvas, outline: SectionOutline, to_pixel: _Mapping) -> None:
    line = outline.line
    removed = np.asarray(line.removed, dtype=bool)
    canvas.pen(canvas.muted, 1.0)
    canvas.crosses(to_pixel(line.points[removed]), 2)
    for side in (0, 1):
        canvas.pen(canvas.side(side), 3.2, alpha=0.55)
        canvas.dots(to_pixel(line.points[(line.side == side) & ~removed]))
    for side in (0, 1):
        canvas.pen(canvas.side(side), 1.6)
        canvas.polyline(to_pixel(line.curves[side]))
    if outline.probe_radius:
        canvas.pen(canvas.ink, 1.2, QtCore.Qt.DashLine)
        for surface in outline.surfaces:
            canvas.polyline(to_pixel(surface))
        canvas.pen(canvas.accent, 1.0)
        for centre in outline.balls:
            canvas.polyline(to_pixel(circle_points(centre, outline.probe_radius)))
            canvas.plus(to_pixel(centre), 2)
    if outline.fillet is not None:
        canvas.pen(canvas.ink, 1.0, QtCore.Qt.DashDotLine)
        canvas.polyline(to_pixel(circle_points(*outline.fillet)))
    canvas.pen(canvas.ink, 1.2)
    canvas.polyline(to_pixel(outline.ellipse(2.0)))
    canvas.pen(canvas.ink, 2.0)
    canvas.plus(to_pixel(line.edge_point), 6)
