# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures show what they say: errors by their sign, sections moved onto the part."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from freecad_edgescan.cloud import CoreBox, PointCloud
from freecad_edgescan.experiments import (
    cloud_picture,
    draw_cloud,
    draw_edges,
    draw_errors,
    draw_section,
)
from freecad_edgescan.experiments.cloud_picture import _VIEWS
from freecad_edgescan.experiments.error_picture import signed_errors
from freecad_edgescan.experiments.honesty import mahalanobis, median_and_95
from freecad_edgescan.experiments.relief import relief
from freecad_edgescan.scanning import Gate, Start, scan_edge, section_outline

BOX = CoreBox.small()


@pytest.fixture(scope="module")
def cloud():
    return BOX.cloud(0.5)


@pytest.fixture(scope="module")
def edges(cloud):
    return scanned(cloud)


def scanned(cloud):
    ways = zip(BOX.starts(10.0), BOX.gates(10.0), strict=True)
    return [scan_edge(cloud, at=Start(*start), gate=Gate(*gate)) for start, gate in ways]


def test_signed_errors_are_no_larger_than_distances(edges) -> None:
    for edge, truth in zip(edges, BOX.edges, strict=True):
        errors = signed_errors(edge, truth)
        assert np.all(np.abs(errors) <= truth.distance(edge.points) + 1e-9)


def test_signed_errors_are_mostly_within_two_sigma() -> None:
    """A rim's errors are alike over a fifth of it, and one rim says little: here are sixteen."""
    within, distances = [], []
    for seed in range(8):
        for edge, truth in zip(scanned(BOX.cloud(0.5, seed=seed)), BOX.edges, strict=True):
            within.append(np.abs(signed_errors(edge, truth)) <= 2 * edge.sigma)
            distances.append(mahalanobis(edge, truth.residuals))
    assert np.mean(np.concatenate(within)) > 0.9
    assert sum(np.mean(rim) < 0.8 for rim in within) <= 2
    middle, most = median_and_95(np.concatenate(distances))
    assert 0.8 < middle < 1.5
    assert most < 3.2


def test_signed_errors_grow_when_the_points_move_out_of_the_wedge(edges) -> None:
    edge, truth = edges[0], BOX.edges[0]
    out = edge.normals.sum(axis=1)
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    moved = replace(edge, points=edge.points + 0.1 * out)
    change = signed_errors(moved, truth) - signed_errors(edge, truth)
    assert np.all((change > 0.0) & (change < 0.1 + 1e-3))


@pytest.mark.parametrize("ending", ["png", "svg"])
def test_pictures_are_written(cloud, edges, tmp_path: Path, ending: str) -> None:
    pytest.importorskip("matplotlib")
    draw_edges(cloud, edges, tmp_path / f"edges.{ending}", view=(0, -1, 1), names=["a", "b"])
    draw_errors(cloud, edges, BOX.edges[:2], tmp_path / f"errors.{ending}")
    draw_section(edges[0], 10, tmp_path / f"section.{ending}")
    draw_section(edges[0], edges[0].points[4], tmp_path / f"there.{ending}")
    assert all(file.stat().st_size > 5000 for file in tmp_path.iterdir())
    assert len(list(tmp_path.iterdir())) == 4


def test_a_view_without_a_direction_is_refused(cloud, edges, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="view"):
        draw_edges(cloud, edges, tmp_path / "edges.png", view=(0, 0, 0))


def test_the_moved_sides_meet_in_the_edge_point(edges) -> None:
    outline = section_outline(edges[0], 20)
    for curve, moved in zip(outline.line.curves, outline.surfaces, strict=True):
        np.testing.assert_allclose(moved[0], outline.line.edge_point)
        assert np.linalg.norm(moved[1] - moved[0]) < np.linalg.norm(curve[-1] - curve[0]) / 10
        gaps = np.linalg.norm(moved[1:, None] - curve, axis=2).min(axis=1)
        np.testing.assert_allclose(gaps, outline.probe_radius, rtol=0.02)


@pytest.mark.parametrize("view", _VIEWS, ids=lambda view: view[-1])
def test_axes_of_a_cloud_seen_from_three_sides_are_the_parts_own(cloud, view) -> None:
    _, direction, right, up, _ = view
    place = np.array([[1.0, 20.0, 300.0]])
    seen = relief(cloud.points, cloud.pitch, direction).project(place)[0]
    assert seen[0] == pytest.approx(place[0, "xyz".index(right)])
    assert seen[1] == pytest.approx(place[0, "xyz".index(up)])


@pytest.mark.parametrize("scale", [(1, 1, 1), (1, 1, 0), (100, 1, 1)], ids=["box", "flat", "long"])
def test_a_cloud_of_any_shape_far_from_the_origin_is_drawn(tmp_path: Path, scale) -> None:
    pytest.importorskip("matplotlib")
    points = np.random.default_rng(2).uniform(0, 10, (2000, 3)) * scale + 1e6
    draw_cloud(PointCloud(points), tmp_path / "cloud.png")
    assert (tmp_path / "cloud.png").stat().st_size > 5000


@pytest.mark.parametrize("size", [(40, 25, 10), (10, 10, 10), (60, 10, 2), (10, 60, 30)])
def test_words_of_a_clouds_picture_stand_clear_of_others(monkeypatch, tmp_path: Path, size) -> None:
    pytest.importorskip("matplotlib")
    drawn = []
    monkeypatch.setattr(cloud_picture, "save_figure", lambda figure, path: drawn.append(figure))
    rng = np.random.default_rng(3)
    points = rng.uniform(0, 1, (12000, 3))
    axis = rng.integers(0, 3, len(points))
    points[np.arange(len(points)), axis] = rng.integers(0, 2, len(points))
    draw_cloud(PointCloud(points * size), tmp_path / "cloud.png")
    drawn[0].savefig(tmp_path / "cloud.png", bbox_inches="tight")
    words = [
        text.get_window_extent().padded(4.0)  # pixels
        for axes in drawn[0].axes
        for text in (axes.title, axes.xaxis.label)
    ]
    for k, one in enumerate(words):
        assert not one.count_overlaps(words[:k])
