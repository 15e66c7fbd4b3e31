"""Fixtures: the sample portrait, variants of it, and the command line."""

import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from random import Random

import numpy as np
import pytest
from PIL import Image, ImageEnhance

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def portrait() -> Path:
    return ROOT / "web/assets/sample.png"


@pytest.fixture(scope="session")
def pixels(portrait: Path) -> np.ndarray:
    """The portrait as a read-only array."""
    with Image.open(portrait) as opened:
        return np.asarray(opened.convert("RGB"))


@pytest.fixture(scope="session")
def album(pixels: np.ndarray, tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """300 JPEG files: rotated, cropped and brightened variants of the portrait, one without a face, and one that is not a picture."""
    random, folder = Random(0), tmp_path_factory.mktemp("album")
    photos = [folder / f"{number:05}.jpg" for number in range(300)]
    for photo in photos:
        x, y, half = random.uniform(200, 240), random.uniform(150, 190), random.uniform(150, 210)
        turned = Image.fromarray(pixels).rotate(random.uniform(-20, 20), Image.Resampling.BILINEAR, center=(x, y))
        cut = turned.crop((x - half, y - half, x + half, y + half)).resize((256, 256))
        ImageEnhance.Brightness(cut).enhance(random.uniform(0.7, 1.2)).save(photo, quality=90)
    Image.new("RGB", (64, 64), "grey").save(photos[100])
    photos[200].write_bytes(b"plain text")
    return photos


@pytest.fixture(scope="session")
def command_line() -> Callable[..., bytes]:
    """Runs the `rosto` that the native tests build; returns its output."""
    program = os.environ.get("ROSTO_CLI", ROOT / "target/debug/rosto")
    return lambda *words: subprocess.check_output([program, *map(str, words)])
