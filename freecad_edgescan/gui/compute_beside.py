# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects that a command has made, computed while the window stays alive and may cancel."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from freecad_edgescan.document.computed_object import ComputedProxy, write_computed

from .busy import result_of

__all__ = ["computing_beside"]


def computing_beside(title: str) -> Callable[[list[Any]], None]:
    """What computes new objects, for `run_as_one_step`; the recompute after it has nothing to do.

    Parameters
    ----------
    title : what the user waits for

    Raises
    ------
    ValueError: an object cannot be computed; the text says why.
    CancelledError: the user has cancelled.
    """

    def compute(made: list[Any]) -> None:
        for item in made:
            proxy = getattr(item, "Proxy", None)
            ready = not any("Touched" in source.State for source in item.OutList)
            if isinstance(proxy, ComputedProxy) and proxy.PLAIN and ready:
                write_computed(item, result_of(proxy.task(item), title))

    return compute
