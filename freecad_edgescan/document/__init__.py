# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parametric FreeCAD objects and the bridge between numpy and FreeCAD, without a screen.

Coordinates in a document are true coordinates less the cloud's ``Origin``, which is zero unless
the cloud lies far away. Clicks, starts, gates and shapes are in the document's coordinates;
`points_of` and `export_step` give true ones.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .arc_profile import make_arc_profile as make_arc_profile
    from .bridge import points_of as points_of
    from .casestudy import make_casestudy as make_casestudy
    from .cloud_cache import point_cloud as point_cloud
    from .cloud_object import make_cloud as make_cloud
    from .cloud_section import make_cloud_section as make_cloud_section
    from .cloud_segment import make_cloud_segment as make_cloud_segment
    from .compensated_cloud import make_compensated_cloud as make_compensated_cloud
    from .demo import make_demo as make_demo
    from .deviation_from_shape import shape_deviation as shape_deviation
    from .deviation_from_shape import write_deviations as write_deviations
    from .deviation_map import make_deviation_map as make_deviation_map
    from .deviation_map import save_deviation_map as save_deviation_map
    from .edge_export import export_csv as export_csv
    from .edge_network import change_edge_network as change_edge_network
    from .edge_network import make_edge_network as make_edge_network
    from .edge_network_shape import network_shape as network_shape
    from .edge_network_shape import network_wires as network_wires
    from .edge_wire import make_edge_wire as make_edge_wire
    from .export import export_step as export_step
    from .extended_surface import make_extended_surface as make_extended_surface
    from .fitted_surface import make_fitted_surface as make_fitted_surface
    from .native_edge import edge_shape as edge_shape
    from .report_page import write_report as write_report
    from .scanned_boundary import make_scanned_boundary as make_scanned_boundary
    from .scanned_edge import change_scanned_edge as change_scanned_edge
    from .scanned_edge import make_scanned_edge as make_scanned_edge
    from .scanned_edges import make_scanned_edges as make_scanned_edges
    from .sharp_edges import true_edges as true_edges
    from .simulated_cloud_object import make_core_box as make_core_box
    from .simulated_cloud_object import make_simulated_cloud as make_simulated_cloud
    from .simulated_shape import simulate_cloud as simulate_cloud
    from .surface_intersection import make_surface_intersection as make_surface_intersection
    from .sweeps import make_loft as make_loft
    from .sweeps import make_sweep as make_sweep
    from .swept_surface import make_swept_surface as make_swept_surface
    from .thinned_cloud import make_thinned_cloud as make_thinned_cloud
    from .trimmed_shell import make_trimmed_shell as make_trimmed_shell

_HOME_OF = {
    "change_edge_network": "edge_network",
    "change_scanned_edge": "scanned_edge",
    "edge_shape": "native_edge",
    "export_csv": "edge_export",
    "export_step": "export",
    "make_arc_profile": "arc_profile",
    "make_casestudy": "casestudy",
    "make_cloud": "cloud_object",
    "make_compensated_cloud": "compensated_cloud",
    "make_core_box": "simulated_cloud_object",
    "make_demo": "demo",
    "make_edge_network": "edge_network",
    "make_edge_wire": "edge_wire",
    "make_cloud_segment": "cloud_segment",
    "make_fitted_surface": "fitted_surface",
    "make_extended_surface": "extended_surface",
    "make_surface_intersection": "surface_intersection",
    "make_deviation_map": "deviation_map",
    "save_deviation_map": "deviation_map",
    "shape_deviation": "deviation_from_shape",
    "write_deviations": "deviation_from_shape",
    "make_cloud_section": "cloud_section",
    "make_loft": "sweeps",
    "make_scanned_boundary": "scanned_boundary",
    "make_scanned_edge": "scanned_edge",
    "make_scanned_edges": "scanned_edges",
    "make_simulated_cloud": "simulated_cloud_object",
    "make_sweep": "sweeps",
    "make_swept_surface": "swept_surface",
    "make_thinned_cloud": "thinned_cloud",
    "make_trimmed_shell": "trimmed_shell",
    "network_shape": "edge_network_shape",
    "network_wires": "edge_network_shape",
    "point_cloud": "cloud_cache",
    "points_of": "bridge",
    "simulate_cloud": "simulated_shape",
    "true_edges": "sharp_edges",
    "write_report": "report_page",
}

__all__ = [*_HOME_OF]


def __getattr__(name: str) -> Any:
    """Import the module that defines `name`, and answer the name (PEP 562)."""
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Names of this package's API besides what is loaded already."""
    return sorted({*globals(), *__all__})
