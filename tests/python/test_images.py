"""Whatever an image comes as, it is the same image; what is none has a reason and stops no other."""

import array
import io
import mmap
import os
from pathlib import Path

import numpy as np
import pytest
import rosto
from PIL import Image

ONE_LOOK = rosto.Search(mediapipe=True)


@pytest.fixture(scope="module")
def pixels(portrait):
    with Image.open(portrait) as opened:
        return np.asarray(opened.convert("RGB"))


@pytest.fixture(scope="module")
def expected(portrait):
    return rosto.landmarks([portrait], ONE_LOOK).points[0]


def all_found(images) -> np.ndarray:
    found = rosto.landmarks(images, ONE_LOOK)
    assert found.reasons == [None] * len(found)
    return found.points


class HasPath:
    def __init__(self, path):
        self.path = path

    def __fspath__(self):
        return self.path


class HasArray:
    def __init__(self, pixels):
        self.pixels = pixels

    def __array__(self, dtype=None, copy=None):
        return self.pixels


def unaligned(pixels: np.ndarray) -> np.ndarray:
    """The same in every second byte of another array."""
    wide = np.zeros((*pixels.shape, 2), np.uint8)
    wide[..., 1] = pixels
    return wide[..., 1]


def test_every_kind_of_image_is_the_same_image(portrait, pixels, expected):
    file = portrait.read_bytes()
    read_only = pixels.copy()
    read_only.flags.writeable = False
    with open(portrait, "rb") as opened, open(portrait, "rb", buffering=0) as raw, Image.open(portrait) as image:
        mapped = mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ)
        kinds = {
            "paths": [str(portrait), portrait, np.str_(portrait), HasPath(str(portrait)), HasPath(os.fsencode(portrait))],
            "bytes": [file, bytearray(file), memoryview(file), memoryview(file * 2)[: len(file)], array.array("B", file), mapped],
            "files": [opened, raw, io.BytesIO(file)],
            "pixels": [pixels, read_only, np.asfortranarray(pixels), pixels[::-1][::-1], unaligned(pixels), HasArray(pixels)],
            "Pillow": [image, image.convert("RGBA"), image.convert("RGB")],
        }
        assert isinstance(image, Image.Image)
        for kind, images in kinds.items():
            assert all(np.array_equal(points, expected) for points in all_found(images)), kind


def test_a_file_is_read_from_where_it_is(portrait, expected):
    file = io.BytesIO(b"head" + portrait.read_bytes())
    file.seek(4)
    assert np.array_equal(all_found([file])[0], expected)


def test_grey_and_alpha_are_as_in_a_file(pixels, tmp_path):
    grey = np.asarray(Image.fromarray(pixels).convert("L"))
    alpha = np.linspace(0, 255, pixels.shape[0] * pixels.shape[1]).astype(np.uint8).reshape(pixels.shape[:2])
    for name, drawn in {"grey": grey, "alpha": np.dstack([pixels, alpha])}.items():
        path = tmp_path / f"{name}.png"
        Image.fromarray(drawn).save(path)
        with Image.open(path) as image:
            of_file, *others = all_found([path, drawn, drawn if drawn.ndim == 3 else drawn[..., None], image])
        assert all(np.array_equal(points, of_file) for points in others), name


@pytest.mark.parametrize("orientation", range(1, 9))
def test_a_pillow_image_is_turned_as_its_file_is(pixels, tmp_path, orientation):
    exif = Image.Exif()
    exif[0x0112] = orientation
    path = tmp_path / "turned.png"
    Image.fromarray(pixels[:, 40:]).save(path, exif=exif)
    with Image.open(path) as image:
        of_file, of_image = all_found([path, image])
        assert rosto.landmarks(image, ONE_LOOK).sizes.tolist() == rosto.landmarks(path, ONE_LOOK).sizes.tolist()
    assert np.array_equal(of_image, of_file)


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGB", "RGBA", "CMYK", "YCbCr", "HSV", "LAB", "PA", "La", "RGBa", "RGBX"])
def test_pillow_images_of_any_mode_with_8_bits_are_read(mode):
    image = Image.new("RGB", (40, 30), (200, 30, 60))
    for step in {"PA": ["P", "PA"], "La": ["LA", "La"], "RGBa": ["RGBA", "RGBa"]}.get(mode, [mode]):
        image = image.convert(step)
    found = rosto.landmarks([image], ONE_LOOK)
    assert found.sizes.tolist() == [[30, 40]] and found.reasons == ["no face found"]


