# SPDX-License-Identifier: LGPL-2.1-or-later
"""The least turn between the two sides that makes an edge: what can be given, in one sentence."""

from __future__ import annotations

import math

from .errors import ScanError

__all__ = ["check_least_angle"]


def check_least_angle(angle: object) -> None:
    """Refuse what is no angle above 0 and below pi, rad.

    Raises
    ------
    ScanError
    """
    number = float(angle) if isinstance(angle, int | float) else math.nan
    if 0.0 < number < math.pi:
        return
    given = f"{number:g} rad ({math.degrees(number):g}°)" if math.isfinite(number) else repr(angle)
    raise ScanError(
        f"The least angle is {given}; give one between 0 and pi in rad, which is 0° to 180°."
    )
