# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process of one BLAS thread that calls functions on tasks.

NumPy's BLAS reads its number of threads when it is loaded, so that a forked process keeps its
parent's; and a process that multiprocessing spawns runs the caller's script again. Here each
worker is a fresh interpreter with an environment of its own, which reads pickled tasks from its
standard input: that is safe beside other threads, and in programs that embed Python.
"""

from __future__ import annotations

import os
import pickle
import shutil
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any, TypeVar

__all__ = ["Failure", "WorkerProcess", "answer_to", "serve"]

Task = TypeVar("Task")
Result = TypeVar("Result")

_ONE_THREAD = dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS"), "1"
)
_SERVE = "from freecad_edgescan.scanning.worker_process import serve; serve()"


@dataclass(frozen=True)
class Failure:
    """Why a task has no result."""

    text: str


def answer_to(function: Callable[[Task], Result], task: Task) -> Result | Failure:
    """What a function answers to a task; a failure where it raises."""
    try:
        return function(task)
    except Exception as error:
        return Failure(f"{type(error).__name__}: {error}")


def serve() -> None:
    """What a worker does: answer each task that comes in, until there are no more."""
    incoming, outgoing = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what the function prints is no answer
    while True:
        try:
            function, task = pickle.load(incoming)
        except EOFError:
            return
        pickle.dump(answer_to(function, task), outgoing)
        outgoing.flush()


class WorkerProcess:
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
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )

    def ask(self, function: Callable[[Task], Result], task: Task) -> Result | Failure:
        """What a function of a module answers to a task, or why it does not.

        Raises
        ------
        pickle.PickleError, AttributeError, TypeError: these cannot be pickled.
        EOFError, OSError: the worker died.
        """
        self.tell(function, task)
        answer: Result | Failure = self.answer()
        return answer

    def tell(self, function: Callable[[Task], Any], task: Task) -> None:
        """Ask without waiting for the answer."""
        question = pickle.dumps((function, task))
        assert self.process.stdin is not None
        self.process.stdin.write(question)
        self.process.stdin.flush()

    def answer(self) -> Any:
        """Wait for the answer to the first question that has none yet."""
        assert self.process.stdout is not None
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
    """The interpreter, also of a program that embeds one."""
    if "python" in Path(sys.executable or "").name.lower():
        return sys.executable
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    own = [Path(sys.exec_prefix, "bin", version), Path(sys.exec_prefix, "python.exe")]
    for path in own:
        if path.exists():
            return str(path)
    return shutil.which(version) or shutil.which("python3") or "python3"
