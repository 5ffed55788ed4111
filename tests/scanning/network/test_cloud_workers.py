# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work on a cloud in processes: the same results, whoever does it and whatever becomes of them."""

from __future__ import annotations

import os
import signal

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.scanning.network.cloud_workers import CloudWorkers, jobs_for

from .test_find_edges import box


@pytest.fixture(scope="module")
def cloud() -> es.PointCloud:
    return es.PointCloud(box())


def lowest(cloud: es.PointCloud, axis: int) -> float:
    return float(cloud.points[:, axis].min())


def process(cloud: es.PointCloud, _: int) -> int:
    return os.getpid()


def killed_unless_here(cloud: es.PointCloud, own: int) -> int:
    if os.getpid() != own:
        os.kill(os.getpid(), signal.SIGKILL)
    return own


def raising(cloud: es.PointCloud, _: int) -> None:
    raise ValueError("as it was asked to")


@pytest.mark.parametrize("jobs", [1, 2])
def test_answers_come_in_the_order_of_the_tasks(cloud: es.PointCloud, jobs: int) -> None:
    with CloudWorkers(cloud, jobs) as workers:
        assert list(workers.map(lowest, [0, 1, 2, 0])) == [lowest(cloud, k) for k in (0, 1, 2, 0)]


def test_one_job_is_this_process_and_two_are_others(cloud: es.PointCloud) -> None:
    with CloudWorkers(cloud, 1) as workers:
        assert workers.submit(process, 0)() == os.getpid()
    with CloudWorkers(cloud, 2) as workers:
        assert workers.submit(process, 0)() != os.getpid()


def test_what_processes_cannot_do_is_done_here(cloud: es.PointCloud) -> None:
    with CloudWorkers(cloud, 2) as workers:
        assert list(workers.map(killed_unless_here, [os.getpid()] * 3)) == [os.getpid()] * 3


def test_an_error_of_the_function_is_the_callers(cloud: es.PointCloud) -> None:
    for jobs in (1, 2):
        with (
            CloudWorkers(cloud, jobs) as workers,
            pytest.raises(ValueError, match="as it was asked"),
        ):
            workers.submit(raising, 0)()


def test_no_process_outlives_its_work(cloud: es.PointCloud) -> None:
    with CloudWorkers(cloud, 2) as workers:
        worker = workers.submit(process, 0)()
    with pytest.raises(ProcessLookupError):
        os.kill(worker, 0)


def test_a_network_is_the_same_to_the_last_digit_with_two_processes(cloud: es.PointCloud) -> None:
    one, two = (es.find_edges(cloud, jobs=jobs) for jobs in (1, 2))
    assert len(one) == len(two) == 12
    for alone, beside in zip(one.edges, two.edges, strict=True):
        assert np.array_equal(alone.points, beside.points)
        assert np.array_equal(alone.covariance, beside.covariance)
    assert np.array_equal(one.corners, two.corners)


def test_a_small_cloud_is_worth_no_process(cloud: es.PointCloud) -> None:
    assert jobs_for(cloud) == 1
