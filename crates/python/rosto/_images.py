"""What can be given as an image, and the networks that look at it."""

import os
from functools import cache
from pathlib import Path
from typing import Union

import numpy as np
import numpy.typing as npt

from ._rosto import Finder, Photo, RostoError

Image = Union[str, "os.PathLike[str]", bytes, npt.NDArray[np.uint8]]
"""A path, a file's bytes, or pixels of the shape ``(height, width, 3)``, sRGB."""

NETWORKS = Path(__file__).parent / "networks"


def opened(image: Image) -> Photo:
    """The picture, upright."""
    if isinstance(image, np.ndarray):
        if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] != 3:
            raise RostoError(f"pixels are {image.dtype} {image.shape}, not uint8 (height, width, 3)")
        return Photo.from_array(image)
    return Photo.decode(image if isinstance(image, bytes) else Path(image).read_bytes())


@cache
def finder(refined: bool) -> Finder:
    """The networks of this process, with the landmark network that refines lips, eyes and irises or without."""
    landmarks = "face_landmarks_attention.onnx" if refined else "face_landmarks.onnx"
    detector = (NETWORKS / "face_detector.onnx").read_bytes()
    return Finder(detector, (NETWORKS / landmarks).read_bytes(), refined)
