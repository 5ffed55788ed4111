# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan scan --inside``: all edges round a face, from one click."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from freecad_edgescan import scan_command
from freecad_edgescan.__main__ import main

PITCH = 0.5  # mm
CLICK = ["--at", "0,0,0", "--inside", "0,4,-4"]


def house() -> np.ndarray:
    """A roof with its ridge on the x axis, 40 mm long, 8 mm to each side, closed by two gables."""
    along, away = np.meshgrid(np.arange(-20, 20, PITCH), np.arange(PITCH / 2, 8, PITCH))
    slopes = [
        np.outer(along.ravel(), (1, 0, 0)) + np.outer(away.ravel(), (0, way, -1)) / np.sqrt(2)
        for way in (1, -1)
    ]
    y, down = np.meshgrid(np.arange(-5.5, 5.6, PITCH), np.arange(0.0, 5.7, PITCH))
    below = down.ravel() > np.abs(y.ravel())
    gable = np.column_stack([np.zeros(below.sum()), y.ravel()[below], -down.ravel()[below]])
    ends = [gable + np.array([x, 0.0, 0.0]) for x in (-20.0, 19.5)]
    points = np.vstack([*slopes, *ends])
    return points + np.random.default_rng(5).normal(0, 0.01, points.shape)


@pytest.fixture
def scan(tmp_path: Path) -> list[str]:
    np.savetxt(tmp_path / "house.xyz", house())
    return ["scan", str(tmp_path / "house.xyz")]


def edge_points(table: Path) -> np.ndarray:
    """Points (m, 3) of a table of edge points."""
    return np.loadtxt(table, delimiter=",", skiprows=1)[:, :3]


def test_the_ridge_and_both_verges_have_a_table_each(capsys, tmp_path: Path, scan) -> None:
    """A slope is a rectangle of 40 by 8 mm, open at the eaves."""
    assert main([*scan, *CLICK, "-o", str(tmp_path / "edge.csv")]) == 0
    told = capsys.readouterr().out
    verge, ridge, other = (edge_points(tmp_path / f"edge-{number}.csv") for number in (1, 2, 3))
    assert not (tmp_path / "edge-4.csv").exists()
    assert told.count("Wrote") == 3
    assert np.abs(ridge[:, 1:]).max() < 0.05
    assert np.ptp(ridge[:, 0]) > 37.0
    for edge, x in ((verge, verge[0, 0]), (other, other[0, 0])):
        assert min(abs(x + 20.0), abs(x - 19.5)) < 0.05
        assert np.abs(edge[:, 1] + edge[:, 2]).max() < 0.05


def test_a_place_off_the_cloud_is_told(capsys, scan) -> None:
    assert main([*scan, "--at", "0,0,0", "--inside", "0,400,-4"]) == 2
    said = capsys.readouterr().err
    assert "(0, 400, -4)" in said
    assert "Traceback" not in said


def test_ctrl_c_keeps_the_edges_found_until_then(capsys, monkeypatch, tmp_path: Path, scan) -> None:
    whole = scan_command.scan_boundary

    def interrupted(cloud, at, inside, parameters, progress):
        progress.cancelled = True
        return whole(cloud, at, inside, parameters)[:2]

    monkeypatch.setattr(scan_command, "scan_boundary", interrupted)
    assert main([*scan, *CLICK, "-o", str(tmp_path / "edge.csv")]) == 130
    assert (tmp_path / "edge-2.csv").exists()
    assert not (tmp_path / "edge-3.csv").exists()
