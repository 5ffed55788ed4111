# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which properties of a scanned edge a person sees, and may edit, in the property editor."""

from __future__ import annotations

from typing import Any

from .cloud_cache import probe_radius_of
from .scanned_edge_properties import PROBE_ONLY

__all__ = ["show_probe_radius", "show_what_counts"]

# FreeCAD's modes of the property editor; files do not keep them.
_EDITABLE, _READ_ONLY, _HIDDEN = 0, 1, 2


def show_what_counts(obj: Any) -> None:
    """Show the parameters that the edge's method reads, and hide the others."""
    unread = 0 if obj.Method == "probe" else _HIDDEN
    for name in PROBE_ONLY:
        obj.setEditorMode(name, _EDITABLE | unread)
        obj.setEditorMode(f"{name}Used", _READ_ONLY | unread)
    obj.setEditorMode("ProbeRadius", _EDITABLE if obj.OwnProbeRadius else _READ_ONLY)


def show_probe_radius(obj: Any) -> None:
    """Show the cloud's probe radius, read-only, unless the edge has its own."""
    obj.setEditorMode("ProbeRadius", _EDITABLE if obj.OwnProbeRadius else _READ_ONLY)
    if not obj.OwnProbeRadius and obj.ProbeRadius.Value != probe_radius_of(obj.Cloud):
        obj.ProbeRadius = probe_radius_of(obj.Cloud)
