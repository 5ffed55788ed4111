# SPDX-License-Identifier: LGPL-2.1-or-later
"""Puts a scan that was made in the background into the document, in one undo step."""

from __future__ import annotations

from typing import Any

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.scan_inputs import ScanInputs, input_hash, read_inputs
from freecad_edgescan.document.scanned_edge import write_result

from .recorded_step import run_as_one_step
from .scan_job import Found
from .scan_recording import change_lines, make_lines
from .translation import translate

__all__ = ["commit_scan"]


def commit_scan(doc: Any, edited: Any, cloud: Any, numbers: PointCloud, found: Found) -> list[Any]:
    """Make an edge, or change the one that was edited; recorded as macro lines.

    Parameters
    ----------
    doc : App.Document
    edited : scanned edge to change; None: a new one is made
    cloud : Points::Feature that was scanned
    numbers : its points as they were then; while they are the same, nothing is scanned again
    found : the scan

    Returns
    -------
    The edge, alone in a list.

    Raises
    ------
    ValueError: the edge cannot be made; the document is as before.
    """

    def hand_over(made: list[Any]) -> None:
        if document.point_cloud(cloud) is numbers:
            write_result(made[0] if edited is None else edited, found.edge)

    if edited is None:
        return run_as_one_step(
            doc, translate("Scan edge"), make_lines(cloud, found.inputs), hand_over
        )
    if _differs(edited, cloud, found.inputs):
        lines = change_lines(edited, cloud, found.inputs)
        run_as_one_step(doc, translate("Edit scanned edge"), lines, hand_over, changed=[edited])
    return [edited]


def _differs(edge: Any, cloud: Any, inputs: ScanInputs) -> bool:
    """Whether an edge was not made with these inputs, or is not up to date."""
    present = change_lines(edge, cloud, read_inputs(edge))
    return (
        edge.Cloud is not cloud
        or present != change_lines(edge, cloud, inputs)
        or edge.InputHash != input_hash(edge)
    )
