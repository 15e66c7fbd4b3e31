"""How long a photo takes from its JPEG bytes to its landmarks where there are many: Rosto's Python package and MediaPipe's, in
processes and in threads. Prints one JSON object a line; takes the sample portrait.

Each peer decodes as its own documentation does, and is asked for one face in one look (static image mode). Every worker has
seen some photos before the clock starts.
"""

import json
import multiprocessing
import queue
import statistics
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "python"))
import variants

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


def share(make, refined, photos, start, told):
    """Works on its photos when all are ready; tells when it began and ended, and the processor time of its process."""
    work = make(refined)
    work(photos[:WARM_UP])
    start.wait()
    began, processor = time.time(), time.process_time()
    found = work(photos)
    told.put((began, time.time(), time.process_time() - processor, found))


def measure(make, refined, photos, workers, in_threads):
    """Milliseconds a photo: by the clock, and of processors."""
    if in_threads:
        kind, start, told = threading.Thread, threading.Barrier(workers), queue.Queue()
    else:
        spawning = multiprocessing.get_context("spawn")
        kind, start, told = spawning.Process, spawning.Barrier(workers), spawning.Queue()
    shares = [photos[worker::workers] for worker in range(workers)]
    running = [kind(target=share, args=(make, refined, own, start, told)) for own in shares]
    for worker in running:
        worker.start()
    ended = [told.get() for _ in running]
    for worker in running:
        worker.join()
    if sum(found for *_, found in ended) < 0.95 * len(photos):
        raise SystemExit(f"only {sum(found for *_, found in ended)} of {len(photos)} faces were found")
    clock = max(end for _, end, _, _ in ended) - min(began for began, *_ in ended)
    # Threads each tell of their whole process.
    of_each = [processor for _, _, processor, _ in ended]
    processor = max(of_each) if in_threads else sum(of_each)
    return clock * 1e3 / len(photos), processor * 1e3 / len(photos)


def report(what, refined, photos, workers, ways):
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


def main():
    with tempfile.TemporaryDirectory() as folder:
        paths = variants.write(Path(sys.argv[1]), Path(folder), PHOTOS, SIDE_PX)
        photos = [path.read_bytes() for path in paths]
    alone, both = [("", False)], [("", False), (", threads", True)]
    report("photo to 468 landmarks, one worker", False, photos, 1, alone)
    report("photo to 478 landmarks, one worker", True, photos, 1, alone)
    report("photo to 468 landmarks, two workers", False, photos, 2, both)


if __name__ == "__main__":
    main()
