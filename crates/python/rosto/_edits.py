"""Edits of a face."""

import reprlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Union

import numpy.typing as npt

from ._numbers import Number, Vector, number, text, vector, whole, wholes


class Edit:
    """An edit for :func:`rosto.mesh`. NumPy numbers are converted to Python numbers."""

    rank: ClassVar[int]
    """Edits apply in the order of their ranks."""


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

    rank = 0
    vertex: int
    offset_mm: Vector
    anchors: Union[Sequence[int], npt.NDArray[Any], int] = field(default=())
    level: int = 0

    def __post_init__(self) -> None:
        _keep(self, vertex=whole("vertex", self.vertex), level=whole("level", self.level))
        _keep(self, offset_mm=vector("offset_mm", self.offset_mm), anchors=wholes("anchors", self.anchors))

    def __repr__(self) -> str:
        anchors = reprlib.repr(self.anchors)
        return f"Vertex(vertex={self.vertex}, offset_mm={self.offset_mm}, anchors={anchors}, level={self.level})"


@dataclass(frozen=True)
class Region(Edit):
    """Moves a named region, such as ``"nose"``, by an offset in mm."""

    rank = 1
    region: str
    offset_mm: Vector

    def __post_init__(self) -> None:
        _keep(self, region=text("region", self.region), offset_mm=vector("offset_mm", self.offset_mm))



@dataclass(frozen=True)
class Slider(Edit):
    """Moves a slider, such as ``"nose-width"``, by an amount in mm."""

    rank = 2
    slider: str
    amount_mm: Number

    def __post_init__(self) -> None:
        _keep(self, slider=text("slider", self.slider), amount_mm=number("amount_mm", self.amount_mm))



@dataclass(frozen=True)
class Expression(Edit):
    """Applies an ARKit expression, such as ``"jawOpen"``, with a weight from 0 to 1."""

    rank = 3
    expression: str
    weight: Number

    def __post_init__(self) -> None:
        _keep(self, expression=text("expression", self.expression), weight=number("weight", self.weight))



@dataclass(frozen=True)
class Symmetrise(Edit):
    """Makes the face more symmetric, by a share from 0 (unchanged) to 1 (symmetric)."""

    rank = 4
    share: Number

    def __post_init__(self) -> None:
        _keep(self, share=number("share", self.share))
