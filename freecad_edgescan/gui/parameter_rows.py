# SPDX-License-Identifier: LGPL-2.1-or-later
"""One parameter on the screen: a tick and its name, an editor, and the reason of its value."""

from __future__ import annotations

from typing import Any

from .qt import QtCore, QtWidgets
from .quantities import LengthBox
from .translation import translate

__all__ = ["NARROW", "ChoiceRow", "LengthRow", "Row", "small_label"]

NARROW = QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon
_EDITOR = 76  # pixels, in which a length can be read
_INDENT, _BELOW = 20, 5  # pixels round a reason, so that it is seen what it belongs to
_UNKNOWN_LENGTH = 0.1  # mm, where nothing is known yet that could be changed


class Row(QtCore.QObject):
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
        self.reason = small_label(QtWidgets.QLabel(translate("chosen with the first click")))
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


class LengthRow(Row):
    """A parameter that is a length."""

    def __init__(self, title: str, tooltip: str, probed: bool) -> None:
        self._known = False
        self.box = LengthBox()
        self.box.widget.setButtonSymbols(QtWidgets.QAbstractSpinBox.NoButtons)  # room to read
        super().__init__(title, tooltip, probed, self.box.widget)
        self.box.changed.connect(self.changed)

    def value(self) -> float:
        """The value in the editor."""
        return self.box.value

    def show_value(self, value: float | None) -> None:
        """Put a value into the editor; None: none."""
        self._known = value is not None
        self.box.set(0.0 if value is None else float(value))

    def unlock(self, own: bool) -> None:
        """Let the user change the value, or only read it."""
        # Not disabled: what is automatic is to be read, too.
        self.box.widget.setReadOnly(not own)

    def _toggled(self, own: bool) -> None:
        if own and not self._known:
            self.show_value(_UNKNOWN_LENGTH)
        super()._toggled(own)


class ChoiceRow(Row):
    """A parameter that is one of a few."""

    def __init__(
        self, title: str, tooltip: str, probed: bool, values: list[tuple[str, Any]]
    ) -> None:
        self.box = QtWidgets.QComboBox()
        self._values = [value for _, value in values]
        for name, _ in values:
            self.box.addItem(name)
        self.box.setSizeAdjustPolicy(NARROW)
        super().__init__(title, tooltip, probed, self.box)
        self.box.activated.connect(lambda _: self.changed.emit())

    def unlock(self, own: bool) -> None:
        """Let the user change the value, or only read it."""
        self.box.setEnabled(own)

    def value(self) -> Any:
        """The value in the editor."""
        return self._values[max(self.box.currentIndex(), 0)]

    def show_value(self, value: Any) -> None:
        """Put a value into the editor; None: none."""
        if value is not None and value not in self._values:
            self._values.append(value)
            self.box.addItem(_as_text(value))
        self.box.setCurrentIndex(-1 if value is None else self._values.index(value))


def _as_text(value: Any) -> str:
    if isinstance(value, tuple):
        return "(" + ", ".join(f"{part:.3g}" for part in value) + ")"
    return str(value)


def small_label(label: Any) -> Any:
    """A label for what need not be read first: smaller, wrapped."""
    font = label.font()
    font.setPointSizeF(0.88 * font.pointSizeF())
    label.setFont(font)
    label.setWordWrap(True)
    return label
