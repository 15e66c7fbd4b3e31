"""Writes MediaPipe's landmarks of the test pictures to tests/golden/landmarks.json, and with refine_landmarks=True
(lips, eyes and irises) to tests/golden/refined_landmarks.json.

    cargo run -p rosto-landmarks --example write_test_pictures -- target/test-pictures
    python3 -m venv target/mediapipe
    target/mediapipe/bin/pip install -r tests/reference/mediapipe_requirements.txt
    target/mediapipe/bin/python tests/reference/mediapipe_landmarks.py target/test-pictures

Pictures are named NAME.FACES.png, where FACES is MediaPipe's max_num_faces. Each result has the size of the picture
and, per face, 468 (refined: 478) × (x, y, z) in thousandths of a pixel. MediaPipe's x and z are scaled by the width,
y by the height.
"""

import json
import pathlib
import sys

import cv2
import mediapipe
import numpy


def main(pictures: pathlib.Path) -> None:
    for file, refined in [("landmarks.json", False), ("refined_landmarks.json", True)]:
        answers = {}
        for path in sorted(pictures.glob("*.png")):
            name, asked, _ = path.name.split(".")
            width, height, faces = look(path, int(asked), refined)
            millipixels = [numpy.rint(1000 * face).astype(int).ravel().tolist() for face in faces]
            answers[name] = {"width": width, "height": height, "faces": millipixels}
        write(file, answers)


def look(path: pathlib.Path, max_faces: int, refined: bool = False) -> tuple:
    """Returns width, height, and the landmarks of each face as rows of x, y, z in px."""
    picture = cv2.cvtColor(cv2.imread(str(path)), cv2.COLOR_BGR2RGB)
    height, width, _ = picture.shape
    # A new graph per picture, because a graph keeps state between pictures.
    options = {"static_image_mode": True, "max_num_faces": max_faces, "refine_landmarks": refined}
    with mediapipe.solutions.face_mesh.FaceMesh(**options) as face_mesh:
        found = face_mesh.process(picture).multi_face_landmarks or []
    faces = [numpy.array([(point.x, point.y, point.z) for point in face.landmark]) for face in found]
    return width, height, [face * (width, height, width) for face in faces]


def write(file: str, answers: dict) -> None:
    """Writes a golden file with one line per picture."""
    lines = (f"{json.dumps(name)}: {json.dumps(answer, separators=(',', ':'))}" for name, answer in answers.items())
    (pathlib.Path(__file__).parents[1] / "golden" / file).write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
