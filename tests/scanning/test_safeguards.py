# SPDX-License-Identifier: LGPL-2.1-or-later
"""Safeguards that cannot work are refused with their value."""

import pytest

from freecad_edgescan.scanning import Safeguards, ScanError, ScanParameters


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"smoothing": float("nan")}, "'smoothing' is nan; give a number from 0 to 0.99"),
        ({"coasting": -2}, "'coasting' is -2; give a number from 0 to 100"),
        ({"largest_turn": 4.0}, "'largest turn' is 4.0"),
        ({"slide": 1}, "'slide' is 1; give True or False"),
    ],
)
def test_impossible_safeguards_are_refused(values, words):
    with pytest.raises(ScanError, match=words):
        Safeguards(**values)


def test_what_are_no_safeguards_is_refused():
    with pytest.raises(ScanError, match="safeguards are 'yes'"):
        ScanParameters(safeguards="yes")
    with pytest.raises(ScanError, match="degree is True"):
        ScanParameters(degree=True)
    with pytest.raises(ScanError, match="amplitude is True"):
        ScanParameters(amplitude=True)
