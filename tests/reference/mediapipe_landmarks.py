"""MediaPipe's own answers for the test pictures: tests/golden/landmarks.json, and with lips, eyes and irises refined
(refine_landmarks=True) tests/golden/refined_landmarks.json.

    cargo run -p rosto-landmarks --example write_test_pictures -- target/test-pictures
    python3 -m venv target/mediapipe
    target/mediapipe/bin/pip install -r tests/reference/mediapipe_requirements.txt
    target/mediapipe/bin/python tests/reference/mediapipe_landmarks.py target/test-pictures

Each picture is called NAME.FACES.png, FACES being how many faces are asked for. Written for each: its size and, for
each face, 468 (refined: 478) × (x, y, z) in thousandths of a pixel: x and z in units of the picture's width, y of its
height.
"""

import json
import pathlib
import sys

import cv2
import mediapipe

MILLIPIXELS = 1000


def main(pictures: pathlib.Path) -> None:
    write(pictures, "landmarks.json", refined=False)
    write(pictures, "refined_landmarks.json", refined=True)


def write(pictures: pathlib.Path, file: str, refined: bool) -> None:
    answers = {}
    for path in sorted(pictures.glob("*.png")):
        name, faces, _ = path.name.split(".")
        answers[name] = look(cv2.cvtColor(cv2.imread(str(path)), cv2.COLOR_BGR2RGB), int(faces), refined)
    golden = pathlib.Path(__file__).parent.parent / "golden" / file
    lines = (f"{json.dumps(name)}: {json.dumps(answer, separators=(',', ':'))}" for name, answer in answers.items())
    golden.write_text("{\n" + ",\n".join(lines) + "\n}\n")


def look(picture, max_faces: int, refined: bool) -> dict:
    height, width, _ = picture.shape
    # A new graph for each picture: nothing may be remembered from the one before.
    options = {"static_image_mode": True, "max_num_faces": max_faces, "refine_landmarks": refined}
    with mediapipe.solutions.face_mesh.FaceMesh(**options) as face_mesh:
        found = face_mesh.process(picture).multi_face_landmarks or []
    return {"width": width, "height": height, "faces": [millipixels(face, width, height) for face in found]}


def millipixels(face, width: int, height: int) -> list:
    scaled = ((point.x * width, point.y * height, point.z * width) for point in face.landmark)
    return [round(value * MILLIPIXELS) for point in scaled for value in point]


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
