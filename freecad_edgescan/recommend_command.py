# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan recommend``: how to scan the edge near a point, and what will come of it."""

from __future__ import annotations

import argparse

from freecad_edgescan.cloud_file import cloud_of
from freecad_edgescan.cut_by_region import outside_region
from freecad_edgescan.place_in_unit import place_in_unit
from freecad_edgescan.scan_options import given_parameters
from freecad_edgescan.scanning import ScanError, ScanParameters, recommend_parameters
from freecad_edgescan.told_besides import told_besides

__all__ = ["recommend_for_file"]


def recommend_for_file(options: argparse.Namespace) -> int:
    """Measure each edge, print, answer the exit code."""
    if not options.at:
        raise ScanError(
            "There is no place to look at; give --at X,Y,Z, a point near an edge. "
            "edgescan info FILE --picture FILE.png shows where edges are."
        )
    parameters = ScanParameters(**given_parameters(options))
    cloud = cloud_of(options)
    texts = []
    for at in options.at:
        with told_besides(
            outside_region(at, options.region), place_in_unit(at, cloud, options.unit)
        ):
            texts.append(recommend_parameters(cloud, at, parameters, options.method).text())
    print("\n\n".join(texts))
    return 0
