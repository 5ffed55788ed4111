# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects that compute only when an input has changed since the last time.

A file keeps shapes with some digits less than memory does. So inputs are compared as far as a
millionth of a mm: an object that was read from a file has nothing to compute.

Computing has three steps: inputs are read from the document, the result is computed from plain
data, and written into the document. The middle one may run beside the window.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable
from typing import Any, ClassVar

import numpy as np

from ..geometry import BSplineCurve, BSplineSurface
from ..scanning import Progress
from .declared_properties import Declared, Role, declare
from .refusal import RefusalError

__all__ = ["MESSAGE", "ORIGIN", "ComputedProxy", "Task", "result", "write_computed"]

Task = Callable[[Progress | None], Any]
"""Computes a result from plain data; where progress answers False, the result so far."""

_SCHEMA_VERSION = 1
_DECIMALS = 6

_RECORD = (
    Declared(
        "Integer", "SchemaVersion", "Record", "Version of these properties", Role.HIDDEN_RESULT
    ),
    Declared("String", "InputHash", "Record", "Inputs the result belongs to", Role.HIDDEN_RESULT),
)


def result(kind: str, name: str, tooltip: str) -> Declared:
    """A property that the object computes."""
    return Declared(kind, name, "Result", tooltip, Role.RESULT)


MESSAGE = result("String", "Message", "What happened, and what to try")
ORIGIN = result(
    "Vector",
    "Origin",
    "Add this to the document's coordinates to get those of the cloud's source",
)


class ComputedProxy:
    """What makes such an object compute. It keeps no state: everything lives in properties.

    A kind of object says which properties it has besides ``InputHash``, what its result depends
    on, what computes it, and how it is written. One of its properties is ``Message``.
    """

    PROPERTIES: ClassVar[tuple[Declared, ...]] = ()
    PLAIN: ClassVar[bool] = True
    """Whether the task needs nothing of FreeCAD's, and may run in another thread."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        declare(obj, (*self.PROPERTIES, *_RECORD))
        obj.SchemaVersion = _SCHEMA_VERSION

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Everything the result depends on: numbers, texts, arrays, curves and surfaces.

        Raises
        ------
        ValueError: an input is missing or cannot be used.
        """
        raise NotImplementedError

    def task(self, obj: Any) -> Task:
        """Read the present inputs, and answer what computes the result from them.

        Raises
        ------
        ValueError: an input is missing or cannot be used. The task raises it where the result
            cannot be computed; the text says why.
        """
        raise NotImplementedError

    def write(self, obj: Any, result: Any) -> None:
        """Write what the task has computed."""
        raise NotImplementedError

    def is_empty(self, obj: Any) -> bool:
        """Whether there is no result yet."""
        return bool(obj.Shape.isNull())

    def execute(self, obj: Any) -> None:
        """Compute when an input has changed; what is refused leaves the result made before."""
        refused = self._compute_if_changed(obj)
        if refused is not None:
            raise RefusalError(refused)

    def _compute_if_changed(self, obj: Any) -> str | None:
        try:
            inputs = _hash(self.depends_on(obj))  # refuses what is missing
            if self.is_empty(obj) or obj.InputHash != inputs:
                write_computed(obj, self.task(obj)(None))
        except ValueError as error:
            obj.InputHash = ""
            obj.Message = str(error)
            return str(error)
        return None

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring an object of an older file up to date."""
        declare(obj, (*self.PROPERTIES, *_RECORD))
        while obj.SchemaVersion < _SCHEMA_VERSION:
            obj.SchemaVersion += 1

    def dumps(self) -> None:
        """Nothing to write into the file."""
        return None

    def loads(self, state: object) -> None:
        """Nothing to read from the file."""

    # FreeCAD before 0.21.2 asks for these instead.
    __getstate__ = dumps
    __setstate__ = loads


def write_computed(obj: Any, result: Any) -> None:
    """Write a result that belongs to an object's present inputs: it is not computed again."""
    obj.Proxy.write(obj, result)
    obj.InputHash = _hash(obj.Proxy.depends_on(obj))


def _hash(values: Iterable[object]) -> str:
    digest = hashlib.blake2b(digest_size=16)
    for value in values:
        for part in _parts(value):
            digest.update(part)
            digest.update(b"\n")
    return digest.hexdigest()


def _parts(value: object) -> Iterable[bytes]:
    if isinstance(value, BSplineCurve):
        for own in (value.poles, value.knots, value.weights):
            yield from _parts(own)
    elif isinstance(value, BSplineSurface):
        for own in (value.poles, *value.knots, value.weights):
            yield from _parts(own)
    elif isinstance(value, np.ndarray):
        # Adding zero makes -0.0 the 0.0 that it is.
        yield (np.round(value, _DECIMALS) + 0.0).tobytes()
    else:
        yield repr(value).encode()
