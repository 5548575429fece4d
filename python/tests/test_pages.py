"""Pages and the notebook print what they say."""

from __future__ import annotations

import doctest
import re
from pathlib import Path

import nbformat
import pandas as pd
import pytest
from nbclient import NotebookClient

PAGES = ["python/README.md", "docs/python.md"]


@pytest.mark.parametrize("page", PAGES)
def test_examples_print_what_stands_there(page: str, root: Path) -> None:
    blocks = re.findall(r"^```pycon\n(.*?)^```$", (root / page).read_text(), re.MULTILINE | re.DOTALL)
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    examples = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, page, page, 0)
    told: list[str] = []
    with pd.option_context("display.width", 200):
        result = doctest.DocTestRunner(optionflags=flags).run(examples, out=told.append)
    assert result.failed == 0, "".join(told)
    assert result.attempted > 8


def test_the_notebook_prints_what_it_says(root: Path) -> None:
    notebook = nbformat.read(root / "python/examples/story.ipynb", as_version=4)
    NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    said: list[str] = []
    claims = 0
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            # A figure in bold is printed by the cells below it, until the next one that says something.
            said = re.findall(r"\*\*([\d.]+)\*\*", cell.source)
            claims += len(said)
            continue
        printed = "".join(output.get("text", "") for output in cell.outputs)
        numbers = re.findall(r"\d+(?:\.\d+)?", printed)
        said = [figure for figure in said if figure not in numbers] if cell.outputs and printed else said
        assert said == [] or not printed, f"{said} in none of {numbers}"
    assert claims >= 8


def test_the_notebook_is_kept_without_outputs(root: Path) -> None:
    notebook = nbformat.read(root / "python/examples/story.ipynb", as_version=4)
    assert all(not cell.get("outputs") for cell in notebook.cells)