def test_a_pillow_image_larger_than_a_file_may_be_is_read():
    large = Image.fromarray(np.random.default_rng(0).integers(0, 256, (4000, 4000, 3), np.uint8))
    assert rosto.landmarks(large, ONE_LOOK).sizes.tolist() == [[4000, 4000]]


class Raises:
    def __array__(self, dtype=None, copy=None):
        raise RuntimeError("no pixels today")


class RaisesAnything(Exception):
    def __str__(self):
        raise ValueError


class RaisesBadly:
    def __array__(self, dtype=None, copy=None):
        raise RaisesAnything


class Reads:
    def __init__(self, part):
        self.part = part

    def read(self, size=-1):
        return self.part


def closed(path: Path):
    file = open(path, "rb")
    file.close()
    return file


def pipe(path: Path) -> Path:
    os.mkfifo(path)
    return path


def closed_image(path: Path) -> Image.Image:
    image = Image.open(path)
    image.close()
    return image


BAD = {
    "None": lambda *_: (None, "None is not an image"),
    "an int": lambda *_: (0, "0 is not an image"),
    "a float": lambda *_: (np.float64(4), "float64 ()"),
    "a list": lambda *_: ([1, 2], "[1, 2] is not an image"),
    "an object": lambda *_: (object(), "is not an image"),
    "a NUL": lambda *_: ("photo\0.jpg", "null"),
    "a NUL in a Path": lambda *_: (Path("photo\0.jpg"), "null"),
    "no path": lambda *_: ("", "No such file"),
    "no file": lambda _, folder: (folder / "missing.jpg", "missing.jpg"),
    "a long name": lambda *_: ("x" * 100_000, "File name too long"),
    "a name that is not UTF-8": lambda _, folder: (os.fsencode(folder).decode() + "/\udcff.jpg", "\\udcff.jpg"),
    "a path of no text": lambda *_: (HasPath(4), "__fspath__"),
    "a folder": lambda _, folder: (folder, "not a file"),
    "a pipe": lambda _, folder: (pipe(folder / "pipe.jpg"), "not a file"),
    "a device": lambda *_: ("/dev/zero", "not a file"),
    "a closed file": lambda portrait, _: (closed(portrait), "closed file"),
    "a text file": lambda portrait, _: (open(portrait, encoding="latin-1"), "binary mode"),
    "a file that gives nothing": lambda *_: (Reads(None), "NoneType, not bytes"),
    "a file without an end": lambda *_: (Reads(b"x" * 1_000_000), "limit is 40000000"),
    "an empty file": lambda *_: (io.BytesIO(), "not a picture"),
    "notes": lambda *_: (b"these are notes", "not a picture"),
    "many bytes": lambda *_: (bytearray(40_000_001), "limit is 40000000"),
    "a cut file": lambda portrait, _: (portrait.read_bytes()[:2000], "damaged"),
    "numbers": lambda *_: (np.zeros((4, 4, 3)), "float64 (4, 4, 3)"),
    "two channels": lambda *_: (np.zeros((4, 4, 2), np.uint8), "uint8 (4, 4, 2)"),
    "channels first": lambda *_: (np.zeros((3, 40, 40), np.uint8), "uint8 (3, 40, 40)"),
    "one axis": lambda *_: (np.zeros(4, np.uint8), "uint8 (4,)"),
    "no axes": lambda *_: (np.uint8(4), "uint8 ()"),
    "no rows": lambda *_: (np.zeros((0, 5, 3), np.uint8), "5×0"),
    "no columns": lambda *_: (np.zeros((5, 0), np.uint8)[::-1], "0×5"),
    "a huge array": lambda *_: (np.broadcast_to(np.uint8(9), (2**20, 2**20, 3)), "1048576×1048576"),
    "a side of 2³²": lambda *_: (np.broadcast_to(np.uint8(9), (2**32 + 1, 1, 3)), "megapixels"),
    "objects": lambda *_: (np.array([[None]]), "object"),
    "__array__ raises": lambda *_: (Raises(), "no pixels today"),
    "__array__ raises badly": lambda *_: (RaisesBadly(), "RaisesAnything"),
    "a released view": lambda *_: (released(), "released"),
    "a mode without a white": lambda *_: (Image.new("F", (9, 9)), "mode F"),
    "a closed image": lambda portrait, _: (closed_image(portrait), "closed"),
}


