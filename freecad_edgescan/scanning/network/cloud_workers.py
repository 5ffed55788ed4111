# SPDX-License-Identifier: LGPL-2.1-or-later
"""Processes that hold one cloud, and call functions of it.

Small arrays keep Python's interpreter busy, which threads cannot share. What a worker cannot do,
for want of a library or of memory, is done in this process: the results are the same.
"""

from __future__ import annotations

import os
import pickle
import sys
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import lru_cache, partial
from pathlib import Path
from queue import SimpleQueue
from tempfile import TemporaryDirectory
from typing import Any, TypeVar

import numpy as np
import scipy

from ...cloud.point_cloud import PointCloud
from ..worker_process import Failure, WorkerProcess

__all__ = ["CloudWorkers", "cores", "jobs_for"]

Task = TypeVar("Task")
Result = TypeVar("Result")

Key = tuple[str, float, tuple[float, ...] | None, tuple[str, str, str]]

_MOST = 8  # processes: each has an index of the cloud
_WORTH_IT = 100_000  # points, below which processes take longer to start than they save
_VERSIONS = (sys.version, np.__version__, scipy.__version__)


def jobs_for(cloud: PointCloud) -> int:
    """Number of processes that a cloud is worth on this machine."""
    return 1 if len(cloud) < _WORTH_IT else cores()


def cores() -> int:
    """Number of processors to use."""
    try:
        mine = len(os.sched_getaffinity(0))
    except AttributeError:  # only Linux tells
        mine = os.cpu_count() or 1
    return min(mine, _MOST)


class CloudWorkers:
    """Calls functions of a cloud and a task, in processes of their own or in this one.

    Parameters
    ----------
    cloud : PointCloud
    jobs : number of processes; 1: this one
    """

    def __init__(self, cloud: PointCloud, jobs: int) -> None:
        self.cloud = cloud
        self._threads = ThreadPoolExecutor(jobs) if jobs > 1 else None
        self._closed = False
        self._started: list[_CloudWorker] = []
        self._free: SimpleQueue[_CloudWorker | None] = SimpleQueue()
        self._folder: TemporaryDirectory[str] | None = None
        if jobs > 1:
            with suppress(OSError):
                self._start(jobs)
            for number in range(jobs):
                self._free.put(self._started[number] if number < len(self._started) else None)

    def __enter__(self) -> CloudWorkers:
        return self

    def __exit__(self, *_: object) -> None:
        self._closed = True
        if self._threads is not None:
            self._threads.shutdown(wait=False, cancel_futures=True)
        for worker in self._started:
            worker.process.end()
        if self._threads is not None:
            self._threads.shutdown()
        if self._folder is not None:
            self._folder.cleanup()

    def map(
        self, function: Callable[[PointCloud, Task], Result], tasks: Iterable[Task]
    ) -> Iterator[Result]:
        """Results of a module's function for each task, in order."""
        for answer in [self.submit(function, task) for task in tasks]:
            yield answer()

    def submit(
        self, function: Callable[[PointCloud, Task], Result], task: Task
    ) -> Callable[[], Result]:
        """What answers with the result of a module's function for a task, when that is there."""
        if self._threads is None:
            return partial(self._here, function, task)
        return self._threads.submit(self._asked, function, task).result

    def _here(self, function: Callable[[PointCloud, Task], Result], task: Task) -> Result:
        # NumPy sums arrays in another order when they lie otherwise in memory, as they do behind
        # a pipe: all arrays go the same way, so that the last digit does not tell who did it.
        answer: Result = _copied(function(self.cloud, _copied(task)))
        return answer

    def _start(self, jobs: int) -> None:
        """Start the processes; they read the cloud while this one has other work."""
        self._folder = TemporaryDirectory(prefix="edgescan-")
        file = Path(self._folder.name) / "points.npy"
        np.save(file, self.cloud.points)
        approach = self.cloud.approach
        way = None if approach is None else tuple(approach.tolist())
        key = str(file), self.cloud.probe_radius, way, _VERSIONS
        for _ in range(jobs):
            self._started.append(_CloudWorker(key))

    def _asked(self, function: Callable[[PointCloud, Task], Result], task: Task) -> Result:
        worker = self._free.get()
        try:
            if worker is not None:
                answer: Result | Failure = worker.ask(function, task)
                if not isinstance(answer, Failure):
                    return answer
                worker = None
        except Exception:
            worker = None  # whatever became of it, the work is done here
        finally:
            self._free.put(worker)
        if self._closed:
            raise RuntimeError("nobody waits for this any more")
        return self._here(function, task)


class _CloudWorker:
    """A process that has been told to read a cloud."""

    def __init__(self, key: Key) -> None:
        self.key, self.process, self.reads = key, WorkerProcess(), True
        with suppress(OSError):  # it has ended, and will not answer
            self.process.tell(_read, key)

    def ask(self, function: Callable[[PointCloud, Task], Result], task: Task) -> Result | Failure:
        if self.reads:
            self.reads = False
            if isinstance(failed := self.process.answer(), Failure):
                return failed
        self.process.tell(_call, (self.key, function, task))
        answer: Result | Failure = self.process.answer()
        return answer


def _copied(value: Any) -> Any:
    return pickle.loads(pickle.dumps(value))


def _call(task: tuple[Key, Callable[[PointCloud, Task], Result], Task]) -> Result:
    """What a worker does."""
    key, function, own = task
    return function(_cloud(key), own)


def _read(key: Key) -> None:
    """What a worker does first: it reads the cloud, and builds its index."""
    assert _cloud(key).tree is not None


@lru_cache(maxsize=1)
def _cloud(key: Key) -> PointCloud:
    file, probe_radius, approach, versions = key
    if versions != _VERSIONS:
        raise RuntimeError("other versions may find something else")
    return PointCloud(np.load(file), probe_radius, approach)
