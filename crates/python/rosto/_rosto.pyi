"""Native part of `rosto`; use the functions and classes of `rosto` instead."""

import numpy as np
import numpy.typing as npt

from ._edits import Edit
from ._numbers import Plain

MAX_BYTES: int
"""Maximum length of a photo's file in bytes."""

class RostoError(ValueError):
    """Unreadable image, missing face or impossible edit. The message states what failed and what to do."""

class Photo:
    """An upright sRGB picture."""

    @staticmethod
    def decode(file: bytes) -> Photo: ...
    @staticmethod
    def from_array(pixels: npt.NDArray[np.uint8]) -> Photo: ...
    def pixels(self) -> npt.NDArray[np.uint8]: ...
    @property
    def size(self) -> tuple[int, int]: ...

class Finder:
    """The face networks, loaded once."""

    def __new__(cls, detector_onnx: bytes, landmarks_onnx: bytes, refined: bool) -> Finder: ...
    def find(
        self, photo: Photo, thorough: bool, max_faces: int | None = None
    ) -> list[tuple[npt.NDArray[np.float32], float, float, float]]: ...

class FaceMesh:
    """A face mesh, as `rosto mesh` computes it."""

    def __new__(
        cls, photos: list[Photo], finder: Finder, thorough: bool, edits: list[Edit], options: list[tuple[str, Plain]]
    ) -> FaceMesh: ...
    def positions_m(self) -> npt.NDArray[np.float64]: ...
    def triangles(self) -> npt.NDArray[np.uint32]: ...
    def colours(self) -> npt.NDArray[np.uint8]: ...
    def uvs(self) -> npt.NDArray[np.float64]: ...
    def write(self, name: str, options: list[tuple[str, Plain]]) -> list[tuple[str, bytes]]: ...

class System:
    """A mesh with a factorised Laplacian."""

    def __new__(
        cls, positions: npt.NDArray[np.float64], triangles: npt.NDArray[np.uint32], operator: str
    ) -> System: ...
    def edit(
        self, handles: list[int], offsets: npt.NDArray[np.float64], anchors: list[int], weight: float | None = None
    ) -> npt.NDArray[np.float64]: ...
    def deltas(self, positions: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]: ...
    def matrix(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64], npt.NDArray[np.int64]]: ...

def check_length(bytes: int) -> None:
    """Raises if a file of `bytes` bytes exceeds the limit for photos."""

def check_size(height: int, width: int) -> None:
    """Raises if a picture of this size has no pixels, or exceeds the limit for photos."""

def command_line(words: list[str]) -> int:
    """Runs the command line with these arguments, the program's name first; returns the exit code."""
