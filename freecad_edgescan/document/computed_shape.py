# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a computed shape is written into its object."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from .native_curve import vector

__all__ = ["write_shape"]


def write_shape(obj: Any, shape: Any, message: str, origin: ArrayLike) -> None:
    """Write a shape of the object's own coordinates; the object stays where it stands."""
    shape.Placement = obj.Placement.multiply(shape.Placement)
    obj.Shape = shape
    obj.Message = message
    obj.Origin = vector(origin)
