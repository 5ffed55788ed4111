# SPDX-License-Identifier: LGPL-2.1-or-later
"""Puts the edges that were found and chosen into the document, in one undo step."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.computed_object import write_computed
from freecad_edgescan.document.scanned_edge import write_result
from freecad_edgescan.scanning import EdgeNetwork, ScannedEdge
from freecad_edgescan.scanning.automatic import MIN_ANGLE
from freecad_edgescan.scanning.each_edge import scan_each
from freecad_edgescan.scanning.edge_choice import EdgeChoice

from .busy import result_of
from .picking import Array
from .recorded_step import as_literal, object_line, run_as_one_step
from .translation import translate

__all__ = ["change_network", "choice_arguments", "make_group", "make_network"]


def make_network(
    doc: Any, cloud: Any, numbers: PointCloud, choice: EdgeChoice, most: int, kept: EdgeNetwork
) -> list[Any]:
    """Make one object of the edges that are kept; recorded as a macro line.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature that was searched
    numbers : its points as they were then; while they are the same, nothing is searched again
    choice : which edges are wanted
    most : number of edges after which the search ended; 0: it found all
    kept : the network of those that are wanted

    Returns
    -------
    The object, alone in a list.

    Raises
    ------
    ValueError: it cannot be made; the document is as before.
    """

    def hand_over(made: list[Any]) -> None:
        if document.point_cloud(cloud) is numbers:
            write_computed(made[0], kept)

    given = choice_arguments(choice, most)
    line = f"network = document.make_edge_network({', '.join(['doc', object_line(cloud), *given])})"
    return run_as_one_step(doc, translate("Scan all edges"), [line], hand_over)


def change_network(
    edited: Any, numbers: PointCloud, choice: EdgeChoice, most: int, kept: EdgeNetwork
) -> list[Any]:
    """Let a network object keep other edges; recorded as a macro line.

    Raises
    ------
    ValueError: it cannot be changed; the document is as before.
    """
    from freecad_edgescan.document.edge_network import choice_of

    present = choice_arguments(choice_of(edited), int(edited.MostEdges))
    wanted = choice_arguments(choice, most)
    if present == wanted and edited.EdgeCount == len(kept) and edited.InputHash:
        return [edited]

    def hand_over(_: list[Any]) -> None:
        if document.point_cloud(edited.Cloud) is numbers:
            write_computed(edited, kept)

    line = f"document.change_edge_network({', '.join([object_line(edited), *wanted])})"
    title = translate("Edit network of edges")
    run_as_one_step(edited.Document, title, [line], hand_over, changed=[edited])
    return [edited]


def make_group(doc: Any, cloud: Any, numbers: PointCloud, kept: EdgeNetwork) -> list[Any]:
    """Make a scanned edge of each edge that is kept, in a group; recorded as a macro line.

    Each is scanned by itself, so that it can be edited and follows its cloud by itself.

    Returns
    -------
    The group, alone in a list.

    Raises
    ------
    ValueError: they cannot be made; the document is as before.
    CancelledError: the user does not want to wait.
    """
    title = translate("Scan all edges")
    scanned: list[tuple[Array, ScannedEdge]] = result_of(
        lambda progress: scan_each(numbers, kept.edges, progress), title
    )
    if not scanned:
        raise ValueError(translate("None of these edges can be scanned by itself."))

    def hand_over(made: list[Any]) -> None:
        if document.point_cloud(cloud) is numbers:
            edges = [item for item in made if hasattr(item, "Shape")]
            for item, (_, edge) in zip(edges, scanned, strict=True):
                write_result(item, edge)

    places = _literals(np.array([place for place, _ in scanned]))
    line = f"edges = document.make_scanned_edges(doc, {object_line(cloud)}, at={places})"
    made = run_as_one_step(doc, title, [line], hand_over)
    return [item for item in made if not hasattr(item, "Shape")]


def choice_arguments(choice: EdgeChoice, most: int) -> list[str]:
    """What `make_edge_network` is given besides document and cloud; it reads back bit for bit."""
    given = []
    if not np.isclose(choice.min_angle, MIN_ANGLE, rtol=0.0, atol=1e-12):
        given.append(f"min_angle={float(choice.min_angle)!r}")
    if choice.min_length > 0.0:
        given.append(f"min_length={float(choice.min_length)!r}")
    if np.isfinite(choice.max_sigma):
        given.append(f"max_sigma={float(choice.max_sigma)!r}")
    if len(choice.dropped):
        given.append(f"dropped={_literals(choice.dropped)}")
    if len(choice.kept):
        given.append(f"kept={_literals(choice.kept)}")
    if most:
        given.append(f"most_edges={int(most)}")
    return given


def _literals(places: Array) -> str:
    return f"[{', '.join(as_literal(place) for place in places)}]"
