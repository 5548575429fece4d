"""Files of the package use each other in one direction."""

from __future__ import annotations

import ast
from pathlib import Path

import fem

HERE = Path(fem.__file__).parent


def uses(path: Path) -> set[str]:
    """Files of the package that one imports, at its top, inside of functions or for types alone."""
    named: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("fem._"):
            named.add(node.module.split(".")[1])
        if isinstance(node, ast.ImportFrom) and node.module == "fem":
            named.update(alias.name for alias in node.names)
    return named


def test_no_circle() -> None:
    left = {path.stem: uses(path) for path in HERE.glob("_*.py") if not path.stem.startswith("__")}
    assert len(left) > 5 and left["_model"] >= {"_results", "_study"}
    while left:
        ends = {name for name, used in left.items() if not used & left.keys()}
        assert ends, f"a circle among {sorted(left)}"
        left = {name: used for name, used in left.items() if name not in ends}
