# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel of all edges calculates beside the window: one search, on arrays only."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.network_search import NetworkSearch
from freecad_edgescan.scanning import EdgeNetwork, Progress, ScannedEdge
from freecad_edgescan.scanning.edge_choice import EdgeChoice

from .network_display import line_of
from .picking import Array

__all__ = ["EdgesSoFar", "FindJob", "FoundNetwork"]


@dataclass(frozen=True)
class EdgesSoFar:
    """The edges that are known, and how they are drawn: polylines (k, 3) mm."""

    edges: tuple[ScannedEdge, ...] = ()
    lines: tuple[Array, ...] = ()

    @classmethod
    def of(cls, edges: object) -> EdgesSoFar:
        """Edges as a search reports them: a list that grows."""
        known = tuple(edges) if isinstance(edges, Sequence) else ()
        return cls(known, tuple(line_of(edge) for edge in known))


@dataclass(frozen=True)
class FoundNetwork:
    """A network, the search that finds it again, and how it is drawn."""

    search: NetworkSearch
    network: EdgeNetwork
    drawn: EdgesSoFar
    stopped: bool = False


@dataclass(frozen=True)
class FindJob:
    """Searches a cloud for all edges that a choice may keep when it is called.

    Parameters
    ----------
    most : number of edges after which it ends; 0: it finds all
    """

    cloud: PointCloud
    choice: EdgeChoice
    most: int = 0

    def __call__(self, progress: Progress) -> FoundNetwork:
        """Search.

        Raises
        ------
        ValueError: a cloud in which nothing can be found.
        """
        search = NetworkSearch.wide_enough(self.choice, self.cloud.pitch, self.most)
        network = search(self.cloud, progress)
        stopped = network.cancelled
        if stopped and len(network):
            search, network = search.stopped_at(network)
        return FoundNetwork(search, network, EdgesSoFar.of(network.edges), stopped)
