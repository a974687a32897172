# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python code in the handbook: the blocks of a page in order, as a reader types them."""

import re
from pathlib import Path

import pytest

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGES = {page.name: re.findall(r"^```python\n(.*?)^```", page.read_text(), re.M | re.S) for page in DOCS.glob("*.md")}


@pytest.mark.parametrize("page", sorted(name for name, blocks in PAGES.items() if blocks))
def test_its_code_runs(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    known: dict[str, object] = {}
    for block in PAGES[page]:
        exec(compile(block, page, "exec"), known)


def test_the_page_on_python_has_code():
    assert len(PAGES["python.md"]) >= 3
