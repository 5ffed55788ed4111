# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clicks and the Esc key in a 3D view, while a panel listens to it.

Meanwhile the view selects nothing: selecting and highlighting search through every point of a
cloud each time the mouse moves.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

__all__ = ["ViewClicks"]

_STILL = 5  # pixels the mouse may move between press and release of a click


class ViewClicks:
    """Listens to a view until ``close``.

    Parameters
    ----------
    view : the 3D view
    clicked : called with the pixel (x, y) from the lower left corner at each left click that is
        no drag
    escaped : called when Esc is pressed over the view
    """

    def __init__(
        self,
        view: Any,
        clicked: Callable[[tuple[int, int]], None],
        escaped: Callable[[], None],
    ) -> None:
        self._view: Any = view
        self._clicked = clicked
        self._escaped = escaped
        self._pressed: tuple[int, int] | None = None
        self._buttons = view.addEventCallback("SoMouseButtonEvent", self._on_button)
        self._keys = view.addEventCallback("SoKeyboardEvent", self._on_key)
        self._selects = view.getSceneGraph().getField("selectionRole")
        self._let_select(False)

    def close(self) -> None:
        """Listen no longer, and let the view select again."""
        if self._view is None:
            return
        view, self._view = self._view, None
        view.removeEventCallback("SoMouseButtonEvent", self._buttons)
        view.removeEventCallback("SoKeyboardEvent", self._keys)
        self._let_select(True)

    def _let_select(self, wanted: bool) -> None:
        if self._selects is not None:
            self._selects.setValue(wanted)

    def _on_button(self, event: dict[str, Any]) -> None:
        if event["Button"] != "BUTTON1":
            return
        x, y = event["Position"]
        if event["State"] == "DOWN":
            self._pressed = (x, y)
        elif self._pressed is not None:
            moved = max(abs(x - self._pressed[0]), abs(y - self._pressed[1]))
            self._pressed = None
            if moved <= _STILL:
                self._clicked((x, y))

    def _on_key(self, event: dict[str, Any]) -> None:
        if event["Key"] == "ESCAPE" and event["State"] == "UP":
            self._escaped()
