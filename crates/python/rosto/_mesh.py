"""A photo to an edited, coloured mesh."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Union

import numpy as np
import numpy.typing as npt

from ._edits import Edit
from ._images import Image, finder, opened
from ._landmarks import Search
from ._rosto import FaceMesh

Option = Union[str, float, bool, Sequence[Union[str, float]]]


@dataclass(frozen=True, eq=False)
class Mesh:
    """A face as :func:`mesh` makes it. It pickles as what it was made of, and is made anew where it arrives."""

    images: tuple[Image, ...]
    words: tuple[str, ...]
    search: Search

    @cached_property
    def _native(self) -> FaceMesh:
        return FaceMesh([opened(image) for image in self.images], finder(self.search.refined), list(self.words))

    @cached_property
    def positions_m(self) -> npt.NDArray[np.float64]:
        """Shape ``(V, 3)``, metres: +x the subject's left, +y up, +z out of the face. The first 468 are the landmarks."""
        return self._native.positions_m()

    @cached_property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """Shape ``(T, 3)``, counter-clockwise as seen from outside."""
        return self._native.triangles()

    @cached_property
    def colours(self) -> npt.NDArray[np.uint8]:
        """Shape ``(V, 3)``, sRGB."""
        return self._native.colours()

    @cached_property
    def uvs(self) -> npt.NDArray[np.float64]:
        """Shape ``(V, 2)``, in the first image from its top left corner, 0 to 1."""
        return self._native.uvs()

    def to_bytes(self, format: str = "glb", **options: Option) -> bytes:
        """A file of any of the command line's formats that is one file: ``"glb"``, ``"ply"``, ``"stl"`` and so on.

        Options are the command line's, with ``_`` for ``-``: ``material="lit"``, ``eyes="pieces"``, ``texture_size=1024``.
        """
        return self._native.write(f"face.{format}", _words(options))[0][1]

    def save(self, path: Union[str, "os.PathLike[str]"], **options: Option) -> list[Path]:
        """Writes a file, its format told by the end of its name, and those that lie beside it; returns their paths."""
        path = Path(path)
        files = self._native.write(path.name, _words(options))
        paths = [path.with_name(name) for name, _ in files]
        # The file that names the others comes last.
        for place, (_, content) in sorted(zip(paths, files), key=lambda pair: pair[0] == path):
            place.write_bytes(content)
        return paths

    def __getstate__(self) -> dict[str, object]:
        return {"images": self.images, "words": self.words, "search": self.search}


def mesh(
    image: Union[Image, Sequence[Image]],
    edits: Sequence[Edit] = (),
    search: Search = Search(),
    **options: Option,
) -> Mesh:
    """The face in an image, or in several of one head, edited.

    Edits are made in the command line's order: vertices, regions, sliders, expressions, and then symmetry. Options are those
    of ``rosto mesh``, with ``_`` for ``-``: ``density=0``, ``topology="tessellation"``, ``operator="cotangent"``, ``mirror=True``.
    Raises :class:`RostoError` if an image cannot be read or shows no face, or an edit cannot be made.
    """
    images = (image,) if isinstance(image, (str, bytes, os.PathLike, np.ndarray)) else tuple(image)
    words = [word for edit in edits for word in edit.words()]
    finding = [flag for flag in ("mediapipe", "refine") if getattr(search, flag)]
    made = Mesh(images, ("--units", "mm", *(f"--{flag}" for flag in finding), *words, *_words(options)), search)
    # What is wrong is said now, and not when it is looked at first.
    made._native
    return made


def _words(options: Mapping[str, Option]) -> list[str]:
    words: list[str] = []
    for name, value in options.items():
        flag = f"--{name.replace('_', '-')}"
        if isinstance(value, bool):
            words += [flag] if value else []
            continue
        many = value if isinstance(value, Sequence) and not isinstance(value, str) else [value]
        words += [f"{flag}={one}" for one in many]
    return words
