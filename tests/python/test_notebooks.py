# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks of examples/: their cells run in order, and they are stored without results."""

import json
import os
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).resolve().parents[2] / "examples").rglob("*.ipynb"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_cells_run_in_order(notebook, tmp_path, capsys):
    stored = json.loads(notebook.read_text(encoding="utf-8"))
    assert stored["nbformat"] == 4 and stored["metadata"]["language_info"]["name"] == "python"
    cells = [cell for cell in stored["cells"] if cell["cell_type"] == "code"]
    names, before = {}, Path.cwd()
    os.chdir(tmp_path)
    try:
        for number, cell in enumerate(cells):
            assert cell["outputs"] == [] and cell["execution_count"] is None
            exec(compile("".join(cell["source"]), f"{notebook.name}, cell {number}", "exec"), names)
    finally:
        os.chdir(before)
    assert names["repaired"].passed and not names["repaired"].before.passed
    assert names["trials"].survived == names["trials"].n
    assert "after: audit: pass" in capsys.readouterr().out
    assert (tmp_path / "repaired.npz").exists()
