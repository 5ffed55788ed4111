# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a function on many tasks in processes of one BLAS thread each.

NumPy's BLAS reads its number of threads when it is loaded, so that a forked process keeps its
parent's; and a process that multiprocessing spawns runs the caller's script again. Here each
worker is a fresh interpreter with an environment of its own, which reads pickled tasks from its
standard input. One that dies loses its task only, and another takes its place.
"""

from __future__ import annotations

import os
import pickle
import queue
import shutil
import subprocess
import sys
import threading
from collections.abc import Callable, Generator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any, Generic, TypeVar

__all__ = ["Failure", "map_in_processes"]

Task = TypeVar("Task")
Result = TypeVar("Result")

_LOOK_AROUND = 0.3  # s, between two chances of the caller to give up
_ONE_THREAD = dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS"), "1"
)
_SERVE = "from freecad_edgescan.experiments.processes import serve; serve()"


@dataclass(frozen=True)
class Failure:
    """Why a task has no result."""

    text: str


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
            yield number, _call(function, task)
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


def serve() -> None:
    """What a worker does: answer each task that comes in, until there are no more."""
    incoming, outgoing = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what the function prints is no answer
    while True:
        try:
            function, task = pickle.load(incoming)
        except EOFError:
            return
        pickle.dump(_call(function, task), outgoing)
        outgoing.flush()


def _call(function: Callable[[Task], Result], task: Task) -> Result | Failure:
    try:
        return function(task)
    except Exception as error:
        return Failure(f"{type(error).__name__}: {error}")


class _Pool(Generic[Task, Result]):
    """One thread for each worker process; it hands out a task and waits for the answer."""

    def __init__(
        self, function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int
    ) -> None:
        self.function = function
        self.results: queue.Queue[tuple[int, Result | Failure]] = queue.Queue()
        self.waiting = iter(list(enumerate(tasks)))
        self.lock = threading.Lock()
        self.workers: set[_Worker] = set()
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
        worker: _Worker | None = None
        while (item := self._next()) is not None:
            number, task = item
            answer: Result | Failure
            try:
                question = pickle.dumps((self.function, task))
                worker = worker or self._hire()
            except Exception as error:
                answer = Failure(f"{type(error).__name__}: {error}")
            else:
                try:
                    answer = worker.ask(question)
                except Exception as error:
                    answer = Failure(worker.last_words(error))
                    worker = None
            self.results.put((number, answer))
        if worker is not None:
            worker.end()

    def _next(self) -> tuple[int, Task] | None:
        with self.lock:
            return None if self.closed else next(self.waiting, None)

    def _hire(self) -> _Worker:
        with self.lock:
            if self.closed:
                raise RuntimeError("nobody waits for this any more")
            worker = _Worker()
            self.workers.add(worker)
            return worker


class _Worker:
    """A fresh interpreter that answers tasks; Ctrl-C on the terminal does not reach it."""

    def __init__(self) -> None:
        self.said = TemporaryFile()  # noqa: SIM115 (open as long as the worker)
        self.process = subprocess.Popen(
            [_python(), "-P", "-c", _SERVE],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.said,
            env={**os.environ, **_ONE_THREAD, "PYTHONPATH": _search_path()},
            start_new_session=True,
        )

    def ask(self, question: bytes) -> Any:
        """The answer to a pickled function and task.

        Raises
        ------
        EOFError, OSError, pickle.PickleError: the worker died.
        """
        assert self.process.stdin is not None and self.process.stdout is not None
        self.process.stdin.write(question)
        self.process.stdin.flush()
        return pickle.load(self.process.stdout)

    def last_words(self, error: Exception) -> str:
        """Why this worker did not answer; it is ended."""
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(timeout=1.0)
        code = self.process.poll()
        self.end()
        if code is None:
            return f"{type(error).__name__}: {error}"
        self.said.seek(0)
        words = self.said.read().decode(errors="replace").strip().splitlines()
        return f"A worker process ended with code {code}" + (f": {words[-1]}" if words else ".")

    def end(self) -> None:
        """Stop at once."""
        self.process.kill()
        self.process.wait()


def _search_path() -> str:
    """Where modules are found here; an empty entry is the folder this process is in."""
    return os.pathsep.join(entry or os.getcwd() for entry in sys.path)


def _python() -> str:
    """The interpreter, also inside a program that embeds one."""
    if "python" in Path(sys.executable or "").name.lower():
        return sys.executable
    return shutil.which("python3") or str(Path(sys.exec_prefix) / "bin" / "python3")
