# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was scanned and made in a document, as one HTML page that needs nothing else.

Clouds, edges and surfaces with their figures, and pictures of them inside the page. All figures
are those in the objects' properties: nothing is computed again.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from .bridge import document_points_of
from .cloud_cache import point_cloud, probe_radius_of
from .report_pictures import along_picture, cloud_picture, map_picture

__all__ = ["write_report"]

_MOST_PLOTS = 24  # edges with a picture of their own

_STYLE = """
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; margin: 0.7rem 0 1.4rem; width: 100%; }
th, td { text-align: left; padding: 0.25rem 0.7rem 0.25rem 0; border-bottom: 1px solid #8886;
         vertical-align: top; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
img { max-width: 100%; background: white; border-radius: 4px; }
figure { margin: 1rem 0; } figcaption, .note { opacity: 0.75; }
"""


def write_report(doc: Any, path: str | PathLike[str]) -> None:
    """Write a page about the clouds, edges and surfaces of a document.

    Parameters
    ----------
    doc : App.Document
    path : of the .html file

    Raises
    ------
    ValueError: nothing to report, or a file that cannot be written.
    """
    target = Path(path)
    clouds = [item for item in doc.Objects if _is_source(item)]
    edges = [item for item in doc.Objects if _is_edge(item)]
    networks = [item for item in doc.Objects if hasattr(item, "Misclosures")]
    surfaces = [item for item in doc.Objects if hasattr(item, "Average")]
    if not clouds and not edges and not networks and not surfaces:
        raise ValueError(
            f"The document {doc.Label!r} has no cloud, scanned edge or fitted surface to report "
            "on. Import a cloud and scan an edge first."
        )
    parts = [f"<h1>{escape(doc.Label)}</h1>"]
    parts += _clouds(clouds, edges)
    parts += _edges(edges)
    parts += _networks(networks)
    parts += _surfaces(surfaces)
    parts.append('<p class="note">Lengths are mm. Sigma is the standard deviation of an edge '
                 "point across the edge. Made by EdgeScan.</p>")  # fmt: skip
    page = (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width">'
        f"<title>{escape(doc.Label)}</title><style>{_STYLE}</style></head>\n<body>\n"
        + "\n".join(parts)
        + "\n</body></html>\n"
    )
    try:
        target.write_text(page, encoding="utf-8")
    except OSError as error:
        raise ValueError(
            f"{target} cannot be written ({error.strerror}). Check the folder."
        ) from error


def _is_source(item: Any) -> bool:
    """Whether an object is a cloud that is not a map of something else."""
    is_cloud = item.isDerivedFrom("Points::Feature") and item.Points.CountPoints > 0
    return bool(is_cloud) and not hasattr(item, "Deviations")


def _is_edge(item: Any) -> bool:
    return hasattr(item, "Sigma") and hasattr(item, "Stops") and len(item.Points) > 0


def _clouds(clouds: Sequence[Any], edges: Sequence[Any]) -> Iterable[str]:
    if not clouds:
        return
    yield "<h2>Clouds</h2>"
    rows = []
    for item in clouds:
        numbers = point_cloud(item)
        rows.append(
            (
                item.Label,
                Path(getattr(item, "SourceFile", "")).name,
                f"{len(numbers)}",
                " × ".join(f"{extent:.4g}" for extent in numbers.size),
                f"{numbers.pitch:.3g}",
                f"{numbers.noise:.2g}",
                f"{probe_radius_of(item):.5g}",
            )
        )
    yield _table(("Cloud", "File", "Points", "Size", "Pitch", "Noise", "Probe radius"), rows, 2)
    for item in clouds:
        own = [edge for edge in edges if edge.Cloud == item]
        caption = f"{item.Label} with its edges" if own else item.Label
        yield _picture(cloud_picture(point_cloud(item), own), caption)


