# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clicks, moves of the mouse and the Esc key in a 3D view, while a panel listens to it.

Meanwhile the view selects nothing: selecting and highlighting search through every point of a
cloud each time the mouse moves.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

__all__ = ["Pixel", "ViewClicks", "is_open"]

_STILL = 5  # pixels the mouse may move between press and release of a click
_LISTENS = ("SoMouseButtonEvent", "SoLocation2Event", "SoKeyboardEvent")

Pixel = tuple[int, int]


def is_open(view: Any) -> bool:
    """Whether a 3D view is still there; FreeCAD refuses everything of one that was closed."""
    try:
        # Not called: while a document closes, FreeCAD 0.20 does not survive all of its functions.
        return view.removeEventCallback is not None
    except (RuntimeError, ReferenceError):
        return False


def _nothing(*_: object) -> None:
    """Who listens no longer keeps nobody alive."""


class ViewClicks:
    """Listens to a view until ``close``.

    Parameters
    ----------
    view : the 3D view
    clicked : called with the pixel (x, y) from the lower left corner at each left click that is
        no drag
    escaped : called when Esc is pressed over the view
    moved : called with the pixel at each move of the mouse with no button pressed
    """

    def __init__(
        self,
        view: Any,
        clicked: Callable[[Pixel], None],
        escaped: Callable[[], None],
        moved: Callable[[Pixel], None],
    ) -> None:
        self._view: Any = view
        self._clicked = clicked
        self._moved = moved
        self._escaped = escaped
        self._pressed: Pixel | None = None
        self._held: set[str] = set()
        answers = (self._on_button, self._on_move, self._on_key)
        self._callbacks = [
            (kind, view.addEventCallback(kind, answer))
            for kind, answer in zip(_LISTENS, answers, strict=True)
        ]
        self._selects = view.getSceneGraph().getField("selectionRole")
        self._let_select(False)

    def close(self) -> None:
        """Listen no longer, and let the view select again."""
        if self._view is None:
            return
        view, self._view = self._view, None
        if is_open(view):
            for kind, callback in self._callbacks:
                view.removeEventCallback(kind, callback)
            self._let_select(True)
        self._callbacks = []
        self._clicked = self._moved = self._escaped = _nothing

    def _let_select(self, wanted: bool) -> None:
        if self._selects is not None:
            self._selects.setValue(wanted)

    def _on_button(self, event: dict[str, Any]) -> None:
        down = event["State"] == "DOWN"
        (self._held.add if down else self._held.discard)(event["Button"])
        if event["Button"] != "BUTTON1":
            return
        x, y = event["Position"]
        if down:
            self._pressed = (x, y)
        elif self._pressed is not None:
            moved = max(abs(x - self._pressed[0]), abs(y - self._pressed[1]))
            self._pressed = None
            if moved <= _STILL:
                self._clicked((x, y))

    def _on_move(self, event: dict[str, Any]) -> None:
        if not self._held:
            x, y = event["Position"]
            self._moved((x, y))

    def _on_key(self, event: dict[str, Any]) -> None:
        if event["Key"] == "ESCAPE" and event["State"] == "UP":
            self._escaped()
