"""What the tests of the Python package share: the sample portrait, the command line, and variants of the portrait."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
import variants
from PIL import Image

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def portrait() -> Path:
    return ROOT / "web/assets/sample.png"


@pytest.fixture(scope="session")
def album(portrait: Path, tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """A thousand photos that differ, as JPEG files; one of them shows nobody, and one is none."""
    photos = variants.write(portrait, tmp_path_factory.mktemp("album"), 1000)
    Image.new("RGB", (64, 64), "grey").save(photos[300])
    photos[700].write_bytes(b"these are notes")
    return photos


class CommandLine:
    """The program `rosto`, as the native tests build it."""

    program = os.environ.get("ROSTO_CLI", str(ROOT / "target/debug/rosto"))

    def run(self, *words: object) -> bytes:
        run = subprocess.run([self.program, *map(str, words)], capture_output=True, check=True)
        return run.stdout

    def points(self, *words: object) -> np.ndarray:
        """The landmarks of the first face in each photo."""
        lines = self.run("landmarks", *words).splitlines()
        return np.array([json.loads(line)["faces"][0]["landmarks"] for line in lines], np.float32)


@pytest.fixture(scope="session")
def command_line() -> CommandLine:
    return CommandLine()
