"""Clusters give the results of a single process for 300 photos, even if a worker is killed."""

import os
import signal
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
import rosto

EXAMPLES = str(Path(__file__).parents[3] / "crates/python/examples")
# For this process and for the clusters' processes.
sys.path.insert(0, EXAMPLES)
os.environ["PYTHONPATH"] = EXAMPLES


@pytest.fixture(scope="session")
def expected(album):
    found = rosto.landmarks(album, rosto.Search(mediapipe=True))
    without = [number for number, reason in enumerate(found.reasons) if reason is not None]
    assert len(found) == 300 and without == [100, 200]
    assert len({points.tobytes() for points in found.points}) == 299, "equal results for different photos"
    return found


@contextmanager
def one_killed(processes: Callable[[], list[int]], is_time: Callable[[], bool]) -> Iterator[Future[int]]:
    """Kills the first process once ``is_time()`` is true; yields a future of its PID."""

    def kill() -> int:
        while not is_time():
            time.sleep(0.01)
        first = processes()[0]
        os.kill(first, signal.SIGKILL)
        return first

    with ThreadPoolExecutor(1) as thread:
        yield thread.submit(kill)


def test_dask_gives_the_same_results_when_a_worker_is_killed(album, expected):
    import dask_landmarks
    from distributed import Client, LocalCluster

    paths = [str(path) for path in album]
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        processes = list(client.run(os.getpid).values())
        some_are_done = lambda: sum(map(len, client.has_what().values())) >= 4  # noqa: E731
        with one_killed(lambda: processes, some_are_done) as killed:
            table = dask_landmarks.landmarks(client, paths)
        assert killed.result() not in client.run(os.getpid).values()
    assert table["path"].to_pylist() == paths
    assert table.drop_columns("path").equals(expected.to_arrow())


def test_ray_gives_the_same_results_when_a_worker_is_killed(album, expected):
    import psutil
    import ray
    import ray_landmarks

    def workers() -> list[int]:
        busy = [process for process in psutil.process_iter(["cmdline"]) if process.info["cmdline"]]
        return [process.pid for process in busy if "with_landmarks" in process.info["cmdline"][0]]

    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        with one_killed(workers, lambda: bool(workers())) as killed:
            rows = ray_landmarks.landmarks(str(album[0].parent)).take_all()
        assert not psutil.pid_exists(killed.result())
    finally:
        ray.shutdown()
    rows.sort(key=lambda row: row["path"])
    assert [row["path"] for row in rows] == [str(path) for path in album]
    found = np.array([row["points"] for row in rows], np.float32)
    assert np.array_equal(found, expected.points, equal_nan=True)
    assert [row["reason"] for row in rows] == expected.reasons
