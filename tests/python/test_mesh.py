"""Meshes: equality with the command line's files, arrays, pickling and errors."""

import io
import pickle
import shutil
from pathlib import Path

import numpy as np
import pytest
import rosto

EDITS = [
    ([rosto.Vertex(1, (0, 0, 5))], ["--edit", "1:0,0,5"]),
    ([rosto.Vertex(4, (-0.1, 1e-3, 2 / 3), anchors=[10, 152])], ["--edit", f"4:-0.1,0.001,{2 / 3!r}:10,152"]),
    (
        [rosto.Region("left-brow", (0, 2, 0)), rosto.Slider("nose-width", -4), rosto.Symmetrise(0.5)],
        ["--region", "left-brow:0,2,0", "--slider", "nose-width:-4", "--symmetrise", "0.5"],
    ),
    ([rosto.Expression("jawOpen", 0.6)], ["--expression", "jawOpen:0.6"]),
]


@pytest.mark.parametrize(("edits", "flags"), EDITS)
def test_files_equal_those_of_the_command_line(portrait, command_line, tmp_path, edits, flags):
    made = rosto.mesh(portrait, edits)
    for name in ["face.glb", "face.obj", "face.json"]:
        theirs = tmp_path / f"theirs-{name}"
        theirs.mkdir()
        command_line("mesh", portrait, "-o", theirs / name, *flags)
        ours = made.save(tmp_path / name)
        assert {path.name for path in ours} == {path.name for path in theirs.iterdir()}
        assert all(path.read_bytes() == (theirs / path.name).read_bytes() for path in ours)


def test_accepts_the_command_lines_options(portrait, command_line, tmp_path):
    flags = ["--density", "0", "--topology", "tessellation", "--material", "unlit", "--base-colour", "photo"]
    command_line("mesh", portrait, "-o", tmp_path / "face.glb", *flags)
    made = rosto.mesh(portrait, density=0, topology="tessellation").to_bytes("glb", material="unlit", base_colour="photo")
    assert made == (tmp_path / "face.glb").read_bytes()


def test_a_card_measures_the_face_as_on_the_command_line(portrait, command_line, tmp_path):
    corners = "150,230 290,230 290,318 150,318"
    command_line("mesh", portrait, "-o", tmp_path / "face.json", "--card-px", corners)
    assert rosto.mesh(portrait, card_px=corners).to_bytes("json") == (tmp_path / "face.json").read_bytes()


def test_arrays_are_consistent_and_the_landmark_moves_by_its_offset(portrait):
    rest, moved = rosto.mesh(portrait), rosto.mesh(portrait, [rosto.Vertex(1, (0, 0, 5))], constraint="exact")
    assert rest.positions_m.shape == (7257, 3) and rest.colours.shape == (7257, 3) and rest.uvs.shape == (7257, 2)
    assert rest.triangles.min() == 0 and rest.triangles.max() == 7256
    assert np.allclose(moved.positions_m[1] - rest.positions_m[1], [0, 0, 0.005], atol=1e-12)
    corners = rest.positions_m[rest.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (normals[:, 2] > 0).mean() > 0.8, "triangles face outward"


def test_a_mesh_and_its_pickle_keep_copies_of_the_images(portrait, pixels, tmp_path):
    buffer, seen, drawn = bytearray(portrait.read_bytes()), np.fromfile(portrait, np.uint8), pixels.copy()
    path, file = Path(shutil.copy(portrait, tmp_path)), io.BytesIO(buffer)
    for image, change in [
        (buffer, buffer.clear),
        (memoryview(seen), lambda: seen.fill(0)),
        (drawn, lambda: drawn.fill(0)),
        (path, path.unlink),
        (file, file.close),
    ]:
        made = rosto.mesh(image, [rosto.Slider("nose-width", 4)], density=0)
        pickled_first = pickle.dumps(made)
        change()
        for again in (pickle.loads(pickled_first), pickle.loads(pickle.dumps(made))):
            assert np.array_equal(again.positions_m, made.positions_m) and np.array_equal(again.colours, made.colours)
            assert again.to_bytes("ply") == made.to_bytes("ply")


def test_accepts_a_single_edit(portrait):
    edit = rosto.Slider("nose-width", 4)
    assert rosto.mesh(portrait, edit, density=0).edits == rosto.mesh(portrait, iter([edit]), density=0).edits


@pytest.mark.parametrize("wrong", [None, 4, "nose-width", [None], [rosto.Slider("nose-width", 4), ("nose-width", 4)]], ids=repr)
def test_an_invalid_edit_raises_a_type_error(portrait, wrong):
    with pytest.raises(TypeError, match=r"edits\[\d\]: .* is not an edit"):
        rosto.mesh(portrait, wrong)


@pytest.mark.parametrize("none", [[], (), iter([]), np.zeros((0, 4, 4, 3), np.uint8), np.array([], object)])
def test_refuses_an_empty_list_of_images(none):
    with pytest.raises(rosto.RostoError, match="image: the list is empty"):
        rosto.mesh(none)


def test_several_images_of_one_head_give_one_face(portrait, pixels):
    alone, of_list, of_array = (rosto.mesh(image, density=0) for image in (pixels, [portrait] * 2, np.stack([pixels] * 2)))
    assert (len(alone.images), len(of_list.images), len(of_array.images)) == (1, 2, 2)
    assert alone.positions_m.shape == of_list.positions_m.shape == of_array.positions_m.shape


@pytest.mark.parametrize(
    ("work", "words"),
    [
        (lambda photo: rosto.mesh(photo, [rosto.Slider("ear", 4)]), ["unknown slider", '"ear"', "nose-width"]),
        (lambda photo: rosto.mesh(photo, [rosto.Vertex(9999, (0, 0, 1))]), ["edit 1", "9999", "0 to 467"]),
        (lambda photo: rosto.mesh(photo, colour="red"), ["colour", "rosto mesh --help"]),
        (lambda photo: rosto.mesh(photo).to_bytes("doc"), [".doc", ".glb"]),
        (lambda photo: rosto.mesh(photo).to_bytes("ply", material="lit"), ["material has no effect", ".glb and .gltf"]),
        (lambda photo: rosto.mesh(photo, units="image"), ["image coordinates", '"mm"']),
        (lambda photo: rosto.mesh(photo).to_bytes("json", units="image"), ["image coordinates", '"mm"']),
        (lambda photo: rosto.mesh(np.zeros((64, 64, 3), np.uint8)), ["no face", "tenth of the picture"]),
        (lambda photo: rosto.mesh(b"plain text"), ["not a picture"]),
        (lambda photo: rosto.mesh(photo, card_px="1,2 3,4"), ["four corners in px"]),
        (lambda photo: rosto.mesh([photo] * 2, card_px="150,230 290,230 290,318 150,318"), ["a card is in one photo"]),
        (lambda photo: rosto.mesh([photo] * 6), ["6 photos of one face; give 1 to 5"]),
    ],
)
def test_errors_state_the_cause_and_a_remedy(portrait, work, words):
    with pytest.raises(rosto.RostoError) as error:
        work(portrait)
    assert all(word in str(error.value) for word in words), error.value
