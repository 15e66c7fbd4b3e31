"""MediaPipe's answers for the pictures of docs/robustness.md, as tests/golden/robustness.json.

    cargo run -p rosto-landmarks --example write_robustness_pictures -- target/robustness-pictures
    python3 -m venv target/mediapipe
    target/mediapipe/bin/pip install -r tests/reference/mediapipe_requirements.txt
    target/mediapipe/bin/python tests/reference/mediapipe_robustness.py target/robustness-pictures

Beside the pictures, truth.json has for each face of each picture its scale and where its landmarks are, in px. Written
for each picture: for each face that MediaPipe finds, which face that is (by the least error) and the error in
thousandths of the distance between the eyes: the mean over the landmarks that should lie inside the picture.
"""

import json
import pathlib
import sys

import cv2
import mediapipe
import numpy

MAX_FACES = 20
EYE_DISTANCE_PX = 62
LANDMARKS_WITHOUT_IRIS = 468


def main(pictures: pathlib.Path) -> None:
    truth = json.loads((pictures / "truth.json").read_text())
    lines = []
    for name, faces in truth.items():
        picture = cv2.cvtColor(cv2.imread(str(pictures / f"{name}.png")), cv2.COLOR_BGR2RGB)
        answer = [nearest(found, faces, picture.shape) for found in look(picture)]
        lines.append(f"{json.dumps(name)}: {json.dumps(answer, separators=(',', ':'))}")
    golden = pathlib.Path(__file__).parent.parent / "golden" / "robustness.json"
    golden.write_text("{\n" + ",\n".join(lines) + "\n}\n")


def look(picture) -> list:
    height, width, _ = picture.shape
    # A new graph for each picture: nothing may be remembered from the one before.
    with mediapipe.solutions.face_mesh.FaceMesh(static_image_mode=True, max_num_faces=MAX_FACES) as face_mesh:
        found = face_mesh.process(picture).multi_face_landmarks or []
    points = ([(p.x * width, p.y * height) for p in face.landmark[:LANDMARKS_WITHOUT_IRIS]] for face in found)
    return [numpy.array(face) for face in points]


def nearest(found, faces: list, shape: tuple) -> list:
    errors = [error(found, face, shape) for face in faces]
    if not errors:
        return [-1, 0]
    return [int(numpy.argmin(errors)), round(1000 * min(errors))]


def error(found, face: dict, shape: tuple) -> float:
    truth = numpy.array(face["landmarks_px"])
    inside = (truth >= 0).all(axis=1) & (truth < (shape[1], shape[0])).all(axis=1)
    distances = numpy.hypot(*(found - truth)[inside].T)
    return float(distances.mean() / (EYE_DISTANCE_PX * face["scale"]))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
