# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds made of other things: simulated, thinned, compensated, and read in other units."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.cloud import PointCloud  # noqa: E402


@pytest.fixture
def ball(doc: Any) -> Any:
    """A sphere of radius 10."""
    made = doc.addObject("Part::Feature", "Ball")
    made.Shape = Part.makeSphere(10.0)
    return made


def radii(cloud: Any) -> np.ndarray:
    return np.linalg.norm(document.points_of(cloud), axis=1)


def test_a_simulated_cloud_lies_on_its_part_and_follows_its_pitch(doc: Any, ball: Any) -> None:
    cloud = document.make_simulated_cloud(doc, ball, pitch=1.0, noise=0.0)
    doc.recompute()
    count = cloud.PointCount
    assert count == pytest.approx(400 * np.pi, rel=0.1)
    assert radii(cloud) == pytest.approx(10.0, abs=1e-5)
    cloud.Pitch = 2.0
    doc.recompute()
    assert cloud.PointCount == pytest.approx(count / 4, rel=0.1)
    ball.Shape = Part.makeSphere(20.0)
    doc.recompute()
    assert radii(cloud) == pytest.approx(20.0, abs=1e-5)


def test_centres_of_a_ball_are_compensated_onto_the_part(doc: Any, ball: Any) -> None:
    cloud = document.make_simulated_cloud(doc, ball, pitch=0.8, noise=0.0, probe_radius=2.0)
    doc.recompute()
    assert radii(cloud) == pytest.approx(12.0, abs=1e-5)
    numbers = document.make_cloud(doc, document.point_cloud(cloud).points, 2.0, (0, 0, -1))
    upper = document.points_of(numbers)[:, 2] > 3.0
    half = document.make_cloud(doc, document.points_of(numbers)[upper], 2.0, (0, 0, -1))
    part = document.make_compensated_cloud(doc, half)
    doc.recompute()
    assert part.PointCount > 0.5 * np.count_nonzero(upper)
    assert radii(part) == pytest.approx(10.0, abs=0.02)
    assert part.ProbeRadius.Value == 0.0


def test_a_cloud_without_a_probe_is_not_compensated(doc: Any) -> None:
    cloud = document.make_cloud(doc, np.random.default_rng(0).random((50, 3)))
    with pytest.raises(ValueError, match="ProbeRadius"):
        document.make_compensated_cloud(doc, cloud)


def test_a_thinned_cloud_has_the_pitch_asked_for_and_the_probe_of_its_cloud(doc: Any) -> None:
    x, y = np.random.default_rng(0).uniform(0, 20, (2, 40_000))
    cloud = document.make_cloud(doc, np.column_stack([x, y, 0 * x]), 1.5, (0, 0, -1))
    thin = document.make_thinned_cloud(doc, cloud, 0.5)
    doc.recompute()
    assert 20.0 / np.sqrt(thin.PointCount) == pytest.approx(0.5, rel=0.05)
    numbers = document.point_cloud(thin)
    assert numbers.probe_radius == 1.5
    assert numbers.approach == pytest.approx((0, 0, -1))


@pytest.mark.parametrize(("unit", "factor"), [("mm", 1.0), ("m", 1000.0), ("inch", 25.4)])
def test_a_file_in_another_unit_becomes_millimetres(
    doc: Any, tmp_path: Path, unit: str, factor: float
) -> None:
    points = np.random.default_rng(0).random((30, 3)) + 1.0
    np.savetxt(tmp_path / "cloud.xyz", points)
    cloud = document.make_cloud(doc, tmp_path / "cloud.xyz", unit=unit)
    assert document.points_of(cloud) == pytest.approx(factor * points, rel=1e-6)


def test_a_far_cloud_is_moved_near_the_origin_unless_it_shall_stay(doc: Any) -> None:
    points = np.random.default_rng(0).random((30, 3)) + np.array([4e5, 5e6, 0.0])
    moved = document.make_cloud(doc, points)
    assert document.points_of(moved) == pytest.approx(points, abs=1e-6)
    stays = document.make_cloud(doc, points, near_origin=False)
    assert tuple(stays.Origin) == (0.0, 0.0, 0.0)
    assert document.points_of(stays) == pytest.approx(points, abs=0.5)  # float32


def test_the_core_box_is_a_cloud_of_centres(doc: Any) -> None:
    cloud = document.make_core_box(doc, pitch=1.0, small=True)
    assert cloud.ProbeRadius.Value == pytest.approx(1.0055)
    assert tuple(cloud.Approach) == (0.0, 0.0, -1.0)


def test_an_unknown_unit_is_refused_and_nothing_made(doc: Any) -> None:
    with pytest.raises(ValueError, match="foot"):
        document.make_cloud(doc, PointCloud(np.eye(3)), unit="foot")
    assert not doc.Objects
