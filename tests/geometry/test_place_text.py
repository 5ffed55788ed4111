# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places in sentences."""

from freecad_edgescan.geometry.place_text import place_text


def test_four_digits_and_no_dust():
    assert place_text((12.34567, -2.9e-22, -1234.5)) == "12.35, 0, -1234.5"
    assert place_text((-0.0, 1e-6, 0.5)) == "0, 0.000001, 0.5"


def test_places_of_a_survey_are_told_apart():
    assert place_text((500012.346, 4000000.0, 99.93)) == "500012.35, 4000000, 99.93"
