# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the window as small grey arrays, and how alike two of them are.

The likeness is the structural similarity of Wang et al., "Image quality assessment: from error
visibility to structural similarity", IEEE Transactions on Image Processing 13 (2004) 600-612,
equation 13, with a square window. Its mean over a picture hardly notices a button that is missing;
what counts here is the place where two pictures are least alike.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter

from freecad_edgescan.gui.qt import QtCore, QtGui, QtWidgets

__all__ = ["WIDTH", "least_alike", "of_the_screen", "picture_of", "read_picture", "write_picture"]

Picture = NDArray[np.float64]

WIDTH = 480  # pixels; twice as many on the screen and more are scaled down
_WINDOW = 7  # pixels, of the structural similarity
_PLACE = 13  # pixels, about a button
_SMALL = (0.01**2, 0.03**2)  # what steadies the quotients, for greys from 0 to 1


def least_alike(one: Picture, other: Picture) -> float:
    """Structural similarity where two pictures are least alike: 1 of the same, about 0 of others.

    Parameters
    ----------
    one, other : (height, width) greys from 0 to 1; of different sizes they are not alike at all
    """
    if one.shape != other.shape:
        return 0.0
    mean_1, mean_2 = uniform_filter(one, _WINDOW), uniform_filter(other, _WINDOW)
    variance_1 = uniform_filter(one * one, _WINDOW) - mean_1**2
    variance_2 = uniform_filter(other * other, _WINDOW) - mean_2**2
    shared = uniform_filter(one * other, _WINDOW) - mean_1 * mean_2
    light, structure = _SMALL
    similarity = (2 * mean_1 * mean_2 + light) * (2 * shared + structure)
    similarity /= (mean_1**2 + mean_2**2 + light) * (variance_1 + variance_2 + structure)
    return float(uniform_filter(similarity, _PLACE).min())


def picture_of(image: Any) -> Picture:
    """An image of Qt's as greys (height, width) from 0 to 1, no wider than 480 pixels."""
    smooth = QtCore.Qt.SmoothTransformation
    small = image.scaledToWidth(WIDTH, smooth) if image.width() > WIDTH else image
    grey = small.convertToFormat(QtGui.QImage.Format_Grayscale8)
    bits = grey.constBits() if hasattr(grey, "constBits") else grey.bits()
    rows = np.frombuffer(bytes(bits), np.uint8).reshape(grey.height(), grey.bytesPerLine())
    return rows[:, : grey.width()] / 255.0


def read_picture(path: Path) -> Picture:
    """A picture that was written."""
    return picture_of(QtGui.QImage(str(path)))


def write_picture(picture: Picture, path: Path) -> None:
    """Write a PNG."""
    path.parent.mkdir(parents=True, exist_ok=True)
    height, width = picture.shape
    rows = np.ascontiguousarray((255.0 * picture).round().astype(np.uint8))
    image = QtGui.QImage(rows.tobytes(), width, height, width, QtGui.QImage.Format_Grayscale8)
    assert image.save(str(path), "png", 0), f"{path} cannot be written"


def of_the_screen(widget: Any, part: Any) -> Picture:
    """What the screen shows in a part of a widget, a QRect, 3D views included."""
    place = widget.mapToGlobal(part.topLeft())
    screen = QtWidgets.QApplication.primaryScreen()
    shot = screen.grabWindow(0, place.x(), place.y(), part.width(), part.height())
    return picture_of(shot.toImage())
