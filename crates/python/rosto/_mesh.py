"""Meshes from photos."""

import os
import reprlib
import textwrap
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from ._edits import Edit
from ._images import Image, contents, decoded, finder, frozen, listed
from ._landmarks import Search
from ._numbers import Number, Plain, plain
from ._rosto import FaceMesh, RostoError

Option = Union[str, Number, bool, np.bool_, Iterable[Union[str, Number]]]


@dataclass(frozen=True, eq=False)
class Mesh:
    """A face mesh from :func:`mesh`. Pickling stores its images, edits and options; unpickling computes it again.

    ``images`` holds copies: bytes of files, or pixels.
    """

    images: tuple[Union[bytes, npt.NDArray[np.uint8]], ...]
    edits: tuple[Edit, ...]
    options: tuple[tuple[str, Plain], ...]
    search: Search

    @cached_property
    def _native(self) -> FaceMesh:
        photos = [decoded(image) for image in self.images]
        thorough = not self.search.mediapipe
        return FaceMesh(photos, finder(self.search.refined), thorough, list(self.edits), list(self.options))

    @cached_property
    def positions_m(self) -> npt.NDArray[np.float64]:
        """Positions in metres, shape ``(V, 3)``: +x to the subject's left, +y up, +z out of the face.

        The first 468 are the landmarks.
        """
        return self._native.positions_m()

    @cached_property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """Triangles, shape ``(T, 3)``, counter-clockwise as seen from outside."""
        return self._native.triangles()

    @cached_property
    def colours(self) -> npt.NDArray[np.uint8]:
        """Vertex colours, shape ``(V, 3)``, sRGB."""
        return self._native.colours()

    @cached_property
    def uvs(self) -> npt.NDArray[np.float64]:
        """Coordinates in the first image, shape ``(V, 2)``, 0 to 1 from its top left corner."""
        return self._native.uvs()

    def to_bytes(self, format: str = "glb", **options: Option) -> bytes:
        """Returns a file in a single-file format of the command line, such as ``"glb"``, ``"ply"`` or ``"stl"``.

        Options are those of the command line, with ``_`` for ``-``: ``material="lit"``, ``eyes="pieces"``,
        ``texture_size=1024``.
        """
        return self._native.write(f"face.{format}", _plain(options))[0][1]

    def save(self, path: Union[str, "os.PathLike[str]"], **options: Option) -> list[Path]:
        """Writes a file in the format of its extension, and its companion files; returns their paths."""
        path = Path(path)
        files = self._native.write(path.name, _plain(options))
        paths = [path.with_name(name) for name, _ in files]
        # The file that refers to the others comes last.
        for place, (_, content) in sorted(zip(paths, files), key=lambda pair: pair[0] == path):
            place.write_bytes(content)
        return paths

    def __repr__(self) -> str:
        parts = [repr(edit) for edit in self.edits[:1]] + [f"{name}={value!r}" for name, value in self.options]
        about = textwrap.shorten(", ".join(parts), 80, placeholder=" …")
        count = len(self.images)
        return f"Mesh({count} image{'' if count == 1 else 's'}, {len(self.edits)} edits: {about})"

    def __getstate__(self) -> dict[str, object]:
        return {name: getattr(self, name) for name in ("images", "edits", "options", "search")}


def mesh(
    image: Union[Image, Iterable[Image]],
    edits: Union[Edit, Iterable[Edit]] = (),
    search: Search = Search(),
    **options: Option,
) -> Mesh:
    """Returns the edited mesh of the face in an image, or in several images of one head.

    Edits apply in the command line's order: vertices, regions, sliders, expressions, symmetry. Options are those of
    ``rosto mesh``, with ``_`` for ``-``: ``density=0``, ``topology="tessellation"``, ``operator="cotangent"``,
    ``mirror=True``. Images are copied, and files are read at once.

    Raises :class:`RostoError` without an image, for an unreadable image or one without a face, and for an impossible
    edit; ``OSError`` if a file cannot be opened; ``TypeError`` for an argument of the wrong type.
    """
    images = tuple(contents(frozen(each)) for each in listed(image))
    if not images:
        raise RostoError("image: the list is empty")
    made = Mesh(images, tuple(sorted(_edits(edits), key=lambda edit: edit.rank)), tuple(_plain(options)), search)
    # Computes the mesh now, so that errors are raised here.
    made._native
    return made


def _edits(edits: Union[Edit, Iterable[Edit]]) -> list[Edit]:
    """Returns a list of edits; a single edit is a list of one."""
    if not isinstance(edits, Iterable):
        edits = [edits]
    listed = list(edits)
    for index, edit in enumerate(listed):
        if not isinstance(edit, Edit):
            raise TypeError(f"edits[{index}]: {reprlib.repr(edit)} is not an edit")
    return listed


def _plain(options: dict[str, Option]) -> list[tuple[str, Plain]]:
    return [(name, plain(name, value)) for name, value in options.items()]
