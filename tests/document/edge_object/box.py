# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scanned box, and whether an object's last recompute went well."""

from __future__ import annotations

from functools import cache
from typing import Any

import Part

from freecad_edgescan import document
from freecad_edgescan.cloud import SimulatedCloud

NOISE = 0.01


@cache
def box_cloud() -> SimulatedCloud:
    return document.simulate_cloud(Part.makeBox(20, 15, 10), 0.4, NOISE)


def is_valid(obj: Any) -> bool:
    return "Invalid" not in obj.State
