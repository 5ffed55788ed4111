# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about accuracy: what was measured, beside what is wanted, as Markdown with pictures.

Numbers come from results only. The sentences round them stand here, and say how a number is meant,
never how good it is.
"""

from __future__ import annotations

import platform
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import FreeCAD
import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from ..experiments.accuracy_pictures import draw_along, draw_calibration, draw_experiments
from ..experiments.doe_result import PATCH, DoeResult
from ..experiments.doe_tables import experiments_table
from ..experiments.edge_report import EdgeReport
from ..experiments.honesty import TRUE_95, TRUE_MEDIAN, median_and_95
from ..experiments.rims_and_bends import (
    ANGLES,
    BEND_NOISE,
    BEND_PITCH,
    EDGE_RADIUS,
    RIM_RADIUS,
    ExactEdge,
    exact_edge_table,
)
from .accuracy_table import EDGE_PITCH, NOISE, PITCH, SimpleAccuracy, simple_table
from .accuracy_wanted import (
    RATIOS,
    of_exact_edges,
    of_experiments,
    of_part,
    of_simple_parts,
    unreached,
    wanted_table,
)
from .part_report import PartReport

__all__ = ["Accuracy", "picture_paths", "write_page"]

Array = NDArray[np.float64]

_PICTURES = ("along", "calibration", "experiments")

_TOP = f"""# Accuracy

    {{call}}

writes this page, with Python {{python}}, NumPy {{numpy}}, SciPy {{scipy}} and FreeCAD {{freecad}}.
All clouds are simulated, so that the true edges are known exactly; random numbers are seeded. Each
table stands below the command that prints it.

- An *error* is the distance of an edge point from the true edge.
- *One section* is the edge point of a section by itself, before points are smoothed along the edge.
- *In stated sigma* an error is counted in the standard deviations that the scan states for it
  across the edge (Mahalanobis distance). Where these are true, half of the points are within
  {TRUE_MEDIAN:.2f} and 95 % within {TRUE_95:.2f}; less means that they are stated too large, more
  that they are stated too small. Short edges state more than each of their points scatters by, up
  to 1.7 times, because they err as a whole: one in ten thousand shall have an rms beyond 2.5.

{{unreached}}
"""

_SIMPLE = f"""
## Two planes, a fillet, a rim

Pitch {PITCH:g} mm, noise {NOISE:g} mm (standard deviation along the normal), edge points
{EDGE_PITCH:g} mm apart. Outliers are 5 % more points, anywhere within 20 pitches of the surface.

{{wanted}}

    {{call}}

```
{{table}}
```
{{peers}}
![Signed errors along the edges, on twice the stated sigma]({{along}})

Signed errors along the edge of the first cloud of each part, and along that edge of the CAD parts
below which has the largest rms error. Smoothed neighbours share points, and are off together.
"""

_PEERS = """
The last two columns are what others make of the same clouds, with help that a user would have to
give by hand (only the points nearer to this edge than to others, and the labels beside it): the
line of two planes by RANSAC (pyransac3d), fitted again to all their points, and the points of
largest surface variation (jakteristics). Two whole planes beat any edge point where both sides are
planes, and have nothing to say elsewhere; labels are points of the cloud, and stay on a rounding.
"""

_EXACT = f"""
## Rims of a core box, and bends

The core box of the published case study, touched by a ball of 2.011 mm diameter, noise ±0.05 mm,
with gaps of 4 mm in its steep walls and a land of 3 mm between two rims; and the same with its rims
rounded by {RIM_RADIUS:g} mm. Each rim is scanned in one pass from one click, everything automatic.
The bends turn on a radius of {EDGE_RADIUS:g} mm, three amplitudes, at angles of {ANGLES[0]:.0f}° to
{ANGLES[-1]:.0f}° between sides that are nearly flat or turn by 0.7 rad within half an amplitude;
pitch {BEND_PITCH:g} mm, noise ±{BEND_NOISE:g} mm. *Bias* is the length of the mean error as a
vector, *radius* the median of the rounding's.

{{wanted}}

    {{call}}

```
{{table}}
```
"""

_PARTS = """
## CAD parts

Random points on the whole part; one click at the middle of each sharp edge. *Room* is the smallest
distance to another edge, *sigma* the mean standard deviation that the scan states.
"""

_PART = """
### {name}

{wanted}

    {call}

```
{table}
```
"""

_EXPERIMENTS = """
## The published experiments

The 192 objects of K. Schreve's 12 experiments, scanned with all points near the edge. The published
error is that of the better completed quadratic scan of the same object. The smallest possible error
is that of edge points by themselves; smoothed ones, and those that share points or curvature with
their neighbours, may be below.

{wanted}

    {call}

```
{table}
```

![Errors over the published ones by experiment]({experiments})
"""

_HONESTY = """
## Is the stated sigma true?

{table}

![Distances in stated sigma beside what they are when it is true]({calibration})

