# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be scanned without a scanner, and how."""

from __future__ import annotations

from typing import Any

from .form_dialog import FormDialog
from .length_field import length_field, length_in, set_length
from .qt import QtWidgets
from .recorded_step import object_line
from .selected import selected_shapes
from .translation import translate

__all__ = ["SimulatedCloudDialog"]

_POINTS_ACROSS = 150.0  # pitches along the diagonal of a part, unless the user says otherwise
_NOISE_SHARE = 0.05  # of the pitch
_BOX_PITCH = 0.5  # mm, that of the published case study
_SMALL_BOX, _BOX = "small", "full"


class SimulatedCloudDialog(FormDialog):
    """Asks for the part, pitch, noise and probe radius.

    Parameters
    ----------
    doc : App.Document whose selected objects can be scanned, or None
    """

    def __init__(self, doc: Any) -> None:
        super().__init__(
            translate("Simulated cloud"),
            "EdgeScan_SimulatedCloud",
            translate(
                "A cloud of a part whose edges are known exactly: to try EdgeScan, and to see what "
                "a scan with another pitch or noise would give."
            ),
        )
        parts = [] if doc is None else [item for item in selected_shapes(doc) if _has_faces(item)]
        self._choices: list[Any] = [*parts, _SMALL_BOX, _BOX]
        self._part = self.add(translate("&Part:"), QtWidgets.QComboBox())
        self._part.addItems(
            [
                *(item.Label for item in parts),
                translate("Core box, a small piece"),
                translate("Core box of the case study"),
            ]
        )
        self._pitch = self.add(
            translate("P&itch:"),
            length_field(_BOX_PITCH, translate("One point for each pitch² of surface.")),
        )
        self._noise = self.add(
            translate("&Noise:"),
            length_field(0.0, translate("Standard deviation of the points along the normal.")),
        )
        self._radius = self.add(
            translate("Probe &radius:"),
            length_field(
                0.0,
                translate(
                    "Radius of a ball that rolls over the part; the points are its centres. "
                    "0: the points lie on the part."
                ),
            ),
        )
        self._part.currentIndexChanged.connect(self._show_defaults)
        self._show_defaults()

    def line(self) -> str:
        """The recorded line that makes the cloud."""
        part = self._choices[self._part.currentIndex()]
        pitch = length_in(self._pitch)
        if part in (_SMALL_BOX, _BOX):
            return f"document.make_core_box(doc, {pitch!r}, small={part == _SMALL_BOX})"
        noise, radius = length_in(self._noise), length_in(self._radius)
        return (
            f"document.make_simulated_cloud(doc, {object_line(part)}, {pitch!r}, noise={noise!r}, "
            f"probe_radius={radius!r})"
        )

    def _show_defaults(self, _: int = 0) -> None:
        part = self._choices[self._part.currentIndex()]
        is_box = part in (_SMALL_BOX, _BOX)
        for field in (self._noise, self._radius):
            field.setEnabled(not is_box)
        if is_box:  # scanned by the ball and with the noise that were published
            set_length(self._pitch, _BOX_PITCH)
            set_length(self._noise, 0.05 / 3.0**0.5)
            set_length(self._radius, 1.0055)
            return
        pitch = float(f"{part.Shape.BoundBox.DiagonalLength / _POINTS_ACROSS:.1g}")
        set_length(self._pitch, pitch)
        set_length(self._noise, _NOISE_SHARE * pitch)
        set_length(self._radius, 0.0)


def _has_faces(item: Any) -> bool:
    return not item.Shape.isNull() and bool(item.Shape.Faces)
