# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel that scans an edge looks like: what to do now, the result, and its evidence."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_edgescan.scanning import ScannedEdge

from ..geometry.plain_number import plain
from .evidence_form import EvidenceForm
from .parameter_form import ParameterForm
from .picked_places import Way
from .qt import QtCore, QtWidgets
from .quantities import angle_text, length_text
from .sentence_form import SentenceForm
from .translation import translate
from .view_form import ViewForm

__all__ = ["ScanEdgeForm"]

_TAB_FONT = 0.88  # of the window's: all tabs are to be seen in a narrow dock


class ScanEdgeForm(SentenceForm):
    """The widget inside the task panel; it decides nothing.

    Attributes
    ----------
    stop : the button that ends a running scan and keeps what is there
    evidence, parameters, view : what is in the three tabs

    Signals
    -------
    way_changed() : other clicks are to tell where to scan
    """

    way_changed = QtCore.Signal()

    def __init__(self, title: str) -> None:
        super().__init__(title, "EdgeScan_ScanEdge", lines=3)
        self._way = QtWidgets.QComboBox()
        self._way.addItem(translate("One click: the whole edge"), Way.WHOLE_EDGE.name)
        self._way.addItem(translate("Two clicks: edge and gate"), Way.TO_A_GATE.name)
        self._way.addItem(translate("3 + 2 clicks: start and gate"), Way.START_AND_GATE.name)
        self._way.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self._way.setToolTip(translate("What your clicks stand for"))
        self._way.currentIndexChanged.connect(lambda _: self.way_changed.emit())
        self.stop = QtWidgets.QPushButton(translate("Stop here"))
        self.stop.setToolTip(translate("End the scan and keep the edge as far as it is known"))
        self._so_far = QtWidgets.QLabel()
        self._figures = QtWidgets.QLabel()
        self._figures.setToolTip(
            translate(
                "Sigma is the standard deviation of an edge point across the edge: about two of "
                "three lie within it. A good edge's is well below the distance of the points."
            )
        )
        self._message = QtWidgets.QLabel()
        for label in (self._figures, self._message):
            label.setWordWrap(True)
            label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self._running = QtWidgets.QWidget()
        # No bar that moves by itself: each of its frames would draw the 3D view anew, too.
        row = QtWidgets.QHBoxLayout(self._running)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self._so_far, 1)
        row.addWidget(self.stop)
        self._result = QtWidgets.QWidget()
        below = QtWidgets.QVBoxLayout(self._result)
        below.setContentsMargins(0, 0, 0, 0)
        below.addWidget(self._figures)
        below.addWidget(self._message)
        self.evidence = EvidenceForm()
        self.parameters = ParameterForm()
        self.view = ViewForm()
        self.tabs = QtWidgets.QTabWidget()
        self.tabs.setDocumentMode(True)
        self.tabs.setUsesScrollButtons(False)
        self.tabs.setElideMode(QtCore.Qt.ElideRight)
        small = self.tabs.font()
        small.setPointSizeF(_TAB_FONT * small.pointSizeF())
        self.tabs.tabBar().setFont(small)
        self.tabs.addTab(self.evidence, translate("Section"))
        self.tabs.addTab(_scrolling(self.parameters), translate("Parameters"))
        self.tabs.addTab(self.view, translate("View"))
        self.column.setContentsMargins(4, 4, 4, 4)
        for widget in (self._way, self._running, self._result):
            self.column.addWidget(widget)
        self.column.addWidget(self.tabs, 1)
        self.show_progress(False)
        self.show_edge(None)

    @property
    def figures(self) -> str:
        """The edge in a few numbers."""
        return str(self._figures.text())

    @property
    def way(self) -> Way:
        """What the clicks stand for."""
        return Way[self._way.currentData()]

    def choose_way(self, way: Way) -> None:
        """Let the clicks stand for something else."""
        self._way.setCurrentIndex(list(Way).index(way))

    def show_progress(self, running: bool) -> None:
        """Show or hide how far a scan is and the stop button."""
        self._so_far.setText(translate("Looking for\nthe edge …"))
        self.stop.setEnabled(True)
        self._running.setVisible(running)
        if running:
            self._result.setVisible(False)

    def progress_to(self, points: Any) -> None:
        """Show how much of the edge there is, edge points (m, 3); nobody knows how much is left."""
        length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
        text = translate("{count} edge points\n{length}")
        self._so_far.setText(text.format(count=len(points), length=length_text(length)))

    def show_edge(self, edge: ScannedEdge | None) -> None:
        """Show the figures of an edge and its evidence, or none."""
        self._result.setVisible(edge is not None)
        self.evidence.show_edge(edge)
        self.view.show_sigma(None if edge is None else edge.sigma)
        if edge is None:
            self._figures.setText("")
            return
        self._figures.setText(_figures(edge))
        self._message.setText(_message(edge))


def _scrolling(widget: Any) -> Any:
    """A long page that scrolls by itself instead of making all pages long."""
    area = QtWidgets.QScrollArea()
    area.setFrameShape(QtWidgets.QFrame.NoFrame)
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
    area.setWidget(widget)
    return area


def _message(edge: ScannedEdge) -> str:
    """What happened, with the edge's length in the user's unit; the scan itself speaks of mm."""
    return edge.message.replace(f" {plain(edge.length, 4)} mm", f" {length_text(edge.length)}", 1)


def _figures(edge: ScannedEdge) -> str:
    text = translate("On average: sigma {sigma}, angle {angle}").format(
        sigma=length_text(float(np.nanmean(edge.sigma))),
        angle=angle_text(float(np.nanmean(edge.angle))),
    )
    radii = edge.fillet_radius[np.isfinite(edge.fillet_radius)]
    if len(radii) >= 0.5 * len(edge):
        radius = length_text(float(np.median(radii)))
        text += translate(", rounding {radius}").format(radius=radius)
    return text