The edge points of all edges found and all scans completed above. Upper row: how many of them are
nearer than so many stated sigma; lower row: how many are farther, on a scale that reaches to the
last one, which a bar marks. The dotted curve is Rayleigh's, 1 − exp(−d²/2); grey lines mark where
half and 95 % of the points should be. Where the lower curves run to the right of the dotted one,
points are farther off than stated.
"""


@dataclass(frozen=True)
class Accuracy:
    """What was measured; each with the command line that prints it.

    Attributes
    ----------
    call : the command line that writes the page
    simple, exact, simple_call : the simple parts, and the rims and bends
    parts : reports and calls
    experiments, experiments_call : the published experiments, scanned with all points
    """

    call: str
    simple: Sequence[SimpleAccuracy]
    exact: Sequence[ExactEdge]
    simple_call: str
    parts: Sequence[tuple[PartReport, str]]
    experiments: DoeResult
    experiments_call: str


def picture_paths(page: Path) -> dict[str, Path]:
    """Where the pictures of a page go: a folder beside it, with the page's name in theirs."""
    return {name: page.parent / "pictures" / f"{page.stem}-{name}.png" for name in _PICTURES}


def write_page(measured: Accuracy, page: Path) -> list[Path]:
    """Draw the pictures, write the page.

    Parameters
    ----------
    measured : everything; a page holds all or is not written
    page : Markdown file

    Returns
    -------
    The files written, the page first.

    Raises
    ------
    ValueError: matplotlib is missing.
    OSError: a file cannot be written.
    """
    pictures = picture_paths(page)
    pictures["along"].parent.mkdir(exist_ok=True)
    draw_along(_along(measured), pictures["along"])
    draw_calibration(_samples(measured), pictures["calibration"])
    draw_experiments(measured.experiments, PATCH, RATIOS, pictures["experiments"])
    page.write_text(_text(measured, page), encoding="utf-8")
    return [page, *pictures.values()]


def _text(measured: Accuracy, page: Path) -> str:
    shown = {name: f"pictures/{path.name}" for name, path in picture_paths(page).items()}
    simple = of_simple_parts(measured.simple)
    exact = of_exact_edges(measured.exact)
    parts = [of_part(report) for report, _ in measured.parts]
    experiments = of_experiments(measured.experiments)
    named = [
        *simple,
        *exact,
        *(
            replace(each, what=f"{report.part.name}: {each.what}")
            for (report, _), wanted in zip(measured.parts, parts, strict=True)
            for each in wanted
        ),
        *experiments,
    ]
    sections = [
        _TOP.format(call=measured.call, unreached=unreached(named), **_versions()),
        _SIMPLE.format(
            peers=_PEERS if measured.simple[0].peers else "",
            wanted=wanted_table(simple),
            call=measured.simple_call,
            table=simple_table(measured.simple),
            **shown,
        ),
        _EXACT.format(
            wanted=wanted_table(exact),
            call=measured.simple_call,
            table=exact_edge_table(measured.exact),
        ),
        _PARTS,
        *(
            _PART.format(
                name=report.part.name, wanted=wanted_table(wanted), call=call, table=report.text()
            )
            for (report, call), wanted in zip(measured.parts, parts, strict=True)
        ),
        _EXPERIMENTS.format(
            wanted=wanted_table(experiments),
            call=measured.experiments_call,
            table=experiments_table(measured.experiments),
            **shown,
        ),
        _HONESTY.format(table=_honesty_table(_samples(measured)), **shown),
    ]
    return "".join(sections)


def _versions() -> dict[str, str]:
    return {
        "python": platform.python_version(),
        "numpy": np.__version__,
        "scipy": scipy.__version__,
        "freecad": ".".join(FreeCAD.Version()[:2]),
    }


def _along(measured: Accuracy) -> dict[str, EdgeReport]:
    """The first scan of each simple part, and the worst of all scanned edges of the others."""
    drawn = {row.name: row.first for row in measured.simple}
    found = [
        (row, report) for report, _ in measured.parts for row in report.rows if len(row.errors)
    ]
    if found:
        worst, report = max(found, key=lambda pair: pair[0].rms)
        drawn[f"{report.part.name} {worst.truth.name} (worst)"] = worst
    return drawn


def _samples(measured: Accuracy) -> dict[str, tuple[Array, Array]]:
    """Distances in sigma of edge points, and of sections before smoothing, by what they are of."""
    completed = [run for run in measured.experiments if run.completed]
    reports = [report for report, _ in measured.parts]
    return {
        "simple parts": _joined(
            [(row.in_sigmas, row.unsmoothed_in_sigmas) for row in measured.simple]
        ),
        "CAD parts": _joined([(each.in_sigmas, each.unsmoothed_in_sigmas) for each in reports]),
        "experiments": _joined(
            [(run.mahalanobis, run.unsmoothed_mahalanobis) for run in completed]
        ),
    }


def _honesty_table(samples: Mapping[str, tuple[Array, Array]]) -> str:
    lines = [
        "| in stated sigma | edge points: median | 95 % | farthest "
        "| one section: median | 95 % | farthest |",
        "|---|---|---|---|---|---|---|",
        f"| as it is when sigma is true | {TRUE_MEDIAN:.2f} | {TRUE_95:.2f} | "
        f"| {TRUE_MEDIAN:.2f} | {TRUE_95:.2f} | |",
    ]
    for name, sample in samples.items():
        cells = (
            f"{middle:.2f} | {most:.2f} | {values.max(initial=0.0):.2f}"
            for values in sample
            for middle, most in [median_and_95(values)]
        )
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join(lines)


def _joined(pairs: Sequence[tuple[ArrayLike, ArrayLike]]) -> tuple[Array, Array]:
    none = np.zeros(0)
    smoothed, single = zip((none, none), *pairs, strict=True)
    return np.concatenate(smoothed), np.concatenate(single)
