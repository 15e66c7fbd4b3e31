from pathlib import Path

import nbformat
from nbclient import NotebookClient

NOTEBOOK = Path(__file__).parents[3] / "crates/python/notebook/faces.ipynb"


def test_the_notebook_has_no_outputs_and_runs():
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert [(cell.outputs, cell.execution_count) for cell in code] == [([], None)] * 8
    # Fills in the outputs.
    NotebookClient(notebook, resources={"metadata": {"path": str(NOTEBOOK.parent)}}, record_timing=False).execute()
    outputs = [output for cell in code for output in cell.outputs]
    pictures = [output for output in outputs if "image/png" in output.get("data", {})]
    text = "".join(output["text"] for output in outputs if "text" in output)
    assert len(pictures) == 3
    for expected in ["(478, 3) confidence 0.98", "no face found", "(7257, 3) (14368, 3)", "b'glTF'", "away; anchors are 0.0"]:
        assert expected in text
