# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tasks in processes: one thread each, and whatever goes wrong is an answer, not a wait."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from pathlib import Path

import pytest

from freecad_edgescan.experiments.processes import Failure, map_in_processes


def answers(function, tasks, jobs: int) -> list:
    found = dict(news for news in map_in_processes(function, tasks, jobs) if news is not None)
    assert len(found) == len(tasks)
    return [found[number] for number in range(len(tasks))]


@pytest.mark.parametrize("jobs", [1, 2])
def test_every_task_gets_its_own_answer(jobs: int) -> None:
    assert answers(math.sqrt, [float(k * k) for k in range(7)], jobs) == list(range(7))


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_task_that_raises_answers_with_the_text(jobs: int) -> None:
    first, second, third = answers(math.sqrt, [4.0, -1.0, 9.0], jobs)
    assert (first, third) == (2.0, 3.0)
    assert isinstance(second, Failure)
    assert "math domain error" in second.text


def test_a_process_that_dies_costs_its_task_and_another_takes_over() -> None:
    ended, alive = answers(eval, ["__import__('os')._exit(3)", "6 * 7"], 2)
    assert isinstance(ended, Failure)
    assert "code 3" in ended.text
    assert alive == 42
    assert all(isinstance(answer, Failure) for answer in answers(os._exit, [0, 1, 2], 2))


def test_what_a_process_cannot_be_told_is_an_answer_too() -> None:
    (answer,) = answers(lambda task: task, [1], jobs=1)
    assert answer == 1
    for answer in answers(lambda task: task, [1, 2], jobs=2):
        assert isinstance(answer, Failure)
        assert "lambda" in answer.text


def test_what_a_function_prints_does_not_disturb_its_answer() -> None:
    assert answers(eval, ["print('noise') or 5", "6"], 2) == [5, 6]


@pytest.mark.skipif(not os.path.isdir("/proc/self/task"), reason="counts threads as Linux does")
def test_each_process_has_one_thread_for_linear_algebra() -> None:
    multiply = "[__import__('numpy').ones((600, 600)) @ __import__('numpy').ones((600, 600))]"
    count = f"len({multiply} and __import__('os').listdir('/proc/self/task'))"
    assert answers(eval, [count, count], 2) == [1, 1]


def test_whoever_stops_iterating_ends_the_processes() -> None:
    work = map_in_processes(eval, ["__import__('os').getpid()", "__import__('time').sleep(60)"], 2)
    news = None
    while news is None:
        news = next(work)
    work.close()
    with pytest.raises(ProcessLookupError):
        os.kill(news[1], 0)


def test_modules_of_the_folder_one_is_in_are_found_there_too() -> None:
    """An interactive Python looks for them in the entry '' of its path."""
    code = (
        "from freecad_edgescan.experiments.processes import map_in_processes;"
        "print([news for news in map_in_processes(abs, [-1, -2], 2) if news])"
    )
    checkout = Path(__file__).resolve().parents[2]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    run = subprocess.run(
        [sys.executable, "-c", code], cwd=checkout, env=environment, capture_output=True, text=True
    )
    assert sorted(eval(run.stdout)) == [(0, 1), (1, 2)]
