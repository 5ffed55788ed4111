# SPDX-License-Identifier: LGPL-2.1-or-later
"""When the lines of a probed scan make an edge known as sharp, and when no more."""

from freecad_edgescan.scanning.sharpness import UNKNOWN


def after(*off, known=UNKNOWN):
    for each in off:
        known = known.after(each)
    return known


def test_six_lines_in_sequence_make_an_edge_known_as_sharp():
    assert not after(*[0.001] * 5).known
    assert after(*[0.001] * 6).known
    assert after(*[0.001] * 50).known


def test_one_line_over_a_rounding_begins_the_sequence_anew():
    assert not after(*[0.001] * 5, 0.05, *[0.001] * 5).known
    assert after(*[0.001] * 5, 0.05, *[0.001] * 6).known
    assert not after(*[0.001] * 6, 0.05).known


def test_a_rounding_that_was_missed_is_not_looked_for_again_so_soon():
    """Wide gaps would miss it again, and every narrow line after them has contacts on it."""
    mistaken = after(*[0.001] * 6, 0.3)
    assert not mistaken.known
    assert not after(*[0.001] * 29, known=mistaken).known
    assert after(*[0.001] * 30, known=mistaken).known
