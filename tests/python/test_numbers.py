"""Accepts NumPy numbers; errors for invalid numbers name the argument."""

import math
from decimal import Decimal

import numpy as np
import pytest
import rosto

FOURS = [4, 4.0, np.float64(4), np.float32(4), np.float16(4), np.int64(4), np.uint8(4), np.array(4), np.array(4.0), Decimal(4)]
OFFSETS = [
    (0, 0, 5),
    [0, 0, 5.0],
    np.array([0, 0, 5.0]),
    np.array([0, 0, 5], np.float32),
    np.array([0, 0, 5], np.int16),
    np.array([5.0, 0, 0])[::-1],
    [np.float64(0), np.int64(0), np.array(5.0)],
]


@pytest.mark.parametrize("four", FOURS, ids=repr)
def test_all_kinds_of_numbers_give_the_same_edit(four):
    assert rosto.Slider("nose-width", four) == rosto.Slider("nose-width", 4)
    assert repr(rosto.Expression("jawOpen", four)) == "Expression(expression='jawOpen', weight=4.0)"
    assert rosto.Symmetrise(four) == rosto.Symmetrise(4)
    vertex = rosto.Vertex(four, (0, 0, 5), anchors=[four], level=four)
    assert repr(vertex) == "Vertex(vertex=4, offset_mm=(0.0, 0.0, 5.0), anchors=(4,), level=4)"
    assert rosto.Vertex(1, (0, 0, 5), anchors=four) == rosto.Vertex(1, (0, 0, 5), anchors=[4])


@pytest.mark.parametrize("offset", OFFSETS, ids=repr)
def test_all_kinds_of_offsets_give_the_same_edit(offset):
    assert rosto.Vertex(1, offset, anchors=np.array([10, 152])) == rosto.Vertex(1, (0.0, 0.0, 5.0), anchors=(10, 152))
    assert rosto.Region("nose", offset) == rosto.Region("nose", (0, 0, 5))


def test_an_edit_copies_its_offset():
    offset = np.array([0, 0, 5.0])
    edit = rosto.Vertex(1, offset)
    offset[:] = 9
    assert edit.offset_mm == (0, 0, 5)


@pytest.mark.parametrize("number", [0.1, -1e-7, 1e22, 2 / 3, np.float32(0.1), -0.0, True, np.bool_(True)], ids=repr)
def test_an_edit_keeps_the_same_number(number):
    assert rosto.Symmetrise(number).share == float(number)


NUMBERS = {
    "amount_mm": lambda number: rosto.Slider("nose-width", number),
    "share": lambda number: rosto.Symmetrise(number),
    r"offset_mm\[1\]": lambda number: rosto.Region("nose", [0, number, 0]),
    r"offset_mm\[2\]": lambda number: rosto.Vertex(1, (0, 0, number)),
}
INDICES = {
    "vertex": lambda index: rosto.Vertex(index, (0, 0, 1)),
    "level": lambda index: rosto.Vertex(1, (0, 0, 1), level=index),
    r"anchors\[1\]": lambda index: rosto.Vertex(1, (0, 0, 1), anchors=[10, index]),
}
COUNTS = {
    "max_faces": lambda count: rosto.Search(max_faces=count),
    "jobs": lambda count: rosto.landmarks([], jobs=count),
}
FLAGS = {
    "mediapipe": lambda flag: rosto.Search(mediapipe=flag),
    "refine": lambda flag: rosto.Search(refine=flag),
}
TYPES = ["4", b"4", None, 4j, np.complex128(4), np.str_("4"), np.array([4.0]), [4], object(), np.datetime64("2020-01-01")]
VALUES = [math.nan, math.inf, -math.inf, np.float32("nan"), np.array(np.inf), 10**400, Decimal("nan")]


@pytest.mark.parametrize(
    ("error", "wrong", "arguments"),
    [
        *((TypeError, wrong, NUMBERS | INDICES) for wrong in TYPES),
        *((rosto.RostoError, wrong, NUMBERS | INDICES) for wrong in VALUES),
        *((rosto.RostoError, wrong, INDICES) for wrong in [1.9, np.float64(0.5), -1, np.int64(-1), 2**32, 2**64, 1e300]),
        # A mask is not a list of indices.
        *((TypeError, wrong, INDICES) for wrong in [True, np.bool_(False), np.array(True)]),
        *((rosto.RostoError, wrong, COUNTS) for wrong in [0, -1, 1.5, math.nan]),
        *((TypeError, wrong, COUNTS) for wrong in [True, "2"]),
        *((TypeError, wrong, FLAGS) for wrong in [1, "no", None]),
    ],
)
def test_errors_name_the_invalid_argument(error, wrong, arguments):
    for name, make in arguments.items():
        with pytest.raises(error, match=name):
            make(wrong)


@pytest.mark.parametrize("wrong", [(0, 1), (0, 0, 1, 1), [], np.zeros((3, 0))[0], 5.0, np.float64(5), np.array(5.0)], ids=repr)
def test_an_offset_has_three_numbers(wrong):
    with pytest.raises(rosto.RostoError, match="offset_mm.*three numbers"):
        rosto.Vertex(1, wrong)


@pytest.mark.parametrize("make", [rosto.Slider, rosto.Expression, lambda name, _: rosto.Region(name, (0, 0, 1))])
def test_names_must_be_text(make):
    for wrong in (None, 4, b"nose", ["nose"]):
        with pytest.raises(TypeError, match="text"):
            make(wrong, 1)


def test_searches_and_options_accept_numpy_flags_and_numbers(portrait):
    search = rosto.Search(mediapipe=np.bool_(True), refine=np.array(False), max_faces=np.int64(2))
    assert search == rosto.Search(mediapipe=True, refine=False, max_faces=2) and hash(search)
    plain = rosto.mesh(portrait, density=0, mirror=True, pin=[10, 152])
    made = rosto.mesh(portrait, density=np.int64(0), mirror=np.bool_(True), pin=np.array([10, 152]))
    assert made.options == plain.options and np.array_equal(made.positions_m, plain.positions_m)
    off = rosto.mesh(portrait, density=np.array(0.0), mirror=np.False_)
    assert off.options == rosto.mesh(portrait, density=0, mirror=False).options


@pytest.mark.parametrize("value", [None, b"0", math.nan, [math.inf], np.zeros((2, 2)), ...], ids=repr)
def test_errors_name_the_invalid_option(portrait, value):
    with pytest.raises((TypeError, rosto.RostoError), match="density"):
        rosto.mesh(portrait, density=value)
