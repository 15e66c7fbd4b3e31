"""Images to landmarks."""

from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional, Union

import numpy as np
import numpy.typing as npt

from ._images import Held, Image, finder, held, listed, opened, reason_of
from ._numbers import flag, whole
from ._rosto import Photo

if TYPE_CHECKING:
    import pyarrow


@dataclass(frozen=True)
class Search:
    """How faces are looked for; the command line's ``--mediapipe``, ``--refine`` and ``--max-faces``.

    The default looks at turns and parts of the image too, finds landmarks again until they agree, and refines lips, eyes and
    irises: 478 landmarks. ``Search(mediapipe=True)`` does exactly what MediaPipe's Face Mesh does with a single picture: one
    look, one pass, 468 landmarks. ``max_faces`` is 1 or greater.
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

    def __repr__(self) -> str:
        return f"Face({len(self.points)} points, confidence {self.confidence:.2f})"


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

    def __repr__(self) -> str:
        return f"Landmarks({len(self)} images, {self.reasons.count(None)} with a face)"

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
    """All faces of an image, the most prominent one first; the list may be empty.

    Raises :class:`RostoError` if the image cannot be read, or ``OSError`` if its file cannot be opened.
    """
    return _faces(opened(held(image)), search)


def landmarks(images: Union[Image, Iterable[Image]], search: Search = Search(), *, jobs: int = 1) -> Landmarks:
    """The most prominent face of each image, in their order; ``jobs`` images at a time, each in a thread.

    An image that cannot be read or shows no face, or an object that is not an image, has NaN and a reason, and stops no other.
    A single image is a list of one; an array of four axes is a list of images.

    ``images`` may be a generator: an image is taken from it when fewer than ``2 * jobs`` others are in work. What is taken is
    copied at once, so that the generator may use its buffers again. An exception of the generator's own, like an interrupt
    from the keyboard, ends the call and is passed on.
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
        yield from (_most_prominent(_taken(image), search) for image in images)
        return
    pool = ThreadPoolExecutor(jobs)
    in_work: deque[Future[_Found]] = deque()
    try:
        for image in images:
            in_work.append(pool.submit(_most_prominent, _taken(image), search))
            if len(in_work) == 2 * jobs:
                yield in_work.popleft().result()
        while in_work:
            yield in_work.popleft().result()
    except BaseException:
        # Ends at once: a thread that is in the middle of a photo ends with it.
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    pool.shutdown()


def _taken(image: Image) -> Union[Held, Exception]:
    """Copies what can change, in the thread that the image comes from."""
    try:
        return held(image)
    except Exception as reason:  # whatever an object that is not an image raises
        return reason


def _most_prominent(image: Union[Held, Exception], search: Search) -> _Found:
    if isinstance(image, Exception):
        return (0, 0), None, reason_of(image)
    try:
        photo = opened(image)
        found = _faces(photo, search)
    except Exception as reason:
        return (0, 0), None, reason_of(reason)
    return photo.size, next(iter(found), None), None if found else "no face found"


def _faces(photo: Photo, search: Search) -> list[Face]:
    found = finder(search.refined).find(photo, not search.mediapipe, search.max_faces)
    return [Face(*face) for face in found]
