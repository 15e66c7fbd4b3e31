"""Writes MediaPipe's results for the detection pictures of docs/accuracy.md to tests/golden/robustness.json.

    cargo run -p rosto-landmarks --example write_robustness_pictures -- target/robustness-pictures
    target/mediapipe/bin/python tests/reference/mediapipe_robustness.py target/robustness-pictures

The folder also contains truth.json: the scale and the landmarks in px of each face of each picture. The result has,
per picture and face found, the index of the true face with the smallest error and that error: the mean distance of the
landmarks inside the picture, in thousandths of the distance between the eyes.
"""

import json
import pathlib
import sys

import numpy
from mediapipe_landmarks import look, write

MAX_FACES = 20
EYE_DISTANCE_PX = 62


def main(pictures: pathlib.Path) -> None:
    answers = {}
    for name, faces in json.loads((pictures / "truth.json").read_text()).items():
        width, height, found = look(pictures / f"{name}.png", MAX_FACES)
        answers[name] = [nearest(landmarks[:, :2], faces, (width, height)) for landmarks in found]
    write("robustness.json", answers)


def nearest(found, faces: list, size_px: tuple) -> list:
    errors = [error(found, face, size_px) for face in faces]
    return [int(numpy.argmin(errors)), round(1000 * min(errors))] if errors else [-1, 0]


def error(found, face: dict, size_px: tuple) -> float:
    truth = numpy.array(face["landmarks_px"])
    inside = (truth >= 0).all(axis=1) & (truth < size_px).all(axis=1)
    distances = numpy.hypot(*(found - truth)[inside].T)
    return float(distances.mean() / (EYE_DISTANCE_PX * face["scale"]))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
