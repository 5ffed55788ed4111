# SPDX-License-Identifier: LGPL-2.1-or-later
"""The best polynomial of an arc, against the published tables, closed forms and dense points."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry.arc_fit import fit_arc

SHARES = (2.0, 1.0, 0.5, 1.0 / 6.0)  # of π: full, half, quarter and twelfth circle

# Appendix C, table 1; a_y of the half circle with the digit that was lost in print
QUADRATICS = {
    "a_x": ("1.519818", "1.215854", "1.019373", "1.000265"),
    "b_x": ("-1.451319", "-0.774037", "-0.133133", "-0.005406"),
    "c_x": ("0.230985", "0", "-0.33824", "-0.480603"),
    "a_y": ("0.95493", "-0.0504655", "-0.024325", "-0.001161"),
    "b_y": ("-0.303964", "1.312236", "1.195745", "1.026749"),
    "c_y": ("0", "-0.417698", "-0.33824", "-0.128777"),
}
# Appendix D, table 1
LINES = {
    "a_x": ("0", "1.215854", "1.158469", "1.022225"),
    "b_x": ("0", "-0.77404", "-0.66444", "-0.25705"),
    "a_y": ("0.95493", "0.63662", "0.114771", "0.004723"),
    "b_y": ("-0.30396", "0", "0.66444", "0.959322"),
}


def closed_form(s: float, r: float) -> np.ndarray:
    """Coefficients (3, 2) by Schreve eq. C11 to C16."""
    sine, cosine = np.sin(s / r), np.cos(s / r)
    c_x = 30 * r**2 / s**5 * (s**2 * sine - 12 * r**2 * sine + 6 * r * s * cosine + 6 * r * s)
    b_x = (12 * r**3 * cosine + 6 * r**2 * s * sine - c_x * s**4 - 12 * r**3) / s**3
    a_x = (-3 * b_x * s**2 - 2 * s**3 * c_x + 6 * r**2 * sine) / (6 * s)
    c_y = s**2 - s**2 * cosine + 6 * r * s * sine - 12 * r**2 + 12 * r**2 * cosine
    c_y *= 30 * r**2 / s**5
    b_y = (-c_y * s**4 - 6 * r**2 * s - 6 * r**2 * s * cosine + 12 * r**3 * sine) / s**3
    a_y = -(3 * b_y * s**2 + 2 * s**3 * c_y - 6 * r**2 + 6 * r**2 * cosine) / (6 * s)
    return np.array([[a_x, a_y], [b_x, b_y], [c_x, c_y]])


@pytest.mark.parametrize(("degree", "table"), [(2, QUADRATICS), (1, LINES)])
def test_published_coefficients_come_out_to_every_printed_digit(
    degree: int, table: dict[str, tuple[str, ...]]
) -> None:
    powers = fit_arc(degree, np.pi * np.array(SHARES), 1.0).powers()
    for name, printed in table.items():
        computed = powers[:, "abc".index(name[0]), "xy".index(name[2])]
        for value, text in zip(computed, printed, strict=True):
            digits = len(text.partition(".")[2]) or 6
            assert abs(value - float(text)) <= 0.501 * 10.0**-digits, (name, text)


def test_the_closed_form_agrees_where_it_does_not_cancel() -> None:
    for s, r in ((4.0, 5.0), (30.0, 12.0), (1.0, 3.0)):
        assert fit_arc(2, s, r).powers() == pytest.approx(closed_form(s, r), rel=1e-8, abs=1e-9)


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_dense_points_on_the_arc_give_the_same_curve(degree: int) -> None:
    s, r = 7.0, -9.0
    u = (np.arange(20000) + 0.5) / 20000 * s
    arc = np.stack([r * np.cos(u / r) - r, r * np.sin(u / r)], axis=1)
    basis = np.vander(2.0 * u / s - 1.0, degree + 1)
    dense = basis @ np.linalg.lstsq(basis, arc, rcond=None)[0]
    assert fit_arc(degree, s, r).at(u) == pytest.approx(dense, abs=1e-7)


def test_a_short_arc_keeps_its_digits() -> None:
    """To the leading order the largest deviation is s² / (12 r), a quadratic's s³ / (120 r²)."""
    s = 10.0 ** -np.arange(1.0, 4.0)
    deviation = [np.linalg.norm(fit_arc(d, s, 1.0).at(np.zeros(3)), axis=1) for d in (1, 2)]
    assert deviation[0] == pytest.approx(s**2 / 12.0, rel=1e-3)
    assert deviation[1] == pytest.approx(s**3 / 120.0, rel=1e-3)


def test_derivatives_are_those_of_the_curve() -> None:
    fit, h = fit_arc(2, np.array([3.0, 5.0]), 4.0), 1e-4
    u = np.array([0.7, -1.2])
    first = (fit.at(u + h) - fit.at(u - h)) / (2.0 * h)
    second = (fit.at(u + h) - 2.0 * fit.at(u) + fit.at(u - h)) / h**2
    assert fit.at(u, 1) == pytest.approx(first, rel=1e-7)
    assert fit.at(u, 2) == pytest.approx(second, rel=1e-4)
    assert np.all(fit_arc(1, 3.0, 4.0).at(0.5, 2) == 0.0)
