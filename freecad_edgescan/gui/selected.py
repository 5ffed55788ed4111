# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has selected, in the order of selecting; sentences when it is something else."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .translation import translate

__all__ = [
    "chosen_cloud",
    "clouds_of",
    "is_edge_network",
    "is_scanned_edge",
    "only_cloud",
    "selected_objects",
    "selected_shapes",
    "shapes_of",
]


def selected_objects(doc: Any) -> list[Any]:
    """Selected objects of the document, each once."""
    return list(dict.fromkeys(FreeCADGui.Selection.getSelection(doc.Name)))


def selected_shapes(doc: Any) -> list[Any]:
    """Those of them that have a shape."""
    return shapes_of(selected_objects(doc))


def clouds_of(items: list[Any]) -> list[Any]:
    """The point clouds among objects."""
    return [item for item in items if item.isDerivedFrom("Points::Feature")]


def shapes_of(items: list[Any]) -> list[Any]:
    """The objects that have a shape."""
    return [item for item in items if hasattr(item, "Shape")]


def is_scanned_edge(item: Any) -> bool:
    """Whether an object is one of our edges, or a wire of them."""
    kind = type(getattr(item, "Proxy", None)).__name__
    return kind in ("ScannedEdgeProxy", "EdgeWireProxy")


def is_edge_network(item: Any) -> bool:
    """Whether an object is all edges of a cloud."""
    return type(getattr(item, "Proxy", None)).__name__ == "EdgeNetworkProxy"


def chosen_cloud(doc: Any) -> Any:
    """The selected cloud; with nothing selected the only visible one.

    Raises
    ------
    ValueError: the sentence says what to select, or to show.
    """
    chosen = selected_objects(doc)
    clouds = clouds_of(chosen)
    if len(clouds) == 1:
        return clouds[0]
    if clouds:
        raise ValueError(
            translate("{count} clouds are selected. Select one of them.").format(count=len(clouds))
        )
    if chosen:
        raise ValueError(
            translate("{label} is selected, which is no point cloud. Select one cloud.").format(
                label=chosen[0].Label
            )
        )
    return only_cloud(doc)


def only_cloud(doc: Any) -> Any:
    """The only cloud that can be seen.

    Raises
    ------
    ValueError: there is none or more than one; the sentence says what to select, or to show.
    """
    every = clouds_of(doc.Objects)
    shown = [cloud for cloud in every if cloud.ViewObject.Visibility]
    if len(shown) == 1:
        return shown[0]
    if shown:
        raise ValueError(
            translate("This document shows {count} clouds. Select the one you mean.").format(
                count=len(shown)
            )
        )
    if every:
        raise ValueError(
            translate("All clouds of this document are hidden. Select one in the tree, or show it.")
        )
    raise ValueError(
        translate("This document has no point cloud. Import one first (EdgeScan → Import cloud).")
    )
