# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line of sight under the cursor of a 3D view, for either kind of camera."""

from __future__ import annotations

from typing import Any

import FreeCADGui
import numpy as np

from .picking import Array, ViewRay

__all__ = ["view_ray"]

PICK_PIXELS = 4  # logical pixels


def view_ray(view: Any, position: tuple[int, int], pixels: float = PICK_PIXELS) -> ViewRay:
    """Line of sight through a pixel.

    Parameters
    ----------
    view : the 3D view, as ``FreeCADGui.ActiveDocument.ActiveView``
    position : pixel counted from the lower left corner, as events of the view give it
    pixels : pick radius in logical pixels
    """
    ratio = FreeCADGui.getMainWindow().devicePixelRatioF()
    x, y = position
    aside = max(round(pixels * ratio), 1)
    near, far = _line(view, x, y)
    near_aside, far_aside = _line(view, x + aside, y)
    length = float(np.linalg.norm(far - near))
    first = float(np.linalg.norm(near_aside - near))
    last = float(np.linalg.norm(far_aside - far))
    return ViewRay(near, np.divide(far - near, length), first, (last - first) / length)


def _line(view: Any, x: int, y: int) -> tuple[Array, Array]:
    """Where the line of sight enters and leaves what the camera sees."""
    near, far = (np.array(tuple(end)) for end in view.projectPointToLine(x, y))
    return near, far
