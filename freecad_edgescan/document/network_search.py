# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for all edges of a cloud, which choosing among them does not repeat.

What was found is kept with the cloud's numbers, like their tree, and goes with them: whoever wants
longer, sharper or better known edges, or clicks some away, waits for nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..cloud import PointCloud
from ..scanning import EdgeNetwork, Progress, ScannedEdge, find_edges
from ..scanning.automatic import MIN_ANGLE
from ..scanning.edge_choice import EdgeChoice
from ..scanning.network.find_edges import SHORTEST

__all__ = ["NetworkSearch", "keep_network"]

_MOST_NETWORKS = 2  # of one cloud
_FOUND = "networks found in it"


@dataclass(frozen=True)
class NetworkSearch:
    """What is searched for. The same search in the same cloud finds the same edges.

    Parameters
    ----------
    min_angle : least turn between the two sides of an edge, rad
    min_length : of an edge, mm; None: as `find_edges` takes it
    most : number of edges after which the search ends; 0: it finds all
    """

    min_angle: float = MIN_ANGLE
    min_length: float | None = None
    most: int = 0

    @classmethod
    def wide_enough(cls, choice: EdgeChoice, pitch: float, most: int = 0) -> NetworkSearch:
        """The search that finds all edges which a choice may keep.

        Parameters
        ----------
        pitch : of the cloud, mm
        """
        short = 0.0 < choice.min_length < SHORTEST * pitch
        angle = min(choice.min_angle, MIN_ANGLE) if choice.min_angle > 0.0 else MIN_ANGLE
        return cls(round(angle, 9), choice.min_length if short else None, most)

    def __call__(self, cloud: PointCloud, progress: Progress | None = None) -> EdgeNetwork:
        """Search, unless that was done before; what was found until it is cancelled is handed over.

        Raises
        ------
        ScanError, ValueError: see `find_edges`.
        """
        known: EdgeNetwork | None = vars(cloud).get(_FOUND, {}).get(self)
        if known is not None:
            return known
        until = _Until(self.most, progress)
        network = find_edges(cloud, self.min_angle, self.min_length, until)
        if until.enough and (network.cancelled or len(network) > self.most):
            network = _first(network, self.most)
        if not network.cancelled:
            keep_network(self, network)
        return network

    def stopped_at(self, network: EdgeNetwork) -> tuple[NetworkSearch, EdgeNetwork]:
        """The search that ends where this one was cancelled, and what it finds.

        Parameters
        ----------
        network : what this search has found until it was cancelled
        """
        search = replace(self, most=len(network))
        network = _first(network, len(network))
        keep_network(search, network)
        return search, network


def keep_network(search: NetworkSearch, network: EdgeNetwork) -> None:
    """Let a search find a network at once from now on, in the network's cloud."""
    found = vars(network.cloud).setdefault(_FOUND, {})
    found[search] = network
    while len(found) > _MOST_NETWORKS:
        del found[next(iter(found))]


def _first(network: EdgeNetwork, most: int) -> EdgeNetwork:
    part = network.part(np.arange(len(network)) < most)
    count = f"{most} edge{'s' * (most != 1)}"
    message = f"The search ended after {count}, as it was told; there may be more."
    return replace(part, cancelled=False, message=message)


class _Until:
    """Ends a search when it has found enough."""

    def __init__(self, most: int, progress: Progress | None) -> None:
        self._most, self._progress = most, progress
        self.enough = False

    def update(self, fraction: float, so_far: object) -> bool:
        found: list[ScannedEdge] = so_far if isinstance(so_far, list) else []
        self.enough = self.enough or 0 < self._most <= len(found)
        wanted = self._progress is None or self._progress.update(fraction, so_far)
        return wanted and not self.enough
