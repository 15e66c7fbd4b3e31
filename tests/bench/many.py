"""Benchmarks batches of photos, JPEG bytes to landmarks, with Rosto's Python package and MediaPipe's: many.py PORTRAIT

Measures processes and threads, and prints one JSON object per line. Each peer decodes as its documentation shows, and
finds one face in one detector pass (static image mode). Workers process some photos before the measurement.
"""

import io
import json
import multiprocessing
import statistics
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial
from random import Random

from PIL import Image, ImageEnhance

PHOTOS = 300
WARM_UP = 10
ROUNDS = 3
SIDE_PX = 512


def rosto_worker(refined):
    import rosto

    search = rosto.Search(mediapipe=True, refine=refined)
    return lambda photos: rosto.landmarks(photos, search).reasons.count(None)


def mediapipe_worker(refined):
    import cv2
    import mediapipe
    import numpy

    options = {"static_image_mode": True, "max_num_faces": 1, "refine_landmarks": refined}
    mesh = mediapipe.solutions.face_mesh.FaceMesh(**options)

    def found(photo):
        picture = cv2.imdecode(numpy.frombuffer(photo, numpy.uint8), cv2.IMREAD_COLOR)
        faces = mesh.process(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB)).multi_face_landmarks or []
        return [[point.x, point.y, point.z] for face in faces for point in face.landmark]

    return lambda photos: sum(bool(found(photo)) for photo in photos)


def share(make, refined, start, photos):
    """Finds faces after all workers are ready; returns start, end and processor time in s, and the number of faces."""
    work = make(refined)
    work(photos[:WARM_UP])
    start.wait()
    began, processor = time.time(), time.process_time()
    found = work(photos)
    return began, time.time(), time.process_time() - processor, found


def measure(make, refined, photos, workers, in_threads):
    """Wall-clock and processor time per photo, in ms."""
    spawning = multiprocessing.get_context("spawn")
    pool = ThreadPoolExecutor(workers) if in_threads else ProcessPoolExecutor(workers, spawning)
    with spawning.Manager() as manager, pool:
        work = partial(share, make, refined, manager.Barrier(workers))
        began, ended, processor, found = zip(*pool.map(work, [photos[worker::workers] for worker in range(workers)]))
    if sum(found) < 0.95 * len(photos):
        raise SystemExit(f"only {sum(found)} of {len(photos)} faces were found")
    # Each thread reports the time of the whole process.
    processor_s = max(processor) if in_threads else sum(processor)
    return (max(ended) - min(began)) * 1e3 / len(photos), processor_s * 1e3 / len(photos)


def report(what, refined, photos, workers, in_threads_too=False):
    ways = [("", False), (", threads", True)] if in_threads_too else [("", False)]
    peers = [("rosto", rosto_worker), ("mediapipe", mediapipe_worker)]
    runs = [(name + suffix, make, in_threads) for suffix, in_threads in ways for name, make in peers]
    times = {name: [] for name, *_ in runs}
    for _ in range(ROUNDS):
        for name, make, in_threads in runs:
            times[name].append(measure(make, refined, photos, workers, in_threads))
    for kind, of in [("", 0), (", processor time", 1)]:
        for name, measured in times.items():
            ms = statistics.median(each[of] for each in measured)
            record = {"task": "batch", "what": what + kind, "size": f"{SIDE_PX} px JPEG", "peer": name, "value": ms, "unit": "ms"}
            print(json.dumps(record | {"samples": PHOTOS * ROUNDS}), flush=True)


def photos_of(portrait):
    """Yields JPEG files of the portrait with random rotation, crop and brightness."""
    random = Random(0)
    for _ in range(PHOTOS):
        x, y, half = random.uniform(200, 240), random.uniform(150, 190), random.uniform(150, 210)
        turned = Image.open(portrait).convert("RGB").rotate(random.uniform(-20, 20), Image.Resampling.BILINEAR, center=(x, y))
        cut = turned.crop((x - half, y - half, x + half, y + half)).resize((SIDE_PX, SIDE_PX))
        ImageEnhance.Brightness(cut).enhance(random.uniform(0.7, 1.2)).save(file := io.BytesIO(), "JPEG", quality=90)
        yield file.getvalue()


def main():
    photos = list(photos_of(sys.argv[1]))
    report("photo to 468 landmarks, one worker", False, photos, 1)
    report("photo to 478 landmarks, one worker", True, photos, 1)
    report("photo to 468 landmarks, two workers", False, photos, 2, in_threads_too=True)


if __name__ == "__main__":
    main()
