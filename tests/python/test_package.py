"""Types, documentation, command line, panics, representations and contents of the package."""

import inspect
import re
import subprocess
import sys
from importlib.metadata import distribution
from pathlib import Path

import numpy as np
import pytest
import rosto
from rosto import _rosto
from rosto._images import finder

ROOT = Path(__file__).parents[2]

USES = """
import io
import numpy as np
import rosto
from PIL import Image

pixels = np.zeros((4, 4, 3), np.uint8)
rosto.landmarks([pixels, "a.jpg", b"", bytearray(), memoryview(b""), io.BytesIO(), open("a.jpg", "rb"), Image.new("L", (4, 4))])
rosto.landmarks(pixels)
rosto.landmarks("a.jpg", jobs=2)
rosto.landmarks(path for path in ["a.jpg"])
edits = [rosto.Vertex(1, np.array([0, 0, 5.0]), anchors=np.array([10])), rosto.Vertex(1, (0, 0, np.float32(5)), anchors=[10])]
rosto.mesh("a.jpg", edits)
rosto.mesh([pixels, b""], rosto.Slider("nose-width", np.float64(4)), mirror=np.bool_(True), pin=[10, 152], density=np.int64(0))
rosto.Laplacian((pixels[0], [[0, 1, 2]])).edit({0: np.array([0, 0, 1.0]), 1: (0, 0, 1)}, np.array([2]), np.float32(1))
"""


@pytest.mark.parametrize("words", [["--ignore-missing-imports", "--package", "rosto"], ["--command", USES]], ids=["own", "uses"])
def test_mypy_strict_accepts_the_package_and_its_uses(tmp_path, words):
    checked = subprocess.run([sys.executable, "-m", "mypy", "--strict", *words], capture_output=True, text=True, cwd=tmp_path)
    assert checked.returncode == 0, checked.stdout


def test_public_names_are_documented():
    public = [getattr(rosto, name) for name in rosto.__all__ if name != "Image"]
    methods = [method for each in public if inspect.isclass(each) for _, method in inspect.getmembers(each, callable)]
    own = [each for each in methods if inspect.isfunction(each) and not each.__name__.startswith("_")]
    undocumented = [each for each in public + own if not inspect.getdoc(each)]
    assert undocumented == []


def test_the_command_line_finds_its_networks(portrait, command_line, tmp_path):
    words = ["landmarks", str(portrait), "--mediapipe"]
    run = subprocess.run([sys.executable, "-m", "rosto", *words], capture_output=True, cwd=tmp_path)
    assert (run.returncode, run.stdout) == (0, command_line(*words))
    assert subprocess.run([sys.executable, "-m", "rosto", "mesh"], capture_output=True).returncode == 2


def test_entry_points_turn_panics_into_errors():
    sources = "".join(file.read_text() for file in (ROOT / "crates/python/src").glob("*.rs"))
    blocks = re.findall(r"#\[pymethods\]\nimpl .*?\n\}\n|#\[pyfunction\]\n.*?\n *\}\n", sources, re.DOTALL)
    entry_points = [function for block in blocks for function in re.split(r"\bfn ", block)[1:]]
    assert {"decode", "find", "new", "edit", "command_line"} <= {re.match(r"\w+", function)[0] for function in entry_points}
    assert [function for function in entry_points if "guarded(" not in function] == []


def test_representations_are_short(portrait):
    edit = rosto.Vertex(1, (0, 0, 5), anchors=range(10, 400))
    made = rosto.mesh(portrait, [edit] * 50, density=0)
    assert repr(made).startswith("Mesh(1 image") and len(repr(made)) < 120
    assert len(repr(edit)) < 120
    assert repr(rosto.landmarks([portrait] + [b"plain text"] * 500)) == "Landmarks(501 images, 1 with a face)"
    assert repr(rosto.faces(portrait)) == "[Face(478 points, confidence 0.98)]"
    assert repr(rosto.Laplacian((np.eye(3), [[0, 1, 2]]))) == "Laplacian(3 vertices, 1 triangles, 'cotangent')"


@pytest.mark.parametrize(
    "work",
    [
        lambda finder: _rosto.FaceMesh([], finder, True, [], []),
        lambda finder: _rosto.Photo.decode(b""),
        lambda finder: _rosto.Photo.from_array(np.zeros((0, 4, 3), np.uint8)),
        lambda finder: _rosto.Photo.from_array(np.zeros((4, 4, 5), np.uint8)),
        lambda finder: _rosto.Photo.from_array(np.zeros((4, 4, 3), np.uint8)[::-1]),
        lambda finder: _rosto.Photo.from_array(np.asfortranarray(np.zeros((4, 5, 3), np.uint8))),
        lambda finder: _rosto.Photo.from_array(np.zeros(4, np.uint8)),
        lambda finder: _rosto.Photo.from_array(np.broadcast_to(np.uint8(0), (2**33, 1))),
        lambda finder: _rosto.Photo.from_array(np.zeros((4, 4, 3))),
        lambda finder: _rosto.Finder(b"", b"", True),
        lambda finder: _rosto.System(np.zeros((0, 3)), np.zeros((0, 3), np.uint32), "cotangent"),
        lambda finder: _rosto.System(np.eye(3)[::-1], np.array([[0, 1, 2]], np.uint32), "cotangent"),
        lambda finder: _rosto.System(np.eye(3) * np.nan, np.array([[0, 1, 2]], np.uint32), "L"),
        lambda finder: _rosto.System(np.eye(3), np.array([[0, 1, 2]], np.uint32), "L").edit([0], np.zeros((2, 3)), [1]),
        lambda finder: _rosto.System(np.eye(3), np.array([[0, 1, 2]], np.uint32), "L").edit([9], np.zeros((1, 3)), [1]),
        lambda finder: _rosto.System(np.eye(3), np.array([[0, 1, 2]], np.uint32), "L").deltas(np.zeros((2, 3))),
    ],
)
def test_the_native_part_refuses_invalid_arguments(work):
    with pytest.raises((ValueError, TypeError)):
        work(finder(True))


def test_the_wheel_is_abi3_and_contains_its_licences():
    files = [file.name for file in distribution("rosto").files]
    assert {"LICENSE-MIT", "LICENSE-APACHE", "NOTICE", "py.typed", "_rosto.pyi", "face_detector.onnx"} <= set(files)
    assert any(name.startswith("_rosto.abi3") for name in files)
