"""Kinds of images give the same result; invalid images give a reason and do not affect others."""

import array
import io
import mmap
import os
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest
import rosto
from pandas import Series
from PIL import Image

FAST = rosto.Search(mediapipe=True)


@pytest.fixture(scope="module")
def expected(portrait):
    return rosto.landmarks([portrait], FAST).points[0]


def all_found(images) -> np.ndarray:
    found = rosto.landmarks(images, FAST)
    assert found.reasons == [None] * len(found)
    return found.points


class HasPath:
    def __init__(self, path):
        self.path = path

    def __fspath__(self):
        return self.path


def has_array(**behaviour) -> SimpleNamespace:
    return SimpleNamespace(__array__=Mock(**behaviour))


@pytest.mark.parametrize("are_listed", [True, False])
def test_all_kinds_of_images_give_the_same_result_alone_and_in_a_list(portrait, pixels, expected, are_listed):
    file = portrait.read_bytes()
    every_second = np.stack([np.zeros_like(pixels), pixels], -1)[..., 1]
    in_the_middle = io.BytesIO(b"head" + file)
    in_the_middle.seek(4)
    with open(portrait, "rb") as opened, open(portrait, "rb", buffering=0) as raw, Image.open(portrait) as image:
        mapped = mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ)
        kinds = {
            "paths": [str(portrait), portrait, np.str_(portrait), HasPath(str(portrait)), HasPath(os.fsencode(portrait))],
            "bytes": [file, bytearray(file), memoryview(file), memoryview(file * 2)[: len(file)], array.array("B", file), mapped],
            "files": [opened, raw, io.BytesIO(file), in_the_middle],
            "pixels": [pixels, pixels.copy(), np.asfortranarray(pixels), pixels[::-1].copy()[::-1], every_second],
            "with an array": [has_array(return_value=pixels)],
            "Pillow": [image, image.convert("RGBA"), image.convert("RGB")],
        }
        for kind, images in kinds.items():
            found = [all_found(images)] if are_listed else [all_found(image) for image in images]
            assert np.array_equal(np.concatenate(found), [expected] * len(images)), kind


def test_grey_and_alpha_arrays_equal_files(pixels, tmp_path):
    grey = np.asarray(Image.fromarray(pixels).convert("L"))
    alpha = np.linspace(0, 255, pixels.shape[0] * pixels.shape[1]).astype(np.uint8).reshape(pixels.shape[:2])
    for name, drawn in {"grey": grey, "alpha": np.dstack([pixels, alpha])}.items():
        path = tmp_path / f"{name}.png"
        Image.fromarray(drawn).save(path)
        with Image.open(path) as image:
            of_file, *others = all_found([path, drawn, drawn if drawn.ndim == 3 else drawn[..., None], image])
        assert all(np.array_equal(points, of_file) for points in [*others, *all_found(drawn)]), name


@pytest.mark.parametrize("orientation", range(1, 9))
def test_applies_the_exif_orientation_of_pillow_images(pixels, tmp_path, orientation):
    exif = Image.Exif()
    exif[0x0112] = orientation
    path = tmp_path / "turned.png"
    Image.fromarray(pixels[:, 40:]).save(path, exif=exif)
    with Image.open(path) as image:
        of_file, of_image = all_found([path, image])
        assert rosto.landmarks(image, FAST).sizes.tolist() == rosto.landmarks(path, FAST).sizes.tolist()
    assert np.array_equal(of_image, of_file)


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGB", "RGBA", "CMYK", "YCbCr", "HSV", "LAB", "PA", "La", "RGBa", "RGBX"])
def test_reads_pillow_images_of_all_8_bit_modes(mode):
    image = Image.new("RGB", (40, 30), (200, 30, 60))
    for step in {"PA": ["P", "PA"], "La": ["LA", "La"], "RGBa": ["RGBA", "RGBa"]}.get(mode, [mode]):
        image = image.convert(step)
    found = rosto.landmarks([image], FAST)
    assert found.sizes.tolist() == [[30, 40]] and found.reasons == ["no face found"]


def test_reads_a_pillow_image_larger_than_the_file_limit():
    large = Image.fromarray(np.random.default_rng(0).integers(0, 256, (4000, 4000, 3), np.uint8))
    assert rosto.landmarks(large, FAST).sizes.tolist() == [[4000, 4000]]


class RaisesAnything(Exception):
    def __str__(self):
        raise ValueError


