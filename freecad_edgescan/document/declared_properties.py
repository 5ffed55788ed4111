# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties of a document object, declared in one list.

The list is applied when an object is made and again when it is restored from a file, so that old
files get the properties that were added since.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from typing import Any

__all__ = ["Declared", "Role", "declare"]


class Role(Enum):
    """What a property is for."""

    INPUT = "input"
    RESULT = "result"
    HIDDEN_RESULT = "hidden result"


# FreeCAD's attributes: 1 read-only, 4 hidden, 8 output (a change does not ask for a recompute).
_ATTRIBUTES = {
    Role.INPUT: 0,
    Role.RESULT: 1 + 8,
    Role.HIDDEN_RESULT: 1 + 4 + 8,
}


@dataclass(frozen=True)
class Declared:
    """One property: its FreeCAD type without ``App::Property``, name, group, tooltip and role."""

    kind: str
    name: str
    group: str
    tooltip: str
    role: Role = Role.INPUT
    choices: tuple[str, ...] = ()


def declare(obj: Any, properties: Iterable[Declared]) -> None:
    """Add to an object the declared properties it does not have yet."""
    present = set(obj.PropertiesList)
    for item in properties:
        if item.name not in present:
            obj.addProperty(
                f"App::Property{item.kind}",
                item.name,
                item.group,
                item.tooltip,
                _ATTRIBUTES[item.role],
            )
            if item.choices:
                setattr(obj, item.name, list(item.choices))
                setattr(obj, item.name, item.choices[0])
        elif item.choices and list(obj.getEnumerationsOfProperty(item.name)) != list(item.choices):
            value = getattr(obj, item.name)
            setattr(obj, item.name, list(item.choices))
            setattr(obj, item.name, value)
