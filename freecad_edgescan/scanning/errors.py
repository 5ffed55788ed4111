# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error a user can cause and mend."""

from __future__ import annotations


class ScanError(ValueError):
    """An edge cannot be scanned as asked; the text says why, with which value, and the way out."""
