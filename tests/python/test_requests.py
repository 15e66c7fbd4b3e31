"""Requests of tests/requests.json, described in crates/cli/tests/program/requests.rs: the command line writes the same bytes."""

import json
from pathlib import Path

import pytest
import rosto

TABLE = json.loads((Path(__file__).parents[1] / "requests.json").read_text())
EDITS = {
    "vertex": lambda row: (rosto.Vertex(row["vertex"], row["mm"], level=row["level"]), f"--edit={row['vertex']}@{row['level']}:{joined(row)}"),
    "region": lambda row: (rosto.Region(row["region"], row["mm"]), f"--region={row['region']}:{joined(row)}"),
    "slider": lambda row: (rosto.Slider(row["slider"], row["mm"]), f"--slider={row['slider']}:{row['mm']}"),
    "expression": lambda row: (rosto.Expression(row["expression"], row["weight"]), f"--expression={row['expression']}:{row['weight']}"),
    "symmetrise": lambda row: (rosto.Symmetrise(row["symmetrise"]), f"--symmetrise={row['symmetrise']}"),
}


def joined(row):
    return ",".join(map(str, row["mm"]))


def options(row):
    """The options of a row, as arguments of `rosto.mesh` and as words of the command line."""
    named = {"topology" if name == "triangulation" else name: value for name, value in row.get("mesh", {}).items()}
    named |= {"radius" if name == "radius_mm" else name: value for name, value in row.get("settings", {}).items() if value is not None}
    flags = {("edits", "morph-targets"): "morph_targets", ("expressions", "morph-targets"): "expressions"}
    for option, choice in row["options"].items():
        flag = flags.get((option, choice))
        named |= {flag: True} if flag else {option.replace("-", "_"): choice}
    words = [(f"--{name.replace('_', '-')}", value) for name, value in named.items()]
    return named, [name if value is True else f"{name}={value}" for name, value in words if value is not False]


@pytest.mark.parametrize("row", TABLE, ids=lambda row: row["name"])
def test_files_equal_those_of_the_command_line(portrait, command_line, tmp_path, row):
    made = [EDITS[next(kind for kind in EDITS if kind in edit)](edit) for edit in row["edits"]]
    named, words = options(row)
    name = f"{row['name']}.{row['format']}"
    (tmp_path / "theirs").mkdir()
    command_line("mesh", portrait, "-o", tmp_path / "theirs" / name, *words, *(word for _, word in made))
    ours = rosto.mesh(portrait, [edit for edit, _ in made], **named).save(tmp_path / name)
    assert {path.name for path in ours} == {path.name for path in (tmp_path / "theirs").iterdir()}
    for path in ours:
        assert path.read_bytes() == (tmp_path / "theirs" / path.name).read_bytes(), path.name
