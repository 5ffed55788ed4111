# SPDX-License-Identifier: LGPL-2.1-or-later
"""EdgeScan: true sharp edges from scanned point clouds."""

__version__ = "0.1.0"
