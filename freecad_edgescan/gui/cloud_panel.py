# SPDX-License-Identifier: LGPL-2.1-or-later
"""What task panels have in common that are answered by clicks on clouds."""

from __future__ import annotations

from typing import Any

from .clicked_cloud import Picked
from .cloud_clicks import CloudClicks
from .view_panel import ViewPanel

__all__ = ["CloudPanel"]


class CloudPanel(ViewPanel):
    """A panel that is told which point of which visible cloud is clicked on.

    Parameters
    ----------
    doc : App.Document whose visible clouds can be clicked
    view : the 3D view in front, which is clicked in
    form : the widget FreeCAD shows
    """

    def __init__(self, doc: Any, view: Any, form: Any) -> None:
        super().__init__(doc, view, form)
        self._clicks = CloudClicks(doc, view, self._document_watch)
        self._clicks.picked.connect(self.take)
        self._clicks.missed.connect(self.say_and_ask)
        self._clicks.lost.connect(self.lose)
        self._clicks.escaped.connect(self.leave_soon)

    def take(self, picked: Picked) -> None:
        """A point of a cloud was clicked on."""
        raise NotImplementedError

    def lose(self, sentence: str) -> None:
        """The cloud that was clicked on has changed or is gone; the sentence says so."""
        raise NotImplementedError

    def let_go(self, restore: bool) -> None:
        """Take everything out of the view, end threads and observers."""
        super().let_go(restore)
        self._clicks.close()
