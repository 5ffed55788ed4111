# SPDX-License-Identifier: LGPL-2.1-or-later
"""The relief of a cloud: what lies before what."""

from __future__ import annotations

import numpy as np

from freecad_edgescan.experiments.relief import relief

SHEET = np.array([(x, y, 0.0) for x in np.arange(0, 20, 0.5) for y in np.arange(0, 10, 0.5)])


def test_a_sheet_seen_from_above_fills_its_extent_at_its_height() -> None:
    seen = relief(SHEET, pitch=0.5, direction=(0, 0, 1))
    filled = ~np.isnan(seen.depth)
    assert np.all(seen.depth[filled] == 0)
    two_pixels_all_round = 2 * seen.cell * 2 * (20 + 10)
    assert abs(filled.sum() * seen.cell**2 - 20 * 10) <= two_pixels_all_round


def test_sparse_points_hide_what_is_behind_them() -> None:
    sparse = SHEET[(SHEET[:, 0] % 2 == 0) & (SHEET[:, 1] % 2 == 0)]
    seen = relief(sparse, pitch=0.5, direction=(0, 0, 1))
    assert not seen.visible(SHEET[(SHEET[:, 0] < 18) & (SHEET[:, 1] < 8)] - (0, 0, 5)).any()


def test_points_behind_the_sheet_are_hidden_and_points_before_it_are_not() -> None:
    seen = relief(SHEET, pitch=0.5, direction=(0, 0, 1))
    assert list(seen.visible([(10, 5, -5), (10, 5, 5), (10, 5, 0)])) == [False, True, True]


def test_a_sheet_is_evenly_bright() -> None:
    shading = relief(SHEET, pitch=0.5, direction=(0, 0, 1)).shading()
    assert np.nanmax(shading) - np.nanmin(shading) < 1e-9
