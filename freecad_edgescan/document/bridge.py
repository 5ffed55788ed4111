# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between numpy arrays and FreeCAD's Points kernels.

A kernel writes and reads its points as float32 in a small archive in memory; taking them from
there is about twenty times as fast as asking for them one by one. Where an archive is not as
expected, the points go one by one.

A kernel's points are its own: neither the object's placement nor that of the parts it is in has
been applied. ``Origin`` is what was subtracted from points far away before they became float32.
"""

from __future__ import annotations

import io
import struct
import zipfile
from collections.abc import Iterator
from typing import IO, Any

import FreeCAD
import numpy as np
import Points
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "array_from_kernel",
    "array_from_kernel_by_list",
    "document_blocks_of",
    "document_points_of",
    "global_placement",
    "kernel_from_array",
    "kernel_from_array_by_list",
    "origin_of",
    "points_of",
]

Array = NDArray[np.float64]

_ROWS = 100_000  # points that are converted at a time; a large cloud is in memory often enough

_HEADER = (
    b'<Content>\n<Points file="Points" mtrx="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 "/>\n</Content>\n'
)


def points_of(obj: Any) -> Array:
    """True coordinates of a point object's points, (n, 3) float64 mm.

    Placements, also of parts the object is in, and its ``Origin`` are applied.

    Raises
    ------
    ValueError: the object holds no point kernel.
    """
    return document_points_of(obj) + origin_of(obj)


def document_points_of(obj: Any) -> Array:
    """Points where the document shows them, (n, 3) float64 mm: without the ``Origin``."""
    return _joined(document_blocks_of(obj), _kernel_of(obj).CountPoints)


def document_blocks_of(obj: Any) -> Iterator[Array]:
    """The same points, (k, 3) at a time: a large cloud need not be in memory once more.

    Raises
    ------
    ValueError: the object holds no point kernel.
    """
    kernel = _kernel_of(obj)
    matrix = np.array(global_placement(obj).toMatrix().A, dtype=float).reshape(4, 4)
    stays = np.array_equal(matrix, np.eye(4))
    for block in _kernel_blocks(kernel):
        yield block if stays else block @ matrix[:3, :3].T + matrix[:3, 3]


def _kernel_of(obj: Any) -> Any:
    kernel = getattr(obj, "Points", None)
    if not isinstance(kernel, Points.Points):
        raise ValueError(
            f"{getattr(obj, 'Label', obj)!r} is not a point cloud; choose a Points object."
        )
    return kernel


def global_placement(obj: Any) -> Any:
    """Where an object stands with the parts it is in; Points::FeaturePython cannot tell itself."""
    if hasattr(obj, "getGlobalPlacement"):
        return obj.getGlobalPlacement()
    group = obj.getParentGeoFeatureGroup()
    return obj.Placement if group is None else group.getGlobalPlacement().multiply(obj.Placement)


def origin_of(obj: Any) -> Array:
    """What is to be added to the document's coordinates to get true ones, (3,) mm."""
    return np.array(getattr(obj, "Origin", (0.0, 0.0, 0.0)), dtype=float)


def kernel_from_array(points: ArrayLike, scale: float = 1.0, origin: ArrayLike = 0.0) -> Any:
    """Make a Points kernel of scale · points - origin, (n, 3); its coordinates become float32."""
    rows = np.asarray(points).reshape(-1, 3)
    kernel = Points.Points()
    try:
        _restore(kernel, _archive_of(rows, scale, origin))
        if kernel.CountPoints == len(rows):
            return kernel
    except (RuntimeError, OSError, zipfile.BadZipFile, FreeCAD.Base.FreeCADError):
        pass
    return kernel_from_array_by_list(scale * rows - np.asarray(origin))


def _archive_of(rows: NDArray[Any], scale: float, origin: ArrayLike) -> NDArray[np.uint8]:
    """What a kernel of these points would write, as bytes."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as file:
        file.writestr("Persistence.xml", _HEADER)
        with file.open("Points", "w") as stream:
            stream.write(struct.pack("<I", len(rows)))
            for first in range(0, len(rows), _ROWS):
                block = scale * rows[first : first + _ROWS] - np.asarray(origin)
                stream.write(block.astype("<f4").data)
    return np.frombuffer(archive.getbuffer(), np.uint8).copy()


def _restore(kernel: Any, archive: NDArray[np.uint8]) -> None:
    """Let a kernel read an archive, whose bytes are gone afterwards.

    FreeCAD 0.20 to 1.0 never releases what it reads from (PersistencePy::restoreContent), so that
    each cloud would be in memory once more for ever. Of an array at least the content can go.
    """
    try:
        kernel.restoreContent(archive)
    finally:
        archive.resize(0, refcheck=False)


def kernel_from_array_by_list(points: ArrayLike) -> Any:
    """Make a Points kernel by handing over one point after the other."""
    rows = np.asarray(points, dtype="<f4").reshape(-1, 3)
    kernel = Points.Points()
    if len(rows):
        kernel.addPoints(list(zip(*rows.T.tolist(), strict=True)))
    return kernel


def array_from_kernel(kernel: Any) -> Array:
    """A kernel's own points, (n, 3) float64, placement not applied."""
    return _joined(_kernel_blocks(kernel), kernel.CountPoints)


def _joined(blocks: Iterator[Array], count: int) -> Array:
    points, first = np.empty((count, 3)), 0
    for block in blocks:
        points[first : first + len(block)] = block
        first += len(block)
    return points


def _kernel_blocks(kernel: Any) -> Iterator[Array]:
    stream = _stream_of(kernel)
    if stream is None:
        yield array_from_kernel_by_list(kernel)
        return
    with stream:
        while data := stream.read(12 * _ROWS):
            yield np.frombuffer(data, "<f4").reshape(-1, 3).astype(np.float64)


def _stream_of(kernel: Any) -> IO[bytes] | None:
    """The points in a kernel's archive, float32; None where it is not as expected."""
    try:
        archive = zipfile.ZipFile(io.BytesIO(kernel.dumpContent(Compression=0)))
        member = archive.infolist()[1]
        stream = archive.open(member)
        (count,) = struct.unpack("<I", stream.read(4))
    except (IndexError, RuntimeError, struct.error, zipfile.BadZipFile):
        return None
    as_expected = count == kernel.CountPoints and member.file_size == 4 + 12 * count
    return stream if as_expected else None


def array_from_kernel_by_list(kernel: Any) -> Array:
    """A kernel's own points, asked for one by one, placement taken off again."""
    points = np.array([tuple(point) for point in kernel.Points], dtype=float).reshape(-1, 3)
    matrix = np.array(kernel.Placement.inverse().toMatrix().A, dtype=float).reshape(4, 4)
    moved = points @ matrix[:3, :3].T + matrix[:3, 3]
    return moved.astype(np.float32).astype(np.float64)
