# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths in sentences."""

from __future__ import annotations

import math

import pytest

from freecad_edgescan.geometry.plain_number import plain


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (39567.4, 4, "39567"),
        (4.03e9, 3, "4030000000"),
        (0.03126, 3, "0.0313"),
        (1.6e-5, 2, "0.000016"),
        (-12.0, 4, "-12"),
        (0.0, 3, "0"),
        (-1e-12, 3, "0"),
        (99.96, 3, "100"),
        (math.inf, 3, "inf"),
    ],
)
def test_digits_that_matter_and_no_powers(value: float, digits: int, text: str) -> None:
    assert plain(value, digits) == text


def test_decimals_that_are_kept_however_large_the_number_is() -> None:
    assert plain(4000031.4567, 6, 2) == "4000031.46"
    assert plain(4000000.0, 6, 2) == "4000000"
