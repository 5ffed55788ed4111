# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a figure: printed as a table, drawn as a picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .figures import new_figure, save_figure

__all__ = ["Curve", "Curves", "draw_curves"]

_WIDTH, _HEIGHT = 7.2, 4.6  # inches, of one figure
_MOST_ROWS = 24  # of a printed table; longer ones are thinned out


@dataclass(frozen=True)
class Curve:
    """One curve.

    Attributes
    ----------
    name : for the legend and the table
    x, y : (n,) in the units of its figure; y is nan where there is no value
    measured : whether each point was measured (drawn with markers) or follows from a formula
    """

    name: str
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    measured: bool = False

    @classmethod
    def of(cls, name: str, x: ArrayLike, y: ArrayLike, measured: bool = False) -> Curve:
        """A curve from any sequences of numbers."""
        return cls(name, np.asarray(x, dtype=float), np.asarray(y, dtype=float), measured)


@dataclass(frozen=True)
class Curves:
    """A figure.

    Attributes
    ----------
    title : what is shown, with its number in the source
    x_label, y_label : with units
    curves : the curves
    notes : sentences below
    logarithmic : whether y grows by factors
    """

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    notes: tuple[str, ...] = ()
    logarithmic: bool = False

    def table(self) -> str:
        """The numbers as text, one row for each x of any curve."""
        places = np.unique(np.concatenate([curve.x for curve in self.curves]))
        step = int(np.ceil(len(places) / _MOST_ROWS))
        widths = [max(11, len(curve.name) + 2) for curve in self.curves]
        cells = [curve.name.rjust(width) for curve, width in zip(self.curves, widths, strict=True)]
        lines = [self.title, f"{self.x_label} | {self.y_label}", " " * 9 + "".join(cells)]
        for x in places[::step]:
            values = [_at(curve, x) for curve in self.curves]
            cells = [value.rjust(width) for value, width in zip(values, widths, strict=True)]
            lines.append(f"{x:9.4g}" + "".join(cells))
        return "\n".join([*lines, *self.notes])


def draw_curves(figures: Sequence[Curves], path: str | Path) -> None:
    """Draw figures below each other.

    Raises
    ------
    ValueError: matplotlib is missing, or does not know the ending.
    """
    drawing = new_figure(path, _WIDTH, _HEIGHT * len(figures))
    for row, curves in enumerate(figures):
        axes = drawing.add_subplot(len(figures), 1, row + 1)
        for number, curve in enumerate(curves.curves):
            style = "o-" if curve.measured else "-"
            axes.plot(
                curve.x, curve.y, style, ms=4, lw=1.2, color=f"C{number % 10}", label=curve.name
            )
        if curves.logarithmic:
            axes.set_yscale("log")
        else:
            axes.set_ylim(0.0, 1.08 * axes.get_ylim()[1])
        axes.set(title=curves.title, xlabel=curves.x_label, ylabel=curves.y_label)
        axes.grid(True, color="0.9")
        axes.legend(frameon=False)
    save_figure(drawing, path)


def _at(curve: Curve, x: float) -> str:
    (found,) = np.nonzero(curve.x == x)
    value = curve.y[found[0]] if len(found) else np.nan
    return "-" if np.isnan(value) else f"{value:.4g}"
