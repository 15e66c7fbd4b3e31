"""What can be done to a face; each knows the command line's words for it."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol


class Edit(Protocol):
    """Anything that can be told to ``rosto mesh``."""

    def words(self) -> list[str]:
        """As options of the command line."""
        ...


def _joined(numbers: Sequence[float]) -> str:
    # The shortest text that is read back as the same number.
    return ",".join(repr(number + 0) for number in numbers)


@dataclass(frozen=True)
class Vertex(Edit):
    """Moves a vertex by an offset in mm; ``level`` 0 is a landmark, higher ones are vertices of denser meshes.

    Without anchors, what stays is chosen as ``anchors`` of :func:`rosto.mesh` says.
    """

    vertex: int
    offset_mm: Sequence[float]
    anchors: Sequence[int] = field(default=())
    level: int = 0

    def words(self) -> list[str]:
        of_level = f"@{self.level}" if self.level else ""
        stays = f":{','.join(map(str, self.anchors))}" if self.anchors else ""
        return ["--edit", f"{self.vertex}{of_level}:{_joined(self.offset_mm)}{stays}"]


@dataclass(frozen=True)
class Region(Edit):
    """Moves a named region, such as ``"nose"``, by an offset in mm."""

    region: str
    offset_mm: Sequence[float]

    def words(self) -> list[str]:
        return ["--region", f"{self.region}:{_joined(self.offset_mm)}"]


@dataclass(frozen=True)
class Slider(Edit):
    """A ready-made slider, such as ``"nose-width"``, by an amount in mm."""

    slider: str
    amount_mm: float

    def words(self) -> list[str]:
        return ["--slider", f"{self.slider}:{_joined([self.amount_mm])}"]


@dataclass(frozen=True)
class Expression(Edit):
    """An expression by ARKit's name, such as ``"jawOpen"``, with a weight from 0 to 1."""

    expression: str
    weight: float

    def words(self) -> list[str]:
        return ["--expression", f"{self.expression}:{_joined([self.weight])}"]


@dataclass(frozen=True)
class Symmetrise(Edit):
    """Makes the face as much its own mirror image as a share from 0 to 1 says."""

    share: float

    def words(self) -> list[str]:
        return ["--symmetrise", _joined([self.share])]
