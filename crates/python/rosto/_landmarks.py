"""Landmark detection."""

from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional, Union

import numpy as np
import numpy.typing as npt

from ._images import Frozen, Image, decoded, finder, frozen, listed, reason_of
from ._numbers import flag, whole
from ._rosto import Photo

if TYPE_CHECKING:
    import pyarrow


@dataclass(frozen=True)
class Search:
    """Detection options; the command line's ``--mediapipe``, ``--refine`` and ``--max-faces``.

    The default also searches rotated copies and parts of the image, iterates until the landmarks converge, and refines
    lips, eyes and irises: 478 landmarks. ``Search(mediapipe=True)`` reproduces MediaPipe's Face Mesh on a still image:
    one detection, one pass, 468 landmarks. ``max_faces`` is at least 1.
    """

    mediapipe: bool = False
    refine: bool = False
    max_faces: Optional[int] = None

    def __post_init__(self) -> None:
        for name in ("mediapipe", "refine"):
            object.__setattr__(self, name, flag(name, getattr(self, name)))
        if self.max_faces is not None:
            object.__setattr__(self, "max_faces", whole("max_faces", self.max_faces, least=1))

    @property
    def refined(self) -> bool:
        """Whether results have 478 landmarks, the last ten on the irises, or 468."""
        return self.refine or not self.mediapipe


@dataclass(frozen=True, eq=False)
class Face:
    """One face.

    ``points`` has shape ``(468, 3)`` or ``(478, 3)``, normalised as in MediaPipe: x/width, y/height, z/width; y points
    down, smaller z is nearer. ``score`` comes from the detector and ``presence`` from the landmark network.
    ``confidence`` rates whether this is a face and the landmarks lie on it. All three are 0 to 1.
    """

    points: npt.NDArray[np.float32]
    score: float
    presence: float
    confidence: float

    def __repr__(self) -> str:
        return f"Face({len(self.points)} points, confidence {self.confidence:.2f})"


@dataclass(frozen=True, eq=False)
class Landmarks:
    """The most prominent face of each of N images.

    ``points`` has shape ``(N, 468, 3)`` or ``(N, 478, 3)``, as in :class:`Face`, and is NaN without a face. ``reasons``
    holds the reason why there is none, or ``None``. ``confidence`` has shape ``(N,)``. ``sizes`` has shape ``(N, 2)``:
    height and width of the upright image in px, or 0 if it is unreadable.
    """

    points: npt.NDArray[np.float32]
    confidence: npt.NDArray[np.float32]
    sizes: npt.NDArray[np.uint32]
    reasons: list[Optional[str]]

    def __len__(self) -> int:
        return len(self.reasons)

    def __repr__(self) -> str:
        return f"Landmarks({len(self)} images, {self.reasons.count(None)} with a face)"

    def to_arrow(self) -> "pyarrow.Table":
        """Returns a table with a row per image. Requires ``pyarrow``."""
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
    """Returns the faces in an image, most prominent first; the list may be empty.

    Raises :class:`RostoError` if the image cannot be read, or ``OSError`` if its file cannot be opened.
    """
    return _faces(decoded(frozen(image)), search)


def landmarks(images: Union[Image, Iterable[Image]], search: Search = Search(), *, jobs: int = 1) -> Landmarks:
    """Returns the most prominent face of each image, in order. ``jobs`` is the number of threads.

    An unreadable image, an image without a face, and an object that is not an image give NaN and a reason; the others
    are unaffected. A single image is a list of one; a 4D array is a list of images.

    ``images`` may be a generator. It is consumed lazily, with at most ``2 * jobs`` images in progress. Images are
    copied at once, so that the generator may reuse its buffers. An exception in the generator, or
    ``KeyboardInterrupt``, ends the call and propagates.
    """
    jobs = whole("jobs", jobs, least=1)
    found = list(_in_order(listed(images), search, jobs))
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
        yield from (_most_prominent(_frozen(image), search) for image in images)
        return
    pool = ThreadPoolExecutor(jobs)
    in_progress: deque[Future[_Found]] = deque()
    try:
        for image in images:
            in_progress.append(pool.submit(_most_prominent, _frozen(image), search))
            if len(in_progress) == 2 * jobs:
                yield in_progress.popleft().result()
        while in_progress:
            yield in_progress.popleft().result()
    except BaseException:
        # Does not wait: threads end after their current photo.
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    pool.shutdown()


def _frozen(image: Image) -> Union[Frozen, Exception]:
    """Copies an image in the generator's thread; returns the error if that fails."""
    try:
        return frozen(image)
    except Exception as reason:  # any object may come here, and raise anything
        return reason


def _most_prominent(image: Union[Frozen, Exception], search: Search) -> _Found:
    if isinstance(image, Exception):
        return (0, 0), None, reason_of(image)
    try:
        photo = decoded(image)
        found = _faces(photo, search)
    except Exception as reason:
        return (0, 0), None, reason_of(reason)
    return photo.size, next(iter(found), None), None if found else "no face found"


def _faces(photo: Photo, search: Search) -> list[Face]:
    found = finder(search.refined).find(photo, not search.mediapipe, search.max_faces)
    return [Face(*face) for face in found]
