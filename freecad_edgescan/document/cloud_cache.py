# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one hidden state of this package: the PointCloud, with its tree, of each Points object.

However many edges are scanned in a cloud, its tree, pitch and noise are worked out once. An entry
is found by its object and is valid while the object's kernel, placement and probe stay as they
are; only a few are kept, and none longer than its document. FreeCAD tells when a kernel is
exchanged: reading all points again to see that they are the same takes seconds for a large cloud.
"""

from __future__ import annotations

import hashlib
from collections import OrderedDict
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import FreeCAD
import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud
from ..scanning import ScanError
from .bridge import document_blocks_of, document_points_of, global_placement

__all__ = ["cloud_checksum", "forget_clouds", "point_cloud", "probe_radius_of"]

MOST_CLOUDS = 8

Key = tuple[str, str]
Probe = tuple[float, tuple[float, ...]]


@dataclass
class _Entry:
    """A cloud with its checksum, and what else it was made of.

    Attributes
    ----------
    place : matrix of where the object stood
    probe : radius and approach
    exchanged : whether the object has got another kernel since
    """

    checksum: str
    cloud: PointCloud
    place: tuple[float, ...]
    probe: Probe
    exchanged: bool = False


_clouds: OrderedDict[Key, _Entry] = OrderedDict()
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
    return _up_to_date(obj).cloud


def cloud_checksum(obj: Any) -> str:
    """Checksum of a cloud object's points where the document shows them, and of its probe."""
    return _up_to_date(obj).checksum


def probe_radius_of(obj: Any) -> float:
    """Probe radius of a cloud object, mm; 0 for Points objects that are not ours, and for None."""
    return float(getattr(obj, "ProbeRadius", 0.0))


def forget_clouds(doc_name: str, name: str | None = None) -> None:
    """Drop the cloud of one object, or of all objects of a document."""
    for key in list(_clouds):
        if key[0] == doc_name and name in (None, key[1]):
            del _clouds[key]


def _up_to_date(obj: Any) -> _Entry:
    if obj is None:
        raise ScanError("The cloud is missing; choose one, or undo its deletion.")
    key = (obj.Document.Name, obj.Name)
    place, probe = tuple(global_placement(obj).toMatrix().A), _probe(obj)
    entry = _clouds.get(key)
    if entry is not None and (entry.exchanged or (entry.place, entry.probe) != (place, probe)):
        if entry.checksum == _checksum(document_blocks_of(obj), probe):
            entry.place, entry.exchanged = place, False
        else:  # its memory is needed
            entry = None
            del _clouds[key]
    if entry is None:
        entry = _clouds[key] = _read(obj, place, probe)
        _watch()
    _clouds.move_to_end(key)
    while len(_clouds) > MOST_CLOUDS:
        _clouds.popitem(last=False)
    return entry


def _read(obj: Any, place: tuple[float, ...], probe: Probe) -> _Entry:
    points = document_points_of(obj)
    if len(points) == 0:
        raise ScanError(
            f"The cloud {obj.Label!r} is empty; import its points again, or choose another cloud."
        )
    points.setflags(write=False)  # which the cloud takes as they are
    try:
        cloud = PointCloud(points, probe[0], probe[1] if any(probe[1]) else None)
    except ValueError as error:
        raise ScanError(f"The cloud {obj.Label!r} cannot be scanned: {error}") from error
    return _Entry(_checksum([points], probe), cloud, place, probe)


def _probe(obj: Any) -> Probe:
    return probe_radius_of(obj), tuple(getattr(obj, "Approach", (0.0, 0.0, 0.0)))


def _checksum(blocks: Iterable[NDArray[np.float64]], probe: Probe) -> str:
    digest = hashlib.blake2b(digest_size=16)
    for block in blocks:
        digest.update(np.ascontiguousarray(block).data)
    radius, approach = probe
    digest.update(repr((radius, list(approach) if any(approach) else None)).encode())
    return digest.hexdigest()


class _Observer:
    """FreeCAD tells it what disappears, and what gets other points."""

    def slotChangedObject(self, obj: Any, name: str) -> None:
        if name == "Points" and (entry := _clouds.get((obj.Document.Name, obj.Name))):
            entry.exchanged = True

    def slotFinishRestoreDocument(self, doc: Any) -> None:
        forget_clouds(doc.Name)

    def slotDeletedDocument(self, doc: Any) -> None:
        forget_clouds(doc.Name)

    def slotDeletedObject(self, obj: Any) -> None:
        forget_clouds(obj.Document.Name, obj.Name)


def _watch() -> None:
    if not _watching:
        _watching.append(_Observer())
        FreeCAD.addDocumentObserver(_watching[0])
