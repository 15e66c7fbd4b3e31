"""The native part: what `rosto` is made of; its own functions and classes are there for everybody."""

import numpy as np
import numpy.typing as npt

MAX_BYTES: int
"""Length that a photo's file may have at most."""

class RostoError(ValueError):
    """An image that cannot be read, a face that is not there, an edit that cannot be made: says what failed and what to do."""

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
    """The face networks, made ready once."""

    def __new__(cls, detector_onnx: bytes, landmarks_onnx: bytes, refined: bool) -> Finder: ...
    def find(
        self, photo: Photo, thorough: bool, max_faces: int | None = None
    ) -> list[tuple[npt.NDArray[np.float32], float, float, float]]: ...

class FaceMesh:
    """A face as `rosto mesh` makes it."""

    def __new__(cls, photos: list[Photo], finder: Finder, options: list[str]) -> FaceMesh: ...
    def positions_m(self) -> npt.NDArray[np.float64]: ...
    def triangles(self) -> npt.NDArray[np.uint32]: ...
    def colours(self) -> npt.NDArray[np.uint8]: ...
    def uvs(self) -> npt.NDArray[np.float64]: ...
    def write(self, name: str, options: list[str]) -> list[tuple[str, bytes]]: ...

class System:
    """A mesh with the Laplacian whose δ-coordinates its edits keep, factorised once."""

    def __new__(
        cls, positions: npt.NDArray[np.float64], triangles: npt.NDArray[np.uint32], operator: str
    ) -> System: ...
    def edit(
        self, handles: list[int], offsets: npt.NDArray[np.float64], anchors: list[int], weight: float | None = None
    ) -> npt.NDArray[np.float64]: ...
    def deltas(self, positions: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]: ...
    def matrix(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64], npt.NDArray[np.int64]]: ...

def check_length(bytes: int) -> None:
    """Raises if a file of `bytes` bytes is longer than a photo's may be."""

def check_size(height: int, width: int) -> None:
    """Raises if a picture of this size has more pixels than a photo may have, or none."""

def command_line(words: list[str]) -> int:
    """Does what the words of a command line ask for, the program's name first; returns its exit code."""
