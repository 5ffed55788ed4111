# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the objects of a file written without a screen look when it is opened with one.

FreeCAD keeps looks in a member of its files that it only writes when it has a window, and hides
everything in a file without it. This adds that member to a finished file.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import quoteattr
from zipfile import ZIP_DEFLATED, ZipFile

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Look", "write_appearance"]

Array = NDArray[np.float64]
Colour = tuple[float, float, float]

_MEMBER = "GuiDocument.xml"
_UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Look:
    """How one object looks.

    Attributes
    ----------
    colour : of faces or points, red, green and blue from 0 to 1
    line_colour : of edges; None for objects without any
    line_width : of edges, pixels
    transparency : of faces, percent
    visible : whether it is shown
    view : module and class of our own view provider, for objects that have one
    """

    colour: Colour
    line_colour: Colour | None = None
    line_width: float = 2.0
    transparency: int = 0
    visible: bool = True
    view: tuple[str, str] | None = None


def write_appearance(
    path: str | Path, looks: Mapping[str, Look], box: tuple[ArrayLike, ArrayLike], view: ArrayLike
) -> None:
    """Add looks and a camera to a FreeCAD file that was saved without a screen.

    Parameters
    ----------
    path : .FCStd file
    looks : by the objects' names
    box : lowest and highest corner of what the camera shall see, mm
    view : (3,) direction from the part towards the viewer

    Raises
    ------
    ValueError: the file has an appearance already.
    """
    providers = "".join(_provider(name, look) for name, look in looks.items())
    text = (
        "<?xml version='1.0' encoding='utf-8'?>\n"
        '<Document SchemaVersion="1">\n'
        f'<ViewProviderData Count="{len(looks)}">\n{providers}</ViewProviderData>\n'
        f"<Camera settings={_attribute(_camera(box, view))}/>\n</Document>\n"
    )
    with ZipFile(path, "a", compression=ZIP_DEFLATED) as file:
        if _MEMBER in file.namelist():
            raise ValueError(f"{path} has an appearance already; save it anew without a screen.")
        file.writestr(_MEMBER, text)


def _provider(name: str, look: Look) -> str:
    properties = [
        _property(
            "Visibility", "App::PropertyBool", f'<Bool value="{str(look.visible).lower()}"/>'
        ),
        _colour("ShapeColor", look.colour),
        _property(
            "Transparency", "App::PropertyPercent", f'<Integer value="{look.transparency}"/>'
        ),
    ]
    if look.line_colour is not None:
        width = f'<Float value="{look.line_width}"/>'
        properties += [
            _colour("LineColor", look.line_colour),
            _colour("PointColor", look.line_colour),
            _property("LineWidth", "App::PropertyFloatConstraint", width),
        ]
    if look.view is not None:
        module, kind = look.view
        stateless = f'<Python value="bnVsbA==" encoded="yes" module="{module}" class="{kind}"/>'
        properties.append(_property("Proxy", "App::PropertyPythonObject", stateless))
    return (
        f'<ViewProvider name="{name}" expanded="0">\n'
        f'<Properties Count="{len(properties)}" TransientCount="0">\n{"".join(properties)}'
        "</Properties>\n</ViewProvider>\n"
    )


def _property(name: str, kind: str, value: str) -> str:
    return f'<Property name="{name}" type="{kind}">{value}</Property>\n'


def _colour(name: str, colour: Colour) -> str:
    red, green, blue = (round(255 * part) for part in colour)
    packed = (red << 24) + (green << 16) + (blue << 8)
    return _property(name, "App::PropertyColor", f'<PropertyColor value="{packed}"/>')


def _camera(box: tuple[ArrayLike, ArrayLike], view: ArrayLike) -> str:
    """Coin's words for an orthographic camera that sees the whole box from a direction."""
    low, high = (np.asarray(corner, dtype=np.float64) for corner in box)
    size = float(np.linalg.norm(high - low))
    towards = np.asarray(view, dtype=np.float64) / np.linalg.norm(view)
    position = (low + high) / 2 + size * towards
    axis, angle = _turn(towards)
    lines = [
        "OrthographicCamera {",
        "  viewportMapping ADJUST_CAMERA",
        f"  position {_text(position)}",
        f"  orientation {_text(axis)}  {angle:.7g}",
        "  nearDistance 0",
        f"  farDistance {2 * size:.7g}",
        "  aspectRatio 1",
        f"  focalDistance {size:.7g}",
        f"  height {0.55 * size:.7g}",
        "}",
    ]
    return "\n".join(lines) + "\n"


def _turn(towards: Array) -> tuple[Array, float]:
    """Axis and angle that turn a camera looking down z, y upwards, to look from a direction."""
    right = np.cross(_UP, towards)
    right = np.array([1.0, 0.0, 0.0]) if not right.any() else right / np.linalg.norm(right)
    turned = np.column_stack([right, np.cross(towards, right), towards])
    axis = np.array(
        [turned[2, 1] - turned[1, 2], turned[0, 2] - turned[2, 0], turned[1, 0] - turned[0, 1]]
    )
    sine = float(np.linalg.norm(axis)) / 2
    if sine < 1e-9:
        return np.array([1.0, 0.0, 0.0]), 0.0
    return axis / (2 * sine), float(np.arctan2(sine, (np.trace(turned) - 1) / 2))


def _text(vector: Array) -> str:
    return " ".join(f"{value:.7g}" for value in vector)


def _attribute(text: str) -> str:
    return quoteattr(text, {"\n": "&#10;"})
