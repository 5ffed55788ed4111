# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of the screen, told apart by colour-blind people too (Okabe and Ito's palette)."""

from __future__ import annotations

__all__ = ["CLICK", "EDGE"]

Colour = tuple[float, float, float]

EDGE: Colour = (0.84, 0.37, 0.0)
CLICK: Colour = (0.0, 0.45, 0.70)
