"""MediaPipe's own answers for the test pictures, as tests/golden/landmarks.json.

    cargo run -p rosto-landmarks --example write_test_pictures -- target/test-pictures
    python3 -m venv target/mediapipe
    target/mediapipe/bin/pip install -r tests/reference/mediapipe_requirements.txt
    target/mediapipe/bin/python tests/reference/mediapipe_landmarks.py target/test-pictures

Each picture is called NAME.FACES.png, FACES being how many faces are asked for. Written for each: its size and, for
each face, 468 × (x, y, z) in thousandths of a pixel: x and z in units of the picture's width, y of its height.
"""

import json
import pathlib
import sys

import cv2
import mediapipe

MILLIPIXELS = 1000
LANDMARKS_WITHOUT_IRIS = 468


def main(pictures: pathlib.Path) -> None:
    answers = {}
    for path in sorted(pictures.glob("*.png")):
        name, faces, _ = path.name.split(".")
        answers[name] = look(cv2.cvtColor(cv2.imread(str(path)), cv2.COLOR_BGR2RGB), int(faces))
    golden = pathlib.Path(__file__).parent.parent / "golden" / "landmarks.json"
    lines = (f"{json.dumps(name)}: {json.dumps(answer, separators=(',', ':'))}" for name, answer in answers.items())
    golden.write_text("{\n" + ",\n".join(lines) + "\n}\n")


def look(picture, max_faces: int) -> dict:
    height, width, _ = picture.shape
    # A new graph for each picture: nothing may be remembered from the one before.
    with mediapipe.solutions.face_mesh.FaceMesh(static_image_mode=True, max_num_faces=max_faces) as face_mesh:
        found = face_mesh.process(picture).multi_face_landmarks or []
    return {"width": width, "height": height, "faces": [millipixels(face, width, height) for face in found]}


def millipixels(face, width: int, height: int) -> list:
    points = face.landmark[:LANDMARKS_WITHOUT_IRIS]
    scaled = ((point.x * width, point.y * height, point.z * width) for point in points)
    return [round(value * MILLIPIXELS) for point in scaled for value in point]


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
