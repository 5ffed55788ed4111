# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a file can be written: told before any work is done, and never over the scan."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

__all__ = ["PICTURES", "check_not_the_scan", "check_output"]

PICTURES = (".png", ".svg", ".pdf", ".jpg")


def check_output(path: Path, endings: Sequence[str], scan: str | None = None) -> None:
    """Refuse a file that cannot be written, or not in that format, or is the scan."""
    if scan is not None:
        check_not_the_scan(path, scan)
    if path.suffix.lower() not in endings:
        ending = f"one of {' '.join(endings)}" if len(endings) > 1 else endings[0]
        raise ValueError(f"'{path}' has an unknown ending; use {ending}.")
    if path.is_dir():
        raise ValueError(f"{path} is a folder; give the name of a file.")
    if not path.parent.is_dir():
        raise ValueError(f"{path} cannot be written: there is no folder {path.parent}.")


def check_not_the_scan(path: Path, scan: str) -> None:
    """Refuse a path that leads to the scan, by whatever way."""
    if path.exists() and Path(scan).exists() and path.samefile(scan):
        raise ValueError(f"{path} is the scan itself, which is never overwritten; name another.")
