# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inverses of many matrices at once against LAPACK's of one after the other."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.scanning.positive_definite import inverses
from freecad_edgescan.scanning.rounded_rows import solved


def positive_definite(
    shape: tuple[int, ...], size: int, condition: float, rng: np.random.Generator
) -> np.ndarray:
    """Matrices (…, size, size) with eigenvalues from 1 down to 1 / condition."""
    axes = np.linalg.qr(rng.normal(size=(*shape, size, size)))[0]
    values = np.geomspace(1.0, 1.0 / condition, size)
    whole = (axes * values) @ np.swapaxes(axes, -1, -2)
    return 0.5 * (whole + np.swapaxes(whole, -1, -2))


@pytest.mark.parametrize("size", [2, 3, 6, 9])
@pytest.mark.parametrize("condition", [10.0, 1e4, 1e8, 1e12])
def test_inverses_are_those_of_lapack(size: int, condition: float) -> None:
    """As nearly as either is known: rounding errors grow with the condition."""
    matrices = positive_definite((50,), size, condition, np.random.default_rng(size))
    given = matrices.copy()
    seen, wanted = inverses(matrices), np.linalg.inv(matrices)
    largest = np.abs(wanted).max(axis=(1, 2), keepdims=True)
    assert np.max(np.abs(seen - wanted) / largest) < 1e-14 * condition**0.9 + 1e-14 * condition
    assert np.array_equal(matrices, given)


def test_matrices_of_very_different_scales_are_inverted_as_well() -> None:
    """Slopes known to a millionth beside a radius that is hardly known."""
    rng = np.random.default_rng(4)
    scale = 10.0 ** rng.uniform(-6.0, 6.0, (30, 9))
    scale = scale[:, :, None] * scale[:, None]
    matrices = positive_definite((30,), 9, 100.0, rng)
    assert inverses(scale * matrices) * scale == pytest.approx(np.linalg.inv(matrices), abs=1e-10)


def test_any_batch_is_taken() -> None:
    matrices = positive_definite((4, 5), 3, 10.0, np.random.default_rng(1))
    assert inverses(matrices) == pytest.approx(np.linalg.inv(matrices))
    assert inverses(matrices[0, 0]) == pytest.approx(np.linalg.inv(matrices[0, 0]))
    assert inverses(matrices[:0]).shape == (0, 5, 3, 3)


def test_sections_are_solved_without_lapack(monkeypatch: pytest.MonkeyPatch) -> None:
    """Which wakes threads for each section, hundreds of times a scan."""

    def woken(*_: object) -> np.ndarray:
        raise AssertionError("LAPACK was asked")

    monkeypatch.setattr(np.linalg, "inv", woken)
    monkeypatch.setattr(np.linalg, "solve", woken)
    summed = positive_definite((7,), 12, 10.0, np.random.default_rng(2))
    unknown, covariance = solved(summed, np.zeros((7, 9)), np.zeros((7, 9, 9)))
    assert unknown.shape == (7, 9) and covariance.shape == (7, 9, 9)
