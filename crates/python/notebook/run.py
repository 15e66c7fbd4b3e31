"""Runs the notebook and keeps what it shows: python run.py"""

from pathlib import Path

import nbformat
from nbclient import NotebookClient

NOTEBOOK = Path(__file__).with_name("faces.ipynb")


def ran(notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """The notebook with what its cells show now; raises where one of them fails."""
    client = NotebookClient(notebook, resources={"metadata": {"path": str(NOTEBOOK.parent)}}, record_timing=False)
    return client.execute()


if __name__ == "__main__":
    nbformat.write(ran(nbformat.read(NOTEBOOK, as_version=4)), NOTEBOOK)
