# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small cloud for the command line, and what is read of its answers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from freecad_edgescan.__main__ import main

PITCH = 0.5  # mm


def roof(noise: float = 0.01) -> np.ndarray:
    """Two planes that meet at a right angle in the x axis, 40 mm long, 8 mm to each side."""
    along, away = np.meshgrid(np.arange(-20, 20, PITCH), np.arange(PITCH / 2, 8, PITCH))
    sides = []
    for direction in ((0, 1, -1), (0, -1, -1)):
        unit = np.array(direction) / np.sqrt(2)
        sides.append(np.outer(along.ravel(), (1, 0, 0)) + np.outer(away.ravel(), unit))
    points = np.vstack(sides)
    return points + np.random.default_rng(5).normal(0, noise, points.shape)


def edge_points(table: Path) -> np.ndarray:
    """Points (m, 3) of a table of edge points."""
    lines = table.read_text().splitlines()
    rows = [line.split(",") for line in lines if line.startswith(tuple("-0123456789"))]
    return np.array([[float(word) for word in row[:3]] for row in rows])


def complaint(capsys: pytest.CaptureFixture[str], *words: str | Path) -> str:
    """The one sentence a failing command says."""
    code: object
    try:
        code = main([str(word) for word in words])
    except SystemExit as stopped:
        code = stopped.code
    said = capsys.readouterr()
    assert code == 2
    assert "Traceback" not in said.err
    assert len(said.err.strip().splitlines()) == 1, said.err
    return said.err
