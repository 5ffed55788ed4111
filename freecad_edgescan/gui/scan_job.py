# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel calculates beside the window: one scan, on arrays only.

A scan that is stopped by hand keeps what is there. So that it can be had again, by a recompute or
a macro, the place where it was stopped becomes its gate, and the way to it is scanned once more.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.scan_inputs import ScanInputs
from freecad_edgescan.scanning import Progress, ScanError, ScannedEdge, Stop, scan_edge

from .live_edge import LiveEdge
from .translation import translate

__all__ = ["Found", "ScanJob"]


@dataclass(frozen=True)
class Found:
    """An edge, the inputs that lead to it again, and how it is drawn."""

    inputs: ScanInputs
    edge: ScannedEdge
    drawn: LiveEdge
    stopped: bool = False


@dataclass(frozen=True)
class ScanJob:
    """Scans a cloud with some inputs when it is called."""

    cloud: PointCloud
    inputs: ScanInputs

    def __call__(self, progress: Progress) -> Found:
        """Scan.

        Raises
        ------
        ScanError: there is no edge, or too little of it was found when the scan was stopped.
        """
        edge = _scan(self.cloud, self.inputs, progress)
        if Stop.CANCELLED not in edge.stops:
            return Found(self.inputs, edge, LiveEdge.of_edge(edge))
        kept = _until_stopped(self.inputs, edge)
        try:
            again = _scan(self.cloud, kept, None)
        except ScanError as error:
            sentence = translate("Stopped before there was enough of the edge to keep.")
            raise ScanError(sentence) from error
        return Found(kept, again, LiveEdge.of_edge(again), stopped=True)


def _scan(cloud: PointCloud, inputs: ScanInputs, progress: Progress | None) -> ScannedEdge:
    scan: Callable[..., ScannedEdge] = scan_edge
    choices = {} if inputs.min_angle is None else {"min_angle": inputs.min_angle}
    return scan(
        cloud,
        at=inputs.at,
        gate=inputs.gate,
        parameters=inputs.parameters,
        method=inputs.method,
        progress=progress,
        **choices,
    )


def _until_stopped(inputs: ScanInputs, edge: ScannedEdge) -> ScanInputs:
    """The inputs with a gate where the walk was stopped.

    It was stopped on its way from the click, or, where the other way was walked before, on its way
    from that way's end.
    """
    if not len(edge):
        raise ScanError(translate("Stopped before there was enough of the edge to keep."))
    if edge.stops[1] is Stop.CANCELLED:
        return replace(inputs, gate=edge.points[-1])
    return replace(inputs, at=edge.points[-1], gate=edge.points[0])
