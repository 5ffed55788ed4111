# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many sections that were measured at once, as arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .section import Frames, Station
from .stop import Stop

__all__ = ["MeasuredSections"]

_ARRAYS = ("sigma", "noise", "begins", "ends", "cover", "stops", "reach")


@dataclass(frozen=True)
class MeasuredSections:
    """Measured sections, m of them.

    Attributes
    ----------
    frames : (m) sections that stand on the edge points; as predicted where no sides meet
    sigma : (m,) mm, standard deviation of the edge point; nan where no sides meet
    noise : (m,) mm, met on the better side
    begins, ends : (m, 2) mm from the edge, where each side's support begins and ends
    cover : (m,) how much of the two sides' points the fits explain, 0 … 1
    stops : (m,) of Stop, why there is no edge point; None where there is one
    reach : (m,) mm, that they were measured with
    """

    frames: Frames
    sigma: np.ndarray
    noise: np.ndarray
    begins: np.ndarray
    ends: np.ndarray
    cover: np.ndarray
    stops: np.ndarray
    reach: np.ndarray

    @staticmethod
    def unmeasured(frames: Frames, stops: np.ndarray | Stop, reach: float) -> MeasuredSections:
        """Sections at which nothing could be measured, and why: (m,) or one reason for all."""
        count = len(frames)
        unknown, reasons = np.full(count, np.nan), np.empty(count, dtype=object)
        reasons[:] = stops
        nowhere, reaches = np.full((count, 2), np.nan), np.full(count, reach)
        return MeasuredSections(
            frames, unknown, unknown, nowhere, nowhere, np.zeros(count), reasons, reaches
        )

    def __len__(self) -> int:
        return len(self.sigma)

    def __getitem__(self, part: np.ndarray) -> MeasuredSections:
        """Return some of them."""
        return MeasuredSections(self.frames[part], *(getattr(self, name)[part] for name in _ARRAYS))

    @staticmethod
    def join(parts: Sequence[MeasuredSections]) -> MeasuredSections:
        """Put sections behind each other."""
        return MeasuredSections(
            Frames.join([part.frames for part in parts]),
            *(np.concatenate([getattr(part, name) for part in parts]) for name in _ARRAYS),
        )

    def replaced(self, rows: np.ndarray, others: MeasuredSections) -> MeasuredSections:
        """These sections, with others (k) instead of some rows: (k,) indices."""
        arrays = [getattr(self, name).copy() for name in _ARRAYS]
        for name, array in zip(_ARRAYS, arrays, strict=True):
            array[rows] = getattr(others, name)
        return MeasuredSections(self.frames.replaced(rows, others.frames), *arrays)

    @property
    def found(self) -> np.ndarray:
        """Whether there is an edge point, (m,)."""
        return np.array([stop is None for stop in self.stops], dtype=bool)

    @property
    def doubt(self) -> np.ndarray:
        """How badly an edge is known, and how little of its sides it explains, (m,) mm."""
        return self.sigma / np.maximum(self.cover, 1e-3) ** 2

    def station(self, number: int) -> Station:
        """One of them as a station of a walk."""
        begins, ends = self.begins[number].tolist(), self.ends[number].tolist()
        return Station(
            self.frames[number],
            float(self.sigma[number]),
            float(self.noise[number]),
            (begins[0], begins[1]),
            float(self.cover[number]),
            self.stops[number],
            ends=(ends[0], ends[1]),
        )
