# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one hidden state of this package: the PointCloud, with its tree, of each Points object.

However many edges are scanned in a cloud, its tree, pitch and noise are worked out once. An entry
is found by its object and is valid while the object's kernel, placement and probe stay as they
are; only a few are kept, and none longer than its document.
"""

from __future__ import annotations

import hashlib
from collections import OrderedDict
from typing import Any

import FreeCAD
import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud
from ..scanning import ScanError
from .bridge import document_points_of

__all__ = ["cloud_checksum", "forget_clouds", "point_cloud", "probe_radius_of"]

MOST_CLOUDS = 8

_clouds: OrderedDict[tuple[str, str], tuple[str, PointCloud]] = OrderedDict()
_watching: list[Any] = []


def point_cloud(obj: Any) -> PointCloud:
    """Give the points of a cloud object as numbers, in the document's coordinates.

    Parameters
    ----------
    obj : Points::Feature

    Returns
    -------
    PointCloud, the same one until the object changes, with the object's probe radius and
    approach. The object's ``Origin`` is not added.

    Raises
    ------
    ValueError: the object is no cloud.
    ScanError: there is none, it is empty, or its probe cannot be.
    """
    return _up_to_date(obj)[1]


def cloud_checksum(obj: Any) -> str:
    """Checksum of a cloud object's points where the document shows them, and of its probe."""
    return _up_to_date(obj)[0]


def probe_radius_of(obj: Any) -> float:
    """Probe radius of a cloud object, mm; 0 for Points objects that are not ours, and for None."""
    return float(getattr(obj, "ProbeRadius", 0.0))


def forget_clouds(doc_name: str, name: str | None = None) -> None:
    """Drop the cloud of one object, or of all objects of a document."""
    for key in list(_clouds):
        if key[0] == doc_name and name in (None, key[1]):
            del _clouds[key]


def _up_to_date(obj: Any) -> tuple[str, PointCloud]:
    if obj is None:
        raise ScanError("The cloud is missing; choose one, or undo its deletion.")
    points = document_points_of(obj)
    if len(points) == 0:
        raise ScanError(
            f"The cloud {obj.Label!r} is empty; import its points again, or choose another cloud."
        )
    radius, approach = _probe(obj)
    checksum = _checksum(points, radius, approach)
    key = (obj.Document.Name, obj.Name)
    entry = _clouds.get(key)
    if entry is None or entry[0] != checksum:
        try:
            entry = (checksum, PointCloud(points, radius, approach))
        except ValueError as error:
            raise ScanError(f"The cloud {obj.Label!r} cannot be scanned: {error}") from error
        _clouds[key] = entry
        _watch()
    _clouds.move_to_end(key)
    while len(_clouds) > MOST_CLOUDS:
        _clouds.popitem(last=False)
    return entry


def _probe(obj: Any) -> tuple[float, NDArray[np.float64] | None]:
    radius = probe_radius_of(obj)
    approach = np.array(getattr(obj, "Approach", (0.0, 0.0, 0.0)), dtype=float)
    return radius, approach if np.any(approach) else None


def _checksum(
    points: NDArray[np.float64], radius: float, approach: NDArray[np.float64] | None
) -> str:
    digest = hashlib.blake2b(points.data, digest_size=16)
    digest.update(repr((radius, None if approach is None else approach.tolist())).encode())
    return digest.hexdigest()


class _Observer:
    """FreeCAD tells it what disappears."""

    def slotDeletedDocument(self, doc: Any) -> None:
        forget_clouds(doc.Name)

    def slotDeletedObject(self, obj: Any) -> None:
        forget_clouds(obj.Document.Name, obj.Name)


def _watch() -> None:
    if not _watching:
        _watching.append(_Observer())
        FreeCAD.addDocumentObserver(_watching[0])
