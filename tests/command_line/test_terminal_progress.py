# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress on a terminal: the first Ctrl-C asks the task to end, the second ends it."""

from __future__ import annotations

import math
import signal
import sys
from types import SimpleNamespace

import pytest

from freecad_edgescan.terminal_progress import TerminalProgress

FOUND = SimpleNamespace(points=[0] * 12)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
    """A clock that stands still until it is set."""
    clock = SimpleNamespace(now=0.0)
    monkeypatch.setattr("freecad_edgescan.terminal_progress.monotonic", lambda: clock.now)
    return clock


def test_the_first_ctrl_c_asks_the_task_to_end_and_the_second_ends_it() -> None:
    with TerminalProgress("task") as progress:
        assert progress.update(0.1, FOUND)
        signal.raise_signal(signal.SIGINT)
        assert not progress.update(0.2, FOUND)
        assert progress.cancelled
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_afterwards_ctrl_c_does_what_it_did_before() -> None:
    before = signal.getsignal(signal.SIGINT)
    with pytest.raises(ValueError, match="of the task"), TerminalProgress("task"):
        assert signal.getsignal(signal.SIGINT) != before
        raise ValueError("of the task")
    assert signal.getsignal(signal.SIGINT) == before


def test_a_log_file_gets_a_line_now_and_then(capsys, clock) -> None:
    with TerminalProgress("edge 1 of 2") as progress:
        for clock.now in range(11):
            progress.update(clock.now / 10, FOUND)
    assert capsys.readouterr().err == (
        "edge 1 of 2: 50 %, 12 edge points\nedge 1 of 2: 100 %, 12 edge points\n"
    )


def test_a_terminal_gets_one_line_that_is_gone_in_the_end(capsys, clock, monkeypatch) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    with TerminalProgress("edge 1 of 2") as progress:
        for clock.now, so_far in ((1.0, FOUND), (1.1, FOUND), (2.0, "ends")):
            progress.update(math.nan, so_far)
    first, second, cleared, rest = capsys.readouterr().err.split("\r")[1:]
    assert first == "edge 1 of 2: 12 edge points"
    assert second == "edge 1 of 2: ends".ljust(len(first))
    assert cleared.strip() == rest == ""
    assert "\n" not in first + second + cleared
