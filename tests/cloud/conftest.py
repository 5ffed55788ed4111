# SPDX-License-Identifier: LGPL-2.1-or-later
"""Generated inputs are the same in every run, and no judgement on them depends on the clock."""

from __future__ import annotations

from hypothesis import HealthCheck, settings

settings.register_profile(
    "repeatable",
    derandomize=True,
    database=None,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("repeatable")
