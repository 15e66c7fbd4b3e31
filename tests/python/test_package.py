"""What the package is made of: types that hold, documentation for all of it, the command line, the networks' licence."""

import inspect
import subprocess
import sys
from importlib.metadata import distribution

import rosto


def test_types_hold_by_mypys_strictest(tmp_path):
    words = ["-m", "mypy", "--strict", "--ignore-missing-imports", "--package", "rosto"]
    checked = subprocess.run([sys.executable, *words], capture_output=True, text=True, cwd=tmp_path)
    assert checked.returncode == 0, checked.stdout


def test_whatever_is_public_is_documented():
    public = [getattr(rosto, name) for name in rosto.__all__ if name != "Image"]
    methods = [method for each in public if inspect.isclass(each) for _, method in inspect.getmembers(each, callable)]
    own = [each for each in methods if inspect.isfunction(each) and not each.__name__.startswith("_")]
    undocumented = [each for each in public + own if not inspect.getdoc(each)]
    assert undocumented == []


def test_the_command_line_comes_along_and_finds_its_networks(portrait, command_line, tmp_path):
    words = ["landmarks", str(portrait), "--mediapipe"]
    run = subprocess.run([sys.executable, "-m", "rosto", *words], capture_output=True, cwd=tmp_path)
    assert (run.returncode, run.stdout) == (0, command_line.run(*words))
    assert subprocess.run([sys.executable, "-m", "rosto", "mesh"], capture_output=True).returncode == 2


def test_the_wheel_has_its_licences_and_fits_every_python_from_the_oldest_on():
    files = [file.name for file in distribution("rosto").files]
    assert {"LICENSE-MIT", "LICENSE-APACHE", "NOTICE", "py.typed", "_rosto.pyi", "face_detector.onnx"} <= set(files)
    assert any(name.startswith("_rosto.abi3") for name in files)