def released() -> memoryview:
    view = memoryview(b"photo")
    view.release()
    return view


@pytest.mark.parametrize("jobs", [1, 2])
def test_what_is_no_image_has_a_reason_and_stops_no_other(portrait, expected, tmp_path, jobs):
    made = [make(portrait, tmp_path / f"{number}") for number, make in enumerate(BAD.values()) if (tmp_path / f"{number}").mkdir() is None]
    images = [portrait, *(image for image, _ in made), portrait]
    found = rosto.landmarks(images, ONE_LOOK, jobs=jobs)
    assert [found.reasons[0], found.reasons[-1]] == [None, None]
    for name, (_, word), reason, points in zip(BAD, made, found.reasons[1:], found.points[1:]):
        assert word in reason and len(reason) <= 500, f"{name}: {reason}"
        assert np.isnan(points).all(), name
    assert np.array_equal(found.points[0], expected) and np.array_equal(found.points[-1], expected)
    assert found.to_arrow()["reason"].to_pylist() == found.reasons


@pytest.mark.parametrize("image", [None, 4, [], np.zeros((4, 4, 3)), "photo\0.jpg", object(), b"", Raises()], ids=repr)
def test_one_image_that_is_none_raises(image):
    for work in (rosto.faces, lambda image: rosto.mesh([image])):
        with pytest.raises((rosto.RostoError, RuntimeError)):
            work(image)


def test_a_single_image_is_a_list_of_one(portrait, pixels, expected):
    file = portrait.read_bytes()
    with open(portrait, "rb") as opened, Image.open(portrait) as image:
        for one in [str(portrait), portrait, file, bytearray(file), memoryview(file), opened, pixels, image, HasArray(pixels)]:
            points = all_found(one)
            assert points.shape == (1, 468, 3) and np.array_equal(points[0], expected)
    assert len(rosto.landmarks(pixels[..., 0], ONE_LOOK)) == 1, "grey"


def test_an_array_of_images_is_a_list(portrait, pixels, expected):
    file = portrait.read_bytes()
    of_bytes = np.empty(2, object)
    of_bytes[:] = [file, file]
    for many in [np.stack([pixels, pixels]), np.array([str(portrait)] * 2), np.array([portrait] * 2, object), of_bytes]:
        assert all(np.array_equal(points, expected) for points in all_found(many)) and len(many) == 2
    assert len(rosto.landmarks(np.array(str(portrait)), ONE_LOOK)) == 1
    assert len(rosto.landmarks(np.zeros((0, 4, 4, 3), np.uint8))) == len(rosto.landmarks([])) == 0
    assert rosto.landmarks([]).to_arrow().num_rows == 0


def test_a_table_column_of_paths_is_a_list(portrait):
    pandas = pytest.importorskip("pandas")
    assert len(all_found(pandas.Series([str(portrait)] * 2))) == 2


@pytest.mark.parametrize("wrong", [None, 4, 4.5, object(), True], ids=repr)
def test_what_is_neither_an_image_nor_a_list_is_a_type_error(wrong):
    for work in (rosto.landmarks, rosto.mesh):
        with pytest.raises(TypeError, match="neither an image nor a list"):
            work(wrong)


def test_an_image_of_several_is_not_a_list_for_one_that_is_asked_for(portrait):
    with pytest.raises(rosto.RostoError, match="not an image"):
        rosto.faces([portrait])
