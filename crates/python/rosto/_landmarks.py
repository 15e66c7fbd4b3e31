"""Images to landmarks."""

from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional

import numpy as np
import numpy.typing as npt

from ._images import Image, finder, opened
from ._rosto import Photo, RostoError

if TYPE_CHECKING:
    import pyarrow


@dataclass(frozen=True)
class Search:
    """How faces are looked for; the command line's ``--mediapipe``, ``--refine`` and ``--max-faces``.

    The default looks at turns and parts of the image too, finds landmarks again until they agree, and refines lips, eyes and
    irises: 478 landmarks. ``Search(mediapipe=True)`` does exactly what MediaPipe's Face Mesh does with a single picture: one
    look, one pass, 468 landmarks.
    """

    mediapipe: bool = False
    refine: bool = False
    max_faces: Optional[int] = None

    @property
    def refined(self) -> bool:
        """Whether there are 478 landmarks, the last ten of the irises, or 468."""
        return self.refine or not self.mediapipe


@dataclass(frozen=True, eq=False)
class Face:
    """One face.

    ``points`` has the shape ``(468, 3)`` or ``(478, 3)``, in MediaPipe's convention: x/width, y/height, z/width; y points
    down, smaller z is nearer. ``score`` is the detector's, ``presence`` the landmark network's, ``confidence`` how sure it is
    that this is a face and that the landmarks lie on it; all three 0 to 1.
    """

    points: npt.NDArray[np.float32]
    score: float
    presence: float
    confidence: float


@dataclass(frozen=True, eq=False)
class Landmarks:
    """The most prominent face of each of N images.

    ``points`` has the shape ``(N, 468, 3)`` or ``(N, 478, 3)``, as in :class:`Face`; NaN where there is none. ``reasons`` says
    why there is none, and is ``None`` where there is a face. ``confidence`` has the shape ``(N,)``, ``sizes`` the shape
    ``(N, 2)``: height and width of the upright image in px, 0 where it could not be read.
    """

    points: npt.NDArray[np.float32]
    confidence: npt.NDArray[np.float32]
    sizes: npt.NDArray[np.uint32]
    reasons: list[Optional[str]]

    def __len__(self) -> int:
        return len(self.reasons)

    def to_arrow(self) -> "pyarrow.Table":
        """A table with a row for each image; needs the package ``pyarrow``."""
        import pyarrow as pa

        count = self.points.shape[1]
        flat = pa.array(self.points.reshape(-1), pa.float32())
        mask = np.array([reason is not None for reason in self.reasons], dtype=bool)
        missing = pa.array(mask) if mask.any() else None
        points = pa.FixedSizeListArray.from_arrays(flat, count * 3, mask=missing)
        columns = {
            "height": self.sizes[:, 0],
            "width": self.sizes[:, 1],
            "confidence": pa.array(self.confidence, mask=mask),
            "points": points,
            "reason": pa.array(self.reasons, pa.string()),
        }
        return pa.table(columns)


def faces(image: Image, search: Search = Search()) -> list[Face]:
    """All faces of an image, the most prominent one first; none is an answer. Raises :class:`RostoError` if it cannot be read."""
    return _faces(opened(image), search)


def landmarks(images: Iterable[Image], search: Search = Search(), *, jobs: int = 1) -> Landmarks:
    """The most prominent face of each image, in their order; ``jobs`` images at a time, each in a thread.

    An image that cannot be read or shows no face has NaN and a reason, and stops no other.
    """
    found = list(_in_order(images, search, jobs))
    count = 478 if search.refined else 468
    points = np.full((len(found), count, 3), np.nan, np.float32)
    confidence = np.full(len(found), np.nan, np.float32)
    sizes = np.zeros((len(found), 2), np.uint32)
    reasons: list[Optional[str]] = []
    for row, (size, face, reason) in enumerate(found):
        sizes[row] = size
        reasons.append(reason)
        if face is not None:
            points[row], confidence[row] = face.points, face.confidence
    return Landmarks(points, confidence, sizes, reasons)


_Found = tuple[tuple[int, int], Optional[Face], Optional[str]]


def _in_order(images: Iterable[Image], search: Search, jobs: int) -> Iterator[_Found]:
    finder(search.refined)
    if jobs == 1:
        yield from (_most_prominent(image, search) for image in images)
        return
    with ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(lambda image: _most_prominent(image, search), images)


def _most_prominent(image: Image, search: Search) -> _Found:
    try:
        photo = opened(image)
        found = _faces(photo, search)
    except (RostoError, OSError) as reason:
        return (0, 0), None, str(reason)
    return photo.size, next(iter(found), None), None if found else "no face found"


def _faces(photo: Photo, search: Search) -> list[Face]:
    found = finder(search.refined).find(photo, not search.mediapipe, search.max_faces)
    return [Face(*face) for face in found]
