# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ``edgescan scan`` prints: a table of edges."""

from __future__ import annotations

import numpy as np

from freecad_edgescan.scanning import ScannedEdge

__all__ = ["edge_table", "sigma_text"]


def edge_table(edges: dict[int, ScannedEdge]) -> str:
    """One row for each edge by its number, with what the scan has to say about it."""
    lines = [
        "edge  points     length  stops at start / end       sigma   angle   fillet",
        "                     mm                             mean mm   deg  radius mm",
    ]
    for number, edge in edges.items():
        path = np.vstack([edge.points, edge.points[:1]]) if edge.closed else edge.points
        length = float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
        stops = " / ".join(stop.name for stop in edge.stops)
        radii = edge.fillet_radius[np.isfinite(edge.fillet_radius)]
        radius = f"{np.median(radii):9.3f}" if len(radii) else "        -"
        sigma, angle = np.mean(edge.sigma), np.degrees(np.mean(edge.angle))
        lines.append(
            f"{number:4d}  {len(edge.points):6d}  {length:9.3f}  {stops:<24}"
            f"  {sigma_text(sigma):>7}  {angle:6.1f}  {radius}"
        )
        if edge.message:
            lines.append(f"      {edge.message}")
    return "\n".join(lines)


def sigma_text(sigma: float) -> str:
    """A standard deviation, mm: four decimals, or two digits where these would say less."""
    return f"{sigma:.4f}" if sigma >= 0.00095 else f"{sigma:.2g}"