def _edges(edges: Sequence[Any]) -> Iterable[str]:
    if not edges:
        return
    yield "<h2>Edges</h2>"
    titles = ("Edge", "Ends by", "Points", "Length", "Mean sigma", "Largest", "Angle", "Rounding")
    rows = [
        (
            edge.Label,
            " / ".join(edge.Stops),
            f"{len(edge.Points)}",
            f"{edge.Length.Value:.3f}",
            f"{edge.MeanSigma.Value:.4f}",
            f"{edge.LargestSigma.Value:.4f}",
            f"{edge.MeanAngle.Value:.1f}°" if hasattr(edge, "MeanAngle") else "",
            f"{edge.FilletRadius.Value:.3g}" if getattr(edge, "FilletRadius", 0.0) else "none",
        )
        for edge in edges
    ]
    yield _table(titles, rows, 2)
    for edge in edges[:_MOST_PLOTS]:
        yield f"<h3>{escape(edge.Label)}</h3>"
        if edge.Message:
            yield f"<p>{escape(edge.Message)}</p>"
        yield _picture(along_picture(edge), "along the edge")
    if len(edges) > _MOST_PLOTS:
        yield f'<p class="note">{len(edges) - _MOST_PLOTS} more edges are in the table only.</p>'


def _networks(networks: Sequence[Any]) -> Iterable[str]:
    titles = ("Edge", "Ends in", "Length", "Angle", "Median sigma")
    for network in networks:
        yield f"<h2>{escape(network.Label)}</h2>"
        yield f"<p>{escape(network.Message)}</p>"
        each = zip(network.Shape.Edges, network.Ends, network.Angles, network.Sigmas, strict=True)
        rows = [
            (f"{number}", ends, f"{edge.Length:.3f}", f"{angle:.1f}°", f"{sigma:.4f}")
            for number, (edge, ends, angle, sigma) in enumerate(each, start=1)
        ]
        yield _table(titles, rows, 2)


def _surfaces(surfaces: Sequence[Any]) -> Iterable[str]:
    if not surfaces:
        return
    yield "<h2>Surfaces and profiles</h2>"
    rows = [
        (
            item.Label,
            _fitted_to(item),
            f"{_value(item.Average):.4f}",
            f"{_value(item.Maximum):.4f}",
            f"{_value(item.RootMeanSquare):.4f}" if hasattr(item, "RootMeanSquare") else "",
        )
        for item in surfaces
    ]
    yield _table(("Object", "Compared with", "Average", "Maximum", "Root mean square"), rows, 2)
    for item in surfaces:
        if hasattr(item, "Deviations") and len(document_points_of(item)):
            yield _picture(
                map_picture(item),
                f"{item.Label}: red on the side the surface faces, blue on the other",
            )


def _fitted_to(item: Any) -> str:
    linked = [getattr(item, name, None) for name in ("Cloud", "Surface")]
    return ", ".join(other.Label for other in linked if other is not None)


def _value(length: Any) -> float:
    return float(getattr(length, "Value", np.nan if length is None else length))


def _table(titles: Sequence[str], rows: Iterable[Sequence[str]], words: int) -> str:
    """A table whose first columns are words and all others numbers."""
    kinds = ["" if number < words else ' class="number"' for number in range(len(titles))]
    head = "".join(f"<th{kind}>{title}</th>" for kind, title in zip(kinds, titles, strict=True))
    body = "".join(
        "<tr>"
        + "".join(f"<td{kind}>{escape(text)}</td>" for kind, text in zip(kinds, row, strict=True))
        + "</tr>\n"
        for row in rows
    )
    return f"<table><tr>{head}</tr>\n{body}</table>"


def _picture(source: str, caption: str) -> str:
    if not source:
        return '<p class="note">Pictures need matplotlib, which is not installed.</p>'
    return (
        f'<figure><img src="{source}" alt="{escape(caption)}">'
        f"<figcaption>{escape(caption)}</figcaption></figure>"
    )
