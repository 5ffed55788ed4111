# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a function on many tasks in processes of one BLAS thread each.

A worker that dies loses its task only, and another takes its place.
"""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Generator, Sequence
from typing import Generic, TypeVar

from ..scanning.worker_process import Failure, WorkerProcess, answer_to

__all__ = ["Failure", "map_in_processes"]

Task = TypeVar("Task")
Result = TypeVar("Result")

_LOOK_AROUND = 0.3  # s, between two chances of the caller to give up


def map_in_processes(
    function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int
) -> Generator[tuple[int, Result | Failure] | None, None, None]:
    """Call a function on every task; answer each result when it is there.

    Parameters
    ----------
    function : of a module that can be imported; with one job any function
    tasks : what it is called on; can be pickled
    jobs : number of processes; with 1 it is called in this process

    Yields
    ------
    Number of the task with its result or the `Failure`, in any order; None several times a second
    while nothing is ready. Whoever stops iterating stops the work: close the generator.
    """
    if jobs == 1:
        for number, task in enumerate(tasks):
            yield number, answer_to(function, task)
        return
    pool = _Pool(function, tasks, min(jobs, len(tasks)))
    try:
        missing = len(tasks)
        while missing:
            try:
                yield pool.results.get(timeout=_LOOK_AROUND)
                missing -= 1
            except queue.Empty:
                yield None
    finally:
        pool.close()


class _Pool(Generic[Task, Result]):
    """One thread for each worker process; it hands out a task and waits for the answer."""

    def __init__(
        self, function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int
    ) -> None:
        self.function = function
        self.results: queue.Queue[tuple[int, Result | Failure]] = queue.Queue()
        self.waiting = iter(list(enumerate(tasks)))
        self.lock = threading.Lock()
        self.workers: set[WorkerProcess] = set()
        self.closed = False
        for _ in range(jobs):
            threading.Thread(target=self._work, daemon=True).start()

    def close(self) -> None:
        """End all workers, also in the middle of a task."""
        with self.lock:
            self.closed = True
            workers = tuple(self.workers)
        for worker in workers:
            worker.end()

    def _work(self) -> None:
        worker: WorkerProcess | None = None
        while (item := self._next()) is not None:
            number, task = item
            answer: Result | Failure
            try:
                worker = worker or self._hire()
            except Exception as error:
                answer = Failure(f"{type(error).__name__}: {error}")
            else:
                try:
                    answer = worker.ask(self.function, task)
                except Exception as error:
                    answer = Failure(worker.last_words(error))
                    worker = None
            self.results.put((number, answer))
        if worker is not None:
            worker.end()

    def _next(self) -> tuple[int, Task] | None:
        with self.lock:
            return None if self.closed else next(self.waiting, None)

    def _hire(self) -> WorkerProcess:
        with self.lock:
            if self.closed:
                raise RuntimeError("nobody waits for this any more")
            worker = WorkerProcess()
            self.workers.add(worker)
            return worker
