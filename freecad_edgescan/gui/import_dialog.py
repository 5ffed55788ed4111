# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user is asked about cloud files that have been read: their unit, and where they go."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.cloud.point_cloud import require_surface
from freecad_edgescan.cloud.reading import UNITS

from . import preferences
from .form_dialog import FormDialog
from .length_field import length_field, length_in
from .qt import QtWidgets
from .quantities import length_text
from .translation import count_text, translate

__all__ = ["ImportDialog"]

_SMALLEST, _LARGEST = 1.0, 20_000.0  # mm; a scanned part is hardly smaller or larger


class ImportDialog(FormDialog):
    """Shows how large the clouds are in the unit chosen.

    Parameters
    ----------
    clouds : what was read, by file
    """

    def __init__(self, clouds: Mapping[Path, PointCloud]) -> None:
        super().__init__(translate("Import cloud"), "EdgeScan_ImportCloud", "")
        self._clouds = clouds
        self._unit = self.add(translate("&Unit of the file:"), QtWidgets.QComboBox())
        self._unit.addItems([translate("Millimetres"), translate("Metres"), translate("Inches")])
        self._unit.setCurrentIndex(list(UNITS).index(preferences.import_unit()))
        self._unit.setToolTip(translate("Cloud files do not say in which unit their numbers are."))
        self._size = self.add(translate("Size:"), QtWidgets.QLabel())
        self._radius = self.add(
            translate("&Probe radius:"),
            length_field(
                0.0,
                translate(
                    "Radius of the ball, when the file holds the centres of a probing ball; "
                    "0: the points lie on the part."
                ),
            ),
        )
        self._near = QtWidgets.QCheckBox(translate("&Move near the origin"))
        self._near.setChecked(preferences.moves_near_origin())
        far = max(_distance(cloud) for cloud in clouds.values())
        self._far_sentence = QtWidgets.QLabel()
        self._far_sentence.setWordWrap(True)
        if far > 0.0:
            self.fields.addRow(self._near)
            self.fields.addRow(self._far_sentence)
        self._unit.currentIndexChanged.connect(self._show)
        self._show()

    @property
    def unit(self) -> str:
        """Of the files' numbers: mm, m or inch."""
        return list(UNITS)[self._unit.currentIndex()]

    @property
    def probe_radius(self) -> float:
        """Entered radius of the ball, mm."""
        return length_in(self._radius)

    @property
    def near_origin(self) -> bool:
        """Whether clouds that lie far away shall be moved."""
        return bool(self._near.isChecked())

    def _show(self, _: int = 0) -> None:
        """Say how large everything is in the unit chosen."""
        scale = UNITS[self.unit]
        self.sentence.setText(" ".join([self._counted(), *self._doubts()]))
        size = scale * np.max([cloud.size for cloud in self._clouds.values()], axis=0)
        text = " × ".join(length_text(extent) for extent in size)
        if size.max() < _SMALLEST:
            text += "\n" + translate("That is very small. Is the file in metres?")
        elif size.max() > _LARGEST:
            text += "\n" + translate("That is very large. Is the file in millimetres?")
        self._size.setText(text)
        far = scale * max(_distance(cloud) for cloud in self._clouds.values())
        self._far_sentence.setText(
            translate(
                "The points lie {distance} from the origin, where a document cannot keep them "
                "exactly. Moved, they are exact; the cloud's property Origin holds the way back, "
                "and exports use it."
            ).format(distance=length_text(far))
        )

    def _counted(self) -> str:
        """How many points there are, and how many rows hold none."""
        names = ", ".join(path.name for path in self._clouds)
        count = sum(len(cloud) for cloud in self._clouds.values())
        text = translate("{names}: {count} points.").format(names=names, count=count_text(count))
        dropped = sum(cloud.dropped for cloud in self._clouds.values())
        if dropped:
            left_out = translate("Rows with nan or inf that are left out: {count}.")
            text += " " + left_out.format(count=count_text(dropped))
        return text

    def _doubts(self) -> Iterator[str]:
        """Why there can be no edge in a cloud."""
        for cloud in self._clouds.values():
            try:
                require_surface(cloud)
            except ValueError as error:
                yield str(error)


def _distance(cloud: PointCloud) -> float:
    """How far a cloud would be moved, in the unit of its file."""
    return float(np.linalg.norm(cloud.origin_hint))
