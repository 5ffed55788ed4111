# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a function on many tasks, tell how far it is, and keep what there is when it is cancelled."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TypeVar

from ..scanning import Progress
from .processes import Failure, map_in_processes

__all__ = ["collect"]

Task = TypeVar("Task")
Result = TypeVar("Result")


def collect(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    jobs: int,
    progress: Progress | None,
    describe: Callable[[Mapping[int, Result | Failure]], object],
) -> dict[int, Result | Failure]:
    """Results by the number of their task, as they come; without those missing when cancelled.

    Parameters
    ----------
    function, tasks, jobs : see `map_in_processes`
    progress : told the share of tasks done and what `describe` makes of their results
    """
    found: dict[int, Result | Failure] = {}
    work = map_in_processes(function, tasks, jobs)
    try:
        for news in work:
            if news is not None:
                number, result = news
                found[number] = result
            if progress and not progress.update(len(found) / len(tasks), describe(found)):
                break
    finally:
        work.close()
    return found