@pytest.fixture
def bad(portrait, tmp_path) -> dict[str, tuple[object, str]]:
    """Invalid images and images without a face, each with a part of the reason."""
    pipe = tmp_path / "pipe.jpg"
    os.mkfifo(pipe)
    closed, closed_image, released = open(portrait, "rb"), Image.open(portrait), memoryview(b"photo")
    closed.close()
    closed_image.close()
    released.release()
    return {
        "None": (None, "None is not an image"),
        "an int": (0, "0 is not an image"),
        "a float": (np.float64(4), "float64 ()"),
        "a list": ([1, 2], "[1, 2] is not an image"),
        "an object": (object(), "is not an image"),
        "a NUL": ("photo\0.jpg", "null"),
        "a NUL in a Path": (Path("photo\0.jpg"), "null"),
        "an empty path": ("", "No such file"),
        "a missing file": (tmp_path / "missing.jpg", "missing.jpg"),
        "a long name": ("x" * 100_000, "File name too long"),
        "a name that is not UTF-8": (os.fsencode(tmp_path).decode() + "/\udcff.jpg", "\\udcff.jpg"),
        "a path that is not text": (HasPath(4), "__fspath__"),
        "a folder": (tmp_path, "not a file"),
        "a pipe": (pipe, "not a file"),
        "a device": ("/dev/zero", "not a file"),
        "a closed file": (closed, "closed file"),
        "a text file": (open(portrait, encoding="latin-1"), "binary mode"),
        "a file that returns None": (SimpleNamespace(read=Mock(return_value=None)), "NoneType, not bytes"),
        "an endless file": (SimpleNamespace(read=Mock(return_value=b"x" * 1_000_000)), "limit is 40000000"),
        "an empty file": (io.BytesIO(), "not a picture"),
        "text": (b"plain text", "not a picture"),
        "many bytes": (bytearray(40_000_001), "limit is 40000000"),
        "a truncated file": (portrait.read_bytes()[:2000], "damaged"),
        "numbers": (np.zeros((4, 4, 3)), "float64 (4, 4, 3)"),
        "two channels": (np.zeros((4, 4, 2), np.uint8), "uint8 (4, 4, 2)"),
        "channels first": (np.zeros((3, 40, 40), np.uint8), "uint8 (3, 40, 40)"),
        "one axis": (np.zeros(4, np.uint8), "uint8 (4,)"),
        "no axes": (np.uint8(4), "uint8 ()"),
        "no rows": (np.zeros((0, 5, 3), np.uint8), "5×0"),
        "no columns": (np.zeros((5, 0), np.uint8)[::-1], "0×5"),
        "a huge array": (np.broadcast_to(np.uint8(9), (2**20, 2**20, 3)), "1048576×1048576"),
        "a side of 2³²": (np.broadcast_to(np.uint8(9), (2**32 + 1, 1, 3)), "megapixels"),
        "objects": (np.array([[None]]), "object"),
        "__array__ raises": (has_array(side_effect=RuntimeError("planted")), "planted"),
        "__array__ raises badly": (has_array(side_effect=RaisesAnything), "RaisesAnything"),
        "a released view": (released, "released"),
        "a mode without a white level": (Image.new("F", (9, 9)), "mode F"),
        "a closed image": (closed_image, "closed"),
        "no face": (np.full((64, 64, 3), 120, np.uint8), "no face"),
    }


@pytest.mark.parametrize("jobs", [1, 2])
def test_bad_images_give_a_reason_and_do_not_affect_others(portrait, expected, bad, jobs):
    found = rosto.landmarks([portrait, *(image for image, _ in bad.values()), portrait], FAST, jobs=jobs)
    assert [found.reasons[0], found.reasons[-1]] == [None, None]
    for (name, (_, word)), reason in zip(bad.items(), found.reasons[1:]):
        assert word in reason and len(reason) <= 500, f"{name}: {reason}"
    assert np.isnan(found.points[1:-1]).all() and np.isnan(found.confidence).tolist() == [False, *[True] * len(bad), False]
    assert np.array_equal(found.points[0], expected) and np.array_equal(found.points[-1], expected)
    assert found.to_arrow()["reason"].to_pylist() == found.reasons


BROKEN = has_array(side_effect=RuntimeError)


@pytest.mark.parametrize("image", [None, 4, [], ["photo.jpg"], np.zeros((4, 4, 3)), "photo\0.jpg", object(), b"", BROKEN])
def test_a_single_bad_image_raises(image):
    for work in (rosto.faces, lambda image: rosto.mesh([image])):
        with pytest.raises((rosto.RostoError, RuntimeError)):
            work(image)


def test_accepts_arrays_and_table_columns_of_images(portrait, pixels, expected):
    path, of_bytes = str(portrait), np.empty(2, object)
    of_bytes[:] = [portrait.read_bytes()] * 2
    for many in [np.stack([pixels] * 2), np.array([path] * 2), np.array([portrait] * 2, object), of_bytes, Series([path] * 2)]:
        assert np.array_equal(all_found(many), [expected] * 2)
    assert len(rosto.landmarks(np.array(path), FAST)) == 1
    assert len(rosto.landmarks(np.zeros((0, 4, 4, 3), np.uint8))) == len(rosto.landmarks([])) == 0
    assert rosto.landmarks([]).to_arrow().num_rows == 0


@pytest.mark.parametrize("wrong", [None, 4, 4.5, ..., True], ids=repr)
def test_other_types_raise_a_type_error(wrong):
    for work in (rosto.landmarks, rosto.mesh):
        with pytest.raises(TypeError, match="neither an image nor a list"):
            work(wrong)
