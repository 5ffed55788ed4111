# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is timed of surfaces, on fewer points than the command takes."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.experiments import surface_speed


@pytest.fixture(autouse=True)
def fewer(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, count in (("FITTED", 20_000), ("PROJECTED", 20_000), ("ASKED", 5)):
        monkeypatch.setattr(surface_speed, name, count)


def test_the_surface_that_is_timed_has_its_poles_and_every_task_is_timed() -> None:
    assert surface_speed.wavy_surface().poles.shape == (*surface_speed.POLES, 3)
    asked = []
    speed = surface_speed.measure_surface_speed(
        other=lambda surface: lambda point: asked.append(surface.closest(point[None])[2])
    )
    assert len(asked) == 5 and np.concatenate(asked).max() < 6 * surface_speed.AWAY
    assert min(speed.fit, speed.fitpack, speed.projection, speed.other_projection) > 0.0
    assert speed.fit_with_projection > speed.fit / 2
    assert "FreeCAD's Surface.parameter" in speed.text()
    alone = surface_speed.measure_surface_speed()
    assert "FreeCAD" not in alone.text()


def test_it_stops_when_it_is_told_to() -> None:
    class Told:
        count = 0

        def update(self, fraction: float, so_far: object) -> bool:
            self.count += 1
            return self.count < 3

    assert surface_speed.measure_surface_speed(Told()) is None
