"""Numbers as people give them, NumPy's among them, to Python's own. Errors name the argument."""

import math
import operator
import reprlib
from collections.abc import Iterable, Sequence
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ._rosto import RostoError

Number = Union[float, "np.number[Any]", "npt.NDArray[Any]"]
"""A number of Python's or NumPy's; an array if it has no axes."""

Vector = Union[Sequence[Number], "npt.NDArray[Any]"]
"""Three numbers."""


def number(name: str, value: object) -> float:
    """A finite number. True and False are 1 and 0, as in Python."""
    plain = _plain(value)
    if not hasattr(plain, "__float__") and not hasattr(plain, "__index__"):
        raise _not(name, value, "a number")
    try:
        found = float(plain)  # type: ignore[arg-type]
    except OverflowError:
        found = math.inf
    except Exception as error:
        raise _not(name, value, "a number") from error
    if not math.isfinite(found):
        raise RostoError(f"{name}: {reprlib.repr(value)} is not finite")
    return found


def whole(name: str, value: object, least: int = 0, most: int = 2**32 - 1) -> int:
    """A whole number in a range. True and False are none: a mask is not a list of indices."""
    plain = _plain(value)
    if isinstance(plain, bool):
        raise _not(name, value, "a whole number")
    found = _as_index(plain)
    if found is None:
        found = number(name, value)
    if found != int(found):
        raise RostoError(f"{name}: {reprlib.repr(value)} is not a whole number")
    if not least <= found <= most:
        raise RostoError(f"{name}: {reprlib.repr(value)} is not in the range {least} to {most}")
    return int(found)


def wholes(name: str, values: object, most: int = 2**32 - 1) -> tuple[int, ...]:
    """Whole numbers, 0 or greater; a single one is a list of one."""
    return tuple(whole(f"{name}[{index}]", value, most=most) for index, value in enumerate(_listed(values)))


def vector(name: str, values: object) -> tuple[float, float, float]:
    """Three finite numbers."""
    listed = _listed(values)
    if len(listed) != 3:
        raise RostoError(f"{name}: {reprlib.repr(values)} is not three numbers")
    x, y, z = (number(f"{name}[{index}]", value) for index, value in enumerate(listed))
    return x, y, z


def flag(name: str, value: object) -> bool:
    """True or False."""
    plain = _plain(value)
    if not isinstance(plain, bool):
        raise _not(name, value, "True or False")
    return plain


def text(name: str, value: object) -> str:
    """A text."""
    if not isinstance(value, str):
        raise _not(name, value, "a text")
    return str.__str__(value)


def is_flag(value: object) -> bool:
    """Whether :func:`flag` takes it."""
    return isinstance(_plain(value), bool)


def shortest(value: float) -> str:
    """The shortest text that is read back as the same number."""
    return repr(value + 0.0).removesuffix(".0")


def coordinates(name: str, values: object) -> npt.NDArray[np.float64]:
    """A read-only copy of finite numbers of the shape (N, 3)."""
    given = _rows(name, values, "iuf")
    with np.errstate(over="ignore"):
        copy = np.array(given, np.float64, order="C")
    infinite = np.flatnonzero(~np.isfinite(copy).all(axis=1))
    if infinite.size:
        raise RostoError(f"{name}: row {infinite[0]} is not finite")
    copy.flags.writeable = False
    return copy


def corners(name: str, values: object, vertex_count: int) -> npt.NDArray[np.uint32]:
    """A read-only copy of vertices, each below ``vertex_count``, of the shape (N, 3)."""
    given = _rows(name, values, "iuf")
    if given.dtype.kind == "f":
        fractions = given[~(given == np.floor(given))]
        if fractions.size:
            raise RostoError(f"{name}: {fractions[0]} is not a whole number")
    outside = given[~((given >= 0) & (given < vertex_count))]
    if outside.size:
        raise RostoError(f"{name}: there is no vertex {outside[0]}: the mesh has {vertex_count}")
    copy = np.array(given, np.uint32, order="C")
    copy.flags.writeable = False
    return copy


def _rows(name: str, values: object, kinds: str) -> npt.NDArray[Any]:
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise RostoError(f"{name}: {error}") from error
    if array.dtype.kind not in kinds:
        raise TypeError(f"{name}: {array.dtype} are not numbers that serve here")
    if array.ndim != 2 or array.shape[1] != 3:
        raise RostoError(f"{name}: the shape is {array.shape}, not (N, 3)")
    return array


def _as_index(value: object) -> Optional[float]:
    try:
        return operator.index(value)  # type: ignore[arg-type]
    except Exception:  # a tensor's own, for numbers that are not whole
        return None


def _listed(values: object) -> Sequence[object]:
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        return [values]
    try:
        return list(values)
    except TypeError:  # an array without axes
        return [values]


def _plain(value: object) -> object:
    """NumPy's numbers as Python's; anything else as it is."""
    if not isinstance(value, (np.generic, np.ndarray)):
        return value
    return value.item() if value.ndim == 0 and value.dtype.kind in "biuf" else None


def _not(name: str, value: object, what: str) -> TypeError:
    return TypeError(f"{name}: {reprlib.repr(value)} is not {what}")
