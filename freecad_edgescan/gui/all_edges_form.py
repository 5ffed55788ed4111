# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel of all edges looks like: how far it is, which edges are kept, what OK makes."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from freecad_edgescan.scanning.edge_choice import EdgeChoice

from .qt import QtCore, QtWidgets
from .quantities import LengthBox, length_text
from .sentence_form import SentenceForm
from .translation import translate

__all__ = ["AllEdgesForm"]

_NARROW = 80  # pixels
_STEPS = 1000  # of the bar
_SMALLEST_TURN, _LARGEST_TURN = 3.0, 175.0  # degrees


class AllEdgesForm(SentenceForm):
    """The widget inside the task panel; it decides nothing.

    Attributes
    ----------
    stop : the button that ends a running search and keeps what is there
    again : the button that searches for what is missing
    forget : the button that takes back what was clicked

    Signals
    -------
    filters_changed() : the user wants edges of other length, turn or sigma
    """

    filters_changed = QtCore.Signal()

    def __init__(self, title: str, editing: bool) -> None:
        super().__init__(title, "EdgeScan_ScanAllEdges", lines=3)
        self._choice = EdgeChoice()
        self._bar = QtWidgets.QProgressBar()
        self._bar.setRange(0, _STEPS)
        self.stop = QtWidgets.QPushButton(translate("Stop here"))
        self.stop.setToolTip(translate("End the search and keep the edges found so far"))
        self._running = QtWidgets.QWidget()
        row = QtWidgets.QHBoxLayout(self._running)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self._bar, 1)
        row.addWidget(self.stop)
        self.again = QtWidgets.QPushButton(translate("Search again"))
        self.again.setToolTip(translate("Search the whole cloud, also for what is still missing"))
        self._figures = _wrapped()
        self._edge = _wrapped()
        self._edge.setMinimumHeight(2 * self.fontMetrics().lineSpacing())
        self._edge.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)
        self.forget = QtWidgets.QPushButton(translate("Forget clicks"))
        self.forget.setToolTip(translate("Let length, turn and sigma alone decide again"))
        self._shown = _wrapped()
        self.column.setContentsMargins(6, 6, 6, 6)
        above = (self._running, self.again, self._figures)
        for widget in (*above, self._filters(), self._edge, self.forget):
            self.column.addWidget(widget)
        if not editing:
            self.column.addLayout(self._kinds())
        self.column.addWidget(self._shown)
        self.column.addStretch()
        self.show_progress(False)
        self.show_again(False)
        self.show_counts(0, 0, 0.0)
        self.show_largest_sigma(0.0)
        self.show_edge("")

    def _filters(self) -> Any:
        self._length, self._sigma = LengthBox(self), LengthBox(self)
        self._any_sigma = 0.0
        self._limits_sigma = QtWidgets.QCheckBox(translate("Sigma up to"))
        self._limits_sigma.toggled.connect(self._limit_sigma)
        self._length.widget.setToolTip(
            translate("Shorter edges are left out; 0: shorter than eight times the cloud's pitch")
        )
        self._sigma.widget.setToolTip(
            translate("Edges known worse are left out: the median of sigma along them counts")
        )
        self._sigma.widget.setEnabled(False)
        self._turn = QtWidgets.QDoubleSpinBox()
        self._turn.setRange(_SMALLEST_TURN, _LARGEST_TURN)
        self._turn.setDecimals(1)
        self._turn.setSuffix("°")
        self._turn.setSingleStep(5.0)
        self._turn.setKeyboardTracking(False)
        self._turn.setToolTip(
            translate("Edges whose sides turn less are left out: 90° at the edge of a box")
        )
        for box in (self._length, self._sigma):
            box.widget.setMinimumWidth(_NARROW)  # it would widen the dock
            box.changed.connect(self._enter)
        self._turn.valueChanged.connect(lambda _: self._enter())
        group = QtWidgets.QGroupBox(translate("Keep edges"))
        rows = QtWidgets.QFormLayout(group)
        rows.addRow(translate("Length from"), self._length.widget)
        rows.addRow(translate("Turn from"), self._turn)
        rows.addRow(self._limits_sigma, self._sigma.widget)
        return group

    def _kinds(self) -> Any:
        self._kind = QtWidgets.QComboBox()
        self._kind.addItem(translate("One network"))
        self._kind.addItem(translate("Group of edges"))
        self._kind.setToolTip(
            translate(
                "One object whose edges share their corners, or one for each edge that can be "
                "edited by itself"
            )
        )
        self._kind.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        rows = QtWidgets.QFormLayout()
        rows.addRow(translate("OK makes"), self._kind)
        return rows

    @property
    def figures(self) -> str:
        """How many edges are kept."""
        return str(self._figures.text())

    @property
    def edge(self) -> str:
        """What is said about the edge under the mouse."""
        return str(self._edge.text())

    @property
    def one_network(self) -> bool:
        """Whether one object is wanted."""
        return bool(self._kind.currentIndex() == 0)

    def choose_kind(self, one_network: bool) -> None:
        """Offer one object, or one for each edge."""
        self._kind.setCurrentIndex(0 if one_network else 1)

    def filtered(self, choice: EdgeChoice) -> EdgeChoice:
        """A choice with the length, turn and sigma that were entered."""
        shown = self._choice
        turn = shown.min_angle
        if self._turn.value() != round(math.degrees(turn), 1):
            turn = math.radians(self._turn.value())
        return replace(
            choice,
            min_angle=turn,
            min_length=self._length.value,
            max_sigma=self._sigma.value if self._limits_sigma.isChecked() else math.inf,
        )

    def show_choice(self, choice: EdgeChoice) -> None:
        """Show which edges are wanted; this is no change by the user."""
        self._choice = choice
        self._length.set(choice.min_length)
        limited = math.isfinite(choice.max_sigma)
        self._limits_sigma.blockSignals(True)
        self._limits_sigma.setChecked(limited)
        self._limits_sigma.blockSignals(False)
        self._sigma.widget.setEnabled(limited)
        self._sigma.set(choice.max_sigma if limited else self._any_sigma)
        self._turn.blockSignals(True)
        self._turn.setValue(math.degrees(choice.min_angle))
        self._turn.blockSignals(False)
        clicked = len(choice.dropped) + len(choice.kept)
        self.forget.setVisible(clicked > 0)
        self.forget.setText(translate("Forget clicks ({count})").format(count=clicked))

    def show_progress(self, running: bool) -> None:
        """Show or hide how far a search is and the stop button."""
        self._bar.setValue(0)
        self.stop.setEnabled(True)
        self._running.setVisible(running)

    def progress_to(self, share: float) -> None:
        """Show the share of the search that is done."""
        if math.isfinite(share):
            self._bar.setValue(round(_STEPS * share))

    def show_again(self, wanted: bool) -> None:
        """Offer another search, or not."""
        self.again.setVisible(wanted)

    def show_counts(self, kept: int, found: int, length: float) -> None:
        """Show how many of the edges found are kept, and their length, mm."""
        text = translate("{kept} of {found} edges are kept, {length} in all.")
        text = text.format(kept=kept, found=found, length=length_text(length))
        self._figures.setText(text if found else "")

    def show_largest_sigma(self, sigma: float) -> None:
        """Show the sigma up to which all edges are kept, mm, as long as the user wants no other."""
        self._any_sigma = sigma
        if not self._limits_sigma.isChecked():
            self._sigma.set(sigma)

    def show_edge(self, text: str) -> None:
        """Show what there is to say about the edge under the mouse."""
        self._edge.setText(text)

    def show_points(self, shown: int, whole: int) -> None:
        """Say how many points of the cloud are drawn, when that is not all."""
        self._shown.setVisible(shown < whole)
        text = translate("{shown} of {whole} points are shown; all of them are computed with.")
        self._shown.setText(text.format(shown=f"{shown:,}", whole=f"{whole:,}"))

    def _limit_sigma(self, limited: bool) -> None:
        self._sigma.widget.setEnabled(limited)
        self._enter()

    def _enter(self) -> None:
        self.filters_changed.emit()


def _wrapped() -> Any:
    label = QtWidgets.QLabel()
    label.setWordWrap(True)
    return label
