"""Generators of images: lazy consumption, buffer reuse, errors and interrupts."""

import signal
import subprocess
import sys

import numpy as np
import pytest
import rosto
from PIL import Image

FAST = rosto.Search(mediapipe=True)


@pytest.mark.parametrize("jobs", [1, 2, 3])
def test_keeps_at_most_two_images_per_job_in_progress(portrait, jobs):
    file, alive, done = portrait.read_bytes(), [], []

    class Counted(bytes):
        """Counts its live instances; bytes are immutable, so the package does not copy them."""

        def __init__(self, _):
            alive.append(len(alive) + 1 - len(done))

        def __del__(self):
            done.append(True)

    found = rosto.landmarks((Counted(file) for _ in range(40)), FAST, jobs=jobs)
    assert len(found) == len(alive) == 40 and found.reasons == [None] * 40
    assert max(alive) <= 2 * jobs + 1


def test_memory_does_not_grow_with_the_number_of_images():
    script = """
import resource, numpy as np, rosto
rosto.landmarks(np.zeros((64, 64, 3), np.uint8), rosto.Search(mediapipe=True))
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
images = (np.full((1500, 1500, 3), number, np.uint8) for number in range(60))  # 6.75 MB each, 405 MB together
assert len(rosto.landmarks(images, rosto.Search(mediapipe=True), jobs=2)) == 60
print((resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1000)
"""
    grown_mb = float(subprocess.check_output([sys.executable, "-c", script]))
    assert grown_mb < 150


@pytest.mark.parametrize("jobs", [1, 4])
def test_a_generator_may_reuse_its_buffer(album, jobs):
    files = [path.read_bytes() for path in album[:12]]
    frames = [np.asarray(Image.open(path)) for path in album[:12]]

    def frames_in_one_array():
        frame = np.empty_like(frames[0])
        for each in frames:
            frame[:] = each
            yield frame
        frame[:] = 0

    def files_in_one_buffer():
        buffer = bytearray(max(map(len, files)))
        for each in files:
            buffer[:] = each.ljust(len(buffer), b"\0")
            yield memoryview(buffer)

    for reused, kept in [(frames_in_one_array(), frames), (files_in_one_buffer(), files)]:
        assert np.array_equal(rosto.landmarks(reused, FAST, jobs=jobs).points, rosto.landmarks(kept, FAST).points)


@pytest.mark.parametrize("jobs", [1, 3])
def test_propagates_an_error_of_the_generator(pixels, jobs):
    taken = []

    def images():
        for number in range(5):
            taken.append(number)
            yield pixels
        raise KeyError("planted")

    with pytest.raises(KeyError, match="planted"):
        rosto.landmarks(images(), FAST, jobs=jobs)
    assert len(taken) == 5
    assert rosto.landmarks([pixels] * 3, FAST, jobs=jobs).reasons == [None] * 3


@pytest.mark.parametrize("jobs", [1, 2])
def test_an_interrupt_stops_a_batch(portrait, jobs):
    script = """
import signal, sys, rosto
# A shell starts background jobs with SIGINT ignored, which Python inherits.
signal.signal(signal.SIGINT, signal.default_int_handler)
photo, jobs = open(sys.argv[1], "rb").read(), int(sys.argv[2])
def photos():
    for number in range(10_000):
        if number == 5:
            print("begun", flush=True)
        yield photo
try:
    rosto.landmarks(photos(), jobs=jobs)
except KeyboardInterrupt:
    print("interrupted")
"""
    words = [sys.executable, "-c", script, str(portrait), str(jobs)]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline() == "begun\n"
            process.send_signal(signal.SIGINT)
            # All 10,000 photos would take an hour.
            assert process.communicate(timeout=60)[0] == "interrupted\n" and process.returncode == 0
        finally:
            process.kill()
