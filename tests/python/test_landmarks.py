"""Images to landmarks: the command line's bits; reasons where there are none."""

import pickle
import threading
from pathlib import Path

import numpy as np
import pyarrow.parquet
import pytest
import rosto
from PIL import Image

SEARCHES = [
    (rosto.Search(), []),
    (rosto.Search(mediapipe=True), ["--mediapipe"]),
    (rosto.Search(mediapipe=True, refine=True), ["--mediapipe", "--refine"]),
]


@pytest.mark.parametrize(("search", "flags"), SEARCHES)
def test_landmarks_are_the_command_lines_to_the_bit(album, command_line, search, flags):
    some = album[:12]
    found = rosto.landmarks(some, search)
    assert found.points.shape == (12, 478 if search.refined else 468, 3)
    assert found.points.dtype == np.float32
    assert np.array_equal(found.points, command_line.points(*some, *flags))


def test_what_shows_no_face_or_is_none_has_a_reason_and_stops_no_other(portrait, tmp_path):
    grey = np.full((64, 64, 3), 120, np.uint8)
    found = rosto.landmarks([grey, b"notes", tmp_path / "missing.jpg", portrait, np.zeros((0, 5, 3), np.uint8)])
    assert [reason is None for reason in found.reasons] == [False, False, False, True, False]
    words = ["no face", "not a picture", "missing.jpg", None, "0"]
    assert all(word is None or word in reason for word, reason in zip(words, found.reasons))
    assert np.isnan(found.points[[0, 1, 2, 4]]).all() and np.isfinite(found.points[3]).all()
    assert np.isnan(found.confidence).tolist() == [True, True, True, False, True]


def test_of_many_faces_as_many_as_are_asked_for(portrait):
    with Image.open(portrait) as opened:
        pixels = np.asarray(opened.convert("RGB"))
    pair = np.hstack([pixels, pixels])
    assert len(rosto.faces(pair)) == 2
    assert len(rosto.faces(pair, rosto.Search(max_faces=1))) == 1
    assert rosto.faces(np.zeros((64, 64, 3), np.uint8)) == []


def test_threads_change_nothing_but_time(album):
    some, search = album[:40], rosto.Search(mediapipe=True)
    alone = rosto.landmarks(some, search)
    assert np.array_equal(rosto.landmarks(some, search, jobs=4).points, alone.points)
    assert np.array_equal(rosto.landmarks(iter(some), search).points, alone.points)


def test_a_call_has_one_thread_and_lets_others_run(portrait):
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
    # Python gives another thread its turn every 5 ms at most: with the lock held, this one would hardly have moved.
    assert steps > 10_000


def test_what_is_shown_of_results_is_short(portrait):
    found = rosto.landmarks([portrait] + [b"notes"] * 500)
    assert repr(found) == "Landmarks(501 images, 1 with a face)"
    assert repr(rosto.faces(portrait)) == "[Face(478 points, confidence 0.98)]"


def test_results_and_searches_pickle(portrait):
    found = rosto.landmarks([portrait, b""])
    again = pickle.loads(pickle.dumps(found))
    assert np.array_equal(again.points, found.points, equal_nan=True) and again.reasons == found.reasons
    assert pickle.loads(pickle.dumps(rosto.Search(refine=True))) == rosto.Search(refine=True)


def test_a_table_comes_back_from_parquet_as_it_was(portrait, tmp_path):
    found = rosto.landmarks([portrait, b"notes"])
    pyarrow.parquet.write_table(found.to_arrow(), tmp_path / "faces.parquet")
    table = pyarrow.parquet.read_table(tmp_path / "faces.parquet")
    points, missing = table["points"].to_pylist()
    assert np.array_equal(np.array(points, np.float32).reshape(-1, 3), found.points[0]) and missing is None
    assert table["reason"].to_pylist() == found.reasons
    assert table["confidence"].to_pylist()[1] is None
