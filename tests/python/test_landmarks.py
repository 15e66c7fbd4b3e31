"""Landmarks: equality with the command line, threads, pickle and Parquet."""

import json
import pickle
import threading
from pathlib import Path

import numpy as np
import pyarrow.parquet
import pytest
import rosto

SEARCHES = [
    (rosto.Search(), []),
    (rosto.Search(mediapipe=True), ["--mediapipe"]),
    (rosto.Search(mediapipe=True, refine=True), ["--mediapipe", "--refine"]),
]


@pytest.mark.parametrize(("search", "flags"), SEARCHES)
def test_landmarks_are_bit_identical_to_the_command_line(album, command_line, search, flags):
    some = album[:12]
    found = rosto.landmarks(some, search)
    assert found.points.shape == (12, 478 if search.refined else 468, 3) and found.points.dtype == np.float32
    lines = command_line("landmarks", *some, *flags).splitlines()
    theirs = [json.loads(line)["faces"][0]["landmarks"] for line in lines]
    assert np.array_equal(found.points, np.array(theirs, np.float32))


def test_limits_the_number_of_faces(pixels):
    pair = np.hstack([pixels, pixels])
    assert len(rosto.faces(pair)) == 2
    assert len(rosto.faces(pair, rosto.Search(max_faces=1))) == 1
    assert rosto.faces(np.zeros((64, 64, 3), np.uint8)) == []


def test_threads_do_not_change_results(album):
    some, search = album[:40], rosto.Search(mediapipe=True)
    alone = rosto.landmarks(some, search)
    assert np.array_equal(rosto.landmarks(some, search, jobs=4).points, alone.points)
    assert np.array_equal(rosto.landmarks(iter(some), search).points, alone.points)


def test_a_call_uses_one_thread_and_releases_the_gil(portrait):
    threads = len(list(Path("/proc/self/task").iterdir()))
    steps, done = 0, threading.Event()

    def find():
        rosto.landmarks([portrait])
        done.set()

    rosto.landmarks([portrait])
    assert len(list(Path("/proc/self/task").iterdir())) == threads
    finding = threading.Thread(target=find)
    finding.start()
    while not done.is_set():
        steps += 1
    finding.join()
    # While another thread holds the GIL, this loop would hardly advance.
    assert steps > 10_000


def test_results_survive_pickle_and_parquet(portrait, tmp_path):
    found = rosto.landmarks([portrait, b"plain text"])
    again = pickle.loads(pickle.dumps(found))
    assert np.array_equal(again.points, found.points, equal_nan=True) and again.reasons == found.reasons
    assert pickle.loads(pickle.dumps(rosto.Search(refine=True))) == rosto.Search(refine=True)
    pyarrow.parquet.write_table(found.to_arrow(), tmp_path / "faces.parquet")
    table = pyarrow.parquet.read_table(tmp_path / "faces.parquet")
    points, missing = table["points"].to_pylist()
    assert np.array_equal(np.array(points, np.float32).reshape(-1, 3), found.points[0]) and missing is None
    assert table["reason"].to_pylist() == found.reasons
    assert table["confidence"].to_pylist()[1] is None
