"""Edits of a face, each with its command-line options."""

import reprlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol, Union

import numpy.typing as npt

from ._numbers import Number, Vector, number, shortest, text, vector, whole, wholes


class Edit(Protocol):
    """An edit for :func:`rosto.mesh`. NumPy numbers are converted to Python numbers."""

    def words(self) -> list[str]:
        """Returns the edit as command-line options."""
        ...


def _joined(*numbers: Any) -> str:
    return ",".join(map(shortest, numbers))


def _keep(edit: Edit, **values: object) -> None:
    """Sets fields of a frozen dataclass."""
    for name, value in values.items():
        object.__setattr__(edit, name, value)


@dataclass(frozen=True)
class Vertex(Edit):
    """Moves a vertex by an offset in mm.

    ``level`` is the subdivision level of the vertex; level 0 has the landmarks. Without ``anchors``, the option
    ``anchors`` of :func:`rosto.mesh` selects the vertices that stay.
    """

    vertex: int
    offset_mm: Vector
    anchors: Union[Sequence[int], npt.NDArray[Any], int] = field(default=())
    level: int = 0

    def __post_init__(self) -> None:
        _keep(self, vertex=whole("vertex", self.vertex), level=whole("level", self.level))
        _keep(self, offset_mm=vector("offset_mm", self.offset_mm), anchors=wholes("anchors", self.anchors))

    def words(self) -> list[str]:
        of_level = f"@{self.level}" if self.level else ""
        anchors = wholes("anchors", self.anchors)
        stays = f":{','.join(map(str, anchors))}" if anchors else ""
        return ["--edit", f"{self.vertex}{of_level}:{_joined(*self.offset_mm)}{stays}"]

    def __repr__(self) -> str:
        anchors = reprlib.repr(self.anchors)
        return f"Vertex(vertex={self.vertex}, offset_mm={self.offset_mm}, anchors={anchors}, level={self.level})"


@dataclass(frozen=True)
class Region(Edit):
    """Moves a named region, such as ``"nose"``, by an offset in mm."""

    region: str
    offset_mm: Vector

    def __post_init__(self) -> None:
        _keep(self, region=text("region", self.region), offset_mm=vector("offset_mm", self.offset_mm))

    def words(self) -> list[str]:
        return ["--region", f"{self.region}:{_joined(*self.offset_mm)}"]


@dataclass(frozen=True)
class Slider(Edit):
    """Moves a slider, such as ``"nose-width"``, by an amount in mm."""

    slider: str
    amount_mm: Number

    def __post_init__(self) -> None:
        _keep(self, slider=text("slider", self.slider), amount_mm=number("amount_mm", self.amount_mm))

    def words(self) -> list[str]:
        return ["--slider", f"{self.slider}:{_joined(self.amount_mm)}"]


@dataclass(frozen=True)
class Expression(Edit):
    """Applies an ARKit expression, such as ``"jawOpen"``, with a weight from 0 to 1."""

    expression: str
    weight: Number

    def __post_init__(self) -> None:
        _keep(self, expression=text("expression", self.expression), weight=number("weight", self.weight))

    def words(self) -> list[str]:
        return ["--expression", f"{self.expression}:{_joined(self.weight)}"]


@dataclass(frozen=True)
class Symmetrise(Edit):
    """Makes the face more symmetric, by a share from 0 (unchanged) to 1 (symmetric)."""

    share: Number

    def __post_init__(self) -> None:
        _keep(self, share=number("share", self.share))

    def words(self) -> list[str]:
        return ["--symmetrise", _joined(self.share)]
