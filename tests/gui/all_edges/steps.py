# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person does in the panel of all edges, and the box that is searched for them."""

from __future__ import annotations

from typing import Any

import FreeCADGui as Gui

SIZE = (24.0, 18.0, 12.0)
PITCH = 0.5
TOP_FRONT = (10.0, 0.0, 12.0)  # on an edge along x that is seen from the front
UPRIGHT = (24.0, 0.0, 6.0)


def opened(window: Any) -> Any:
    Gui.runCommand("EdgeScan_ScanAllEdges")
    window.settle()
    return window.panel


def found(window: Any) -> Any:
    panel = opened(window)
    ended(window)
    return panel


def ended(window: Any) -> None:
    """Wait until nothing is searched any more."""
    window.settle()
    window.wait_until(lambda: window.panel._work is None)


def kept_and_left_out(window: Any) -> tuple[int, int]:
    return window.panel._display.counts


def networks(window: Any) -> list[Any]:
    return [o for o in window.doc.Objects if "EdgeNetwork" in type(getattr(o, "Proxy", 0)).__name__]


def edit(window: Any, network: Any) -> None:
    """Double click on the network in the tree."""
    network.ViewObject.Proxy.doubleClicked(network.ViewObject)
    ended(window)


def enter(box: Any, value: float) -> None:
    """Enter a length in a field."""
    box.widget.setProperty("rawValue", value)
