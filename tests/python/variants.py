"""Photos made of one portrait, each another one and always the same: turned, made larger, moved, lit."""

import math
from pathlib import Path

from PIL import Image, ImageEnhance

# As far from each other as can be in any number of steps, by the golden ratio.
TURN, SIZE, PLACE, LIGHT = 0.618_034, 0.754_878, 0.569_840, 0.819_173


def write(portrait: Path, folder: Path, count: int, side_px: int = 256) -> list[Path]:
    """Writes them as square JPEG files; returns their paths in order."""
    with Image.open(portrait) as opened:
        whole = opened.convert("RGB")
    return [_write(whole, folder / f"{number:05}.jpg", number, side_px) for number in range(count)]


def _write(whole: Image.Image, path: Path, number: int, side_px: int) -> Path:
    turn = math.radians(_between(-20, 20, number * TURN))
    scale = _between(300, 420, number * SIZE) / side_px
    middle = (_between(200, 240, number * PLACE), _between(150, 190, number * LIGHT))
    a, b = scale * math.cos(turn), scale * math.sin(turn)
    half = side_px / 2
    portrait_from_variant = (a, -b, middle[0] - (a - b) * half, b, a, middle[1] - (a + b) * half)
    size = (side_px, side_px)
    variant = whole.transform(size, Image.Transform.AFFINE, portrait_from_variant, Image.Resampling.BILINEAR)
    ImageEnhance.Brightness(variant).enhance(_between(0.7, 1.2, number * LIGHT)).save(path, quality=90)
    return path


def _between(low: float, high: float, step: float) -> float:
    return low + (high - low) * (step % 1.0)
