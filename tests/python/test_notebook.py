"""The notebook runs, and shows what it is kept with."""

import copy
import sys
from pathlib import Path

import nbformat

NOTEBOOKS = Path(__file__).parents[2] / "crates/python/notebook"
sys.path.insert(0, str(NOTEBOOKS))


def shown(notebook) -> list[tuple[str, str]]:
    """Text as it is, and of each picture that it is one."""
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    texts = [("text", output["text"]) for output in outputs if "text" in output]
    return texts + [("picture", kind) for output in outputs for kind in output.get("data", {}) if kind == "image/png"]


def test_the_notebook_shows_what_it_is_kept_with():
    import run

    kept = nbformat.read(run.NOTEBOOK, as_version=4)
    again = run.ran(copy.deepcopy(kept))
    assert shown(again) == shown(kept)
    assert [kind for kind, _ in shown(kept)].count("picture") == 3
