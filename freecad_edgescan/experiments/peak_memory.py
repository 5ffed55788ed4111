# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much memory this process holds, and the most that it has held at a time."""

from __future__ import annotations

import re
import sys
from pathlib import Path

__all__ = ["memory_now", "peak_memory"]

_STATUS = Path("/proc/self/status")


def memory_now() -> int:
    """Resident size, bytes; the largest so far where the system does not tell the present one.

    Raises
    ------
    OSError: a system that tells neither.
    """
    return _status("VmRSS") or peak_memory()


def peak_memory() -> int:
    """Largest resident size so far, bytes.

    Linux tells it for the program that runs; what the system counts for the process (`getrusage`)
    may there be that of the parent which started it.

    Raises
    ------
    OSError: a system that does not tell.
    """
    if told := _status("VmHWM"):
        return told
    try:
        import resource
    except ImportError:
        raise OSError("This system does not tell how much memory a process has held.") from None
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else 1024 * most


def _status(name: str) -> int:
    """A size in the system's account of this process, bytes; 0 where there is none."""
    if not _STATUS.exists():
        return 0
    told = re.search(rf"{name}:\s+(\d+) kB", _STATUS.read_text())
    return 1024 * int(told[1]) if told else 0
