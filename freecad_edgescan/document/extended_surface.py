# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric extended surface: another object's surface, made longer over one side.

The name of this module and of `ExtendedSurfaceProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ..geometry import BSplineSurface
from ..surfacing import Side, extend_surface
from .bridge import origin_of
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task
from .computed_shape import write_shape
from .declared_properties import Declared
from .given_numbers import finite_number, positive_number
from .linked_geometry import linked_surface, require_shape
from .native_surface import surface_shape

__all__ = ["ExtendedSurfaceProxy", "make_extended_surface"]

_SIDES = tuple(str(side.value) for side in Side)

_PROPERTIES = (
    Declared("LinkGlobal", "Base", "Extension", "The surface that is extended: one face"),
    Declared(
        "Enumeration",
        "Side",
        "Extension",
        "Over which side: at the first (0) or last (1) parameter in u or v",
        choices=_SIDES,
    ),
    Declared(
        "Float",
        "Ratio",
        "Extension",
        "Parameter range of the extension, as a share of that of the surface",
    ),
    Declared("Bool", "UseTau", "Extension", "Whether Tau is given; else it is chosen"),
    Declared("Float", "Tau", "Extension", "τ of the extension: how its weights go on"),
    MESSAGE,
    ORIGIN,
)


def make_extended_surface(
    doc: Any,
    base: Any,
    side: Side | str = "u0",
    ratio: float = 0.25,
    tau: float | None = None,
    name: str = "ExtendedSurface",
) -> Any:
    """Make a surface that goes on over a side of another; `doc.recompute()` computes it.

    Parameters
    ----------
    doc : App.Document
    base : object whose Shape is one face
    side : "u0", "u1", "v0" or "v1"
    ratio : parameter range of the extension, as a share of that of the surface
    tau : τ of the extension; None: it is chosen
    name : of the object

    Returns
    -------
    Part::FeaturePython whose Shape is one B-spline face, the extension included.

    Raises
    ------
    ValueError: a base without a shape, no such side, or a ratio that is not positive.
    """
    require_shape("base surface", [base])
    if str(side) not in _SIDES:
        raise ValueError(f"A surface has no side {side!r}; choose {', '.join(_SIDES)}.")
    ratio = positive_number("ratio of the extension", ratio)
    tau = None if tau is None else finite_number("τ of the extension", tau)
    obj = doc.addObject("Part::FeaturePython", name)
    ExtendedSurfaceProxy(obj)
    obj.Base, obj.Side, obj.Ratio = base, str(side), ratio
    obj.UseTau, obj.Tau = tau is not None, tau or 0.0
    return obj


class ExtendedSurfaceProxy(ComputedProxy):
    """What makes the object extend."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Base surface, side, ratio and τ."""
        yield linked_surface(obj.Base, "base surface")
        yield from (obj.Side, obj.Ratio, obj.UseTau, obj.UseTau and obj.Tau)

    def task(self, obj: Any) -> Task:
        """What extends the surface."""
        surface = linked_surface(obj.Base, "base surface")
        side, ratio = obj.Side, positive_number("ratio of the extension", obj.Ratio)
        tau = finite_number("τ of the extension", obj.Tau) if obj.UseTau else None
        return lambda _progress: extend_surface(surface, side, ratio, tau)

    def write(self, obj: Any, result: BSplineSurface) -> None:
        """Write the longer surface."""
        shape = surface_shape(result)
        write_shape(obj, shape, "", origin_of(obj.Base))
