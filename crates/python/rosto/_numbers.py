"""Conversion of Python and NumPy numbers. Errors name the argument."""

import math
import operator
import reprlib
from collections.abc import Iterable, Sequence
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ._rosto import RostoError

Number = Union[float, "np.number[Any]", "npt.NDArray[Any]"]
"""A Python or NumPy number, or a 0D array."""

Vector = Union[Sequence[Number], "npt.NDArray[Any]"]
"""Three numbers."""

Plain = Union[bool, int, float, str, list[Union[int, float, str]]]
"""The value of an option."""


def number(name: str, value: object) -> float:
    """Converts to a finite float. True and False are 1 and 0, as in Python."""
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
    """Converts to an integer in a range. Rejects booleans, because a mask is not a list of indices."""
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
    """Converts to non-negative integers; a single number is a list of one."""
    return tuple(whole(f"{name}[{index}]", value, most=most) for index, value in enumerate(_listed(values)))


def vector(name: str, values: object) -> tuple[float, float, float]:
    """Converts to three finite floats."""
    listed = _listed(values)
    if len(listed) != 3:
        raise RostoError(f"{name}: {reprlib.repr(values)} is not three numbers")
    x, y, z = (number(f"{name}[{index}]", value) for index, value in enumerate(listed))
    return x, y, z


def flag(name: str, value: object) -> bool:
    """Converts to a bool."""
    plain = _plain(value)
    if not isinstance(plain, bool):
        raise _not(name, value, "True or False")
    return plain


def text(name: str, value: object) -> str:
    """Converts to a plain ``str``."""
    if not isinstance(value, str):
        raise _not(name, value, "a text")
    return str.__str__(value)


def plain(name: str, value: object) -> Plain:
    """Converts the value of an option to plain Python values."""
    if isinstance(value, str):
        return text(name, value)
    found = _plain(value)
    if isinstance(found, (bool, int)):
        return found
    if isinstance(value, Iterable) and not isinstance(value, bytes) and getattr(value, "ndim", 1) != 0:
        return [text(name, each) if isinstance(each, str) else _number(name, each) for each in value]
    return _number(name, value)


def _number(name: str, value: object) -> Union[int, float]:
    found = _plain(value)
    return found if isinstance(found, int) else number(name, value)


def coordinates(name: str, values: object) -> npt.NDArray[np.float64]:
    """Returns a read-only float64 copy of finite numbers, shape (N, 3)."""
    given = _rows(name, values, "iuf")
    with np.errstate(over="ignore"):
        copy = np.array(given, np.float64, order="C")
    infinite = np.flatnonzero(~np.isfinite(copy).all(axis=1))
    if infinite.size:
        raise RostoError(f"{name}: row {infinite[0]} is not finite")
    copy.flags.writeable = False
    return copy


def corners(name: str, values: object, vertex_count: int) -> npt.NDArray[np.uint32]:
    """Returns a read-only uint32 copy of indices below ``vertex_count``, shape (N, 3)."""
    given = _rows(name, values, "iuf")
    if given.dtype.kind == "f":
        fractions = given[~(given == np.floor(given))]
        if fractions.size:
            raise RostoError(f"{name}: {fractions[0]} is not a whole number")
    outside = given[~((given >= 0) & (given < vertex_count))]
    if outside.size:
        raise RostoError(f"{name}: no vertex {outside[0]}; the mesh has {vertex_count} vertices")
    copy = np.array(given, np.uint32, order="C")
    copy.flags.writeable = False
    return copy


def _rows(name: str, values: object, kinds: str) -> npt.NDArray[Any]:
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise RostoError(f"{name}: {error}") from error
    if array.dtype.kind not in kinds:
        raise TypeError(f"{name}: dtype {array.dtype} is not numeric")
    if array.ndim != 2 or array.shape[1] != 3:
        raise RostoError(f"{name}: the shape is {array.shape}, not (N, 3)")
    return array


def _as_index(value: object) -> Optional[float]:
    try:
        return operator.index(value)  # type: ignore[arg-type]
    except Exception:  # tensors raise their own errors
        return None


def _listed(values: object) -> Sequence[object]:
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        return [values]
    try:
        return list(values)
    except TypeError:  # 0D array
        return [values]


def _plain(value: object) -> object:
    """Converts NumPy numbers to Python numbers; returns other values unchanged."""
    if not isinstance(value, (np.generic, np.ndarray)):
        return value
    return value.item() if value.ndim == 0 and value.dtype.kind in "biuf" else None


def _not(name: str, value: object, what: str) -> TypeError:
    return TypeError(f"{name}: {reprlib.repr(value)} is not {what}")
