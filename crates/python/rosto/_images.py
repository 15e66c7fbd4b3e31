"""Conversion of images, and the cached networks."""

import io
import os
import reprlib
import stat
import traceback
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any, Optional, Protocol, Union

import numpy as np
import numpy.typing as npt

from ._rosto import MAX_BYTES, Finder, Photo, RostoError, check_length, check_size


class File(Protocol):
    """A file object opened for reading in binary mode."""

    def read(self, size: int, /) -> bytes:
        """Reads at most ``size`` bytes; returns ``b""`` at the end."""
        ...


class PillowImage(Protocol):
    """A Pillow image, as a protocol, because Pillow is optional."""

    @property
    def mode(self) -> str:
        """Pixel format."""
        ...

    def save(self, fp: Any, format: Optional[str] = None, **params: Any) -> None:
        """Writes the image to a file."""
        ...


Image = Union[str, "os.PathLike[str]", bytes, bytearray, memoryview, File, npt.NDArray[np.uint8], PillowImage]
"""A path; a JPEG, PNG or WebP file as bytes or file object; ``uint8`` sRGB pixels of shape ``(height, width)`` or
``(height, width, 1, 3 or 4)``; or a Pillow image."""

Frozen = Union[str, bytes, npt.NDArray[np.uint8]]
"""A path, or an immutable copy of a file or of pixels."""

NETWORKS = Path(__file__).parent / "networks"
# Modes that PNG preserves. Other modes with 8 bits per channel are converted.
_PNG_MODES = {"1", "L", "LA", "P", "RGB", "RGBA", "I;16"}
_CONVERTED = {"CMYK": "RGB", "YCbCr": "RGB", "LAB": "RGB", "HSV": "RGB", "RGBX": "RGB", "PA": "RGBA", "La": "LA", "RGBa": "RGBA"}
_MAX_REASON_LENGTH = 500


def listed(images: object) -> Iterable[Any]:
    """Iterates over images. A single image is a list of one; a 4D array is a list of images."""
    if _is_single(images):
        return [images]
    if _is_array(images):
        return np.atleast_1d(np.asarray(images))
    if isinstance(images, Iterable):
        return images
    raise TypeError(f"{reprlib.repr(images)} is neither an image nor a list of images")


def frozen(image: object) -> Frozen:
    """Copies an image, so that later changes to the object have no effect. A path stays a path."""
    if isinstance(image, (str, os.PathLike)):
        return os.fsdecode(image)
    if isinstance(image, bytes):
        check_length(len(image))
        return image
    if _is_pillow(image):
        return _as_png(image)
    if _is_array(image):
        return _pixels(image)
    if (buffer := _buffer(image)) is not None:
        check_length(buffer.nbytes)
        return bytes(buffer)
    if _is_file(image):
        return _read(image)
    raise RostoError(
        f"{reprlib.repr(image)} is not an image: give a path, a file's bytes, a file object, pixels or a Pillow image"
    )


def contents(image: Frozen) -> Union[bytes, npt.NDArray[np.uint8]]:
    """Replaces a path by the bytes of its file."""
    if not isinstance(image, str):
        return image
    try:
        about = os.stat(image)
    except ValueError as error:  # NUL character
        raise RostoError(f"{reprlib.repr(image)} is not a path: {error}") from error
    # Reading a pipe may block, and a device may be endless.
    if not stat.S_ISREG(about.st_mode):
        raise RostoError(f"{reprlib.repr(image)} is not a file")
    check_length(about.st_size)
    with open(image, "rb") as file:
        return _read(file)


def decoded(image: Frozen) -> Photo:
    """Decodes an image into an upright photo."""
    inside = contents(image)
    return Photo.decode(inside) if isinstance(inside, bytes) else Photo.from_array(inside)


def reason_of(error: Exception) -> str:
    """Returns the error as short, valid UTF-8 text."""
    known = str(error) if isinstance(error, (RostoError, OSError, RuntimeError)) else ""
    reason = known or "".join(traceback.format_exception_only(error)).strip()
    # A path may contain bytes that are not UTF-8.
    reason = reason.encode("utf-8", "backslashreplace").decode()
    return reason if len(reason) <= _MAX_REASON_LENGTH else f"{reason[: _MAX_REASON_LENGTH - 1]}…"


@cache
def finder(refined: bool) -> Finder:
    """Returns this process's networks, with or without refined lips, eyes and irises."""
    landmarks = "face_landmarks_attention.onnx" if refined else "face_landmarks.onnx"
    detector = (NETWORKS / "face_detector.onnx").read_bytes()
    return Finder(detector, (NETWORKS / landmarks).read_bytes(), refined)


def _is_single(images: object) -> bool:
    if isinstance(images, (str, os.PathLike, bytes)) or _is_pillow(images):
        return True
    if not _is_array(images):
        return _buffer(images) is not None or _is_file(images)
    try:
        array = np.asarray(images)
    except Exception:  # reported later as this image's reason
        return True
    return array.dtype.kind not in "OSUT" and array.ndim < 4


def _is_pillow(image: object) -> bool:
    return all(hasattr(image, name) for name in ("mode", "getexif", "convert", "save"))


def _is_array(image: object) -> bool:
    return any(hasattr(image, name) for name in ("__array__", "__array_interface__", "__array_struct__"))


def _is_file(image: object) -> bool:
    return callable(getattr(image, "read", None))


def _buffer(image: object) -> Optional[memoryview]:
    try:
        return memoryview(image)  # type: ignore[arg-type]
    except (TypeError, BufferError):
        return None


def _pixels(image: Any) -> npt.NDArray[np.uint8]:
    array = np.asarray(image)
    has_channels = array.ndim == 3 and array.shape[2] in (1, 3, 4)
    if array.dtype != np.uint8 or not (array.ndim == 2 or has_channels):
        expected = "uint8 (height, width), (height, width, 3) or (height, width, 4)"
        raise RostoError(f"pixels are {array.dtype} {array.shape}, not {expected}")
    check_size(*array.shape[:2])
    copy = np.array(array, np.uint8, order="C")
    copy.flags.writeable = False
    return copy


def _as_png(image: Any) -> bytes:
    """Encodes a Pillow image with its colour profile and EXIF data, so that it decodes like its original file."""
    image.load()
    check_size(image.height, image.width)
    about = {"exif": image.info["exif"]} if image.info.get("exif") else {}
    if image.mode not in _PNG_MODES:
        if image.mode not in _CONVERTED:
            raise RostoError(f"Pillow's mode {image.mode} does not define the value of white: convert the image to RGB")
        image, about = image.convert(_CONVERTED[image.mode]), {**about, "icc_profile": None}
    file = io.BytesIO()
    image.save(file, "PNG", compress_level=0, **about)
    return file.getvalue()


def _read(file: Any) -> bytes:
    parts, count = [], 0
    while count <= MAX_BYTES:
        part = file.read(MAX_BYTES + 1 - count)
        if not isinstance(part, (bytes, bytearray, memoryview)):
            raise RostoError(f"reading the file gives {type(part).__name__}, not bytes: open it in binary mode")
        if not part:
            break
        parts.append(bytes(part))
        count += len(parts[-1])
    check_length(count)
    return b"".join(parts)
