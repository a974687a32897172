# SPDX-License-Identifier: BSD-3-Clause
"""Reports and the 3D viewer inline in a notebook."""

from __future__ import annotations

import html
from pathlib import Path

from gaitwright._core import Comparison, Plan, Playback, TrialsReport


class Page:
    """A self-contained HTML page. A notebook shows it inline; `save` writes it to a file."""

    def __init__(self, text: str, height_px: int = 640) -> None:
        self.text = text
        self.height_px = height_px

    def save(self, path: str | Path) -> Path:
        """Writes the page; returns the path."""
        path = Path(path)
        path.write_text(self.text, encoding="utf-8")
        return path

    def _repr_html_(self) -> str:
        return (
            f'<iframe srcdoc="{html.escape(self.text, quote=True)}" '
            f'style="width: 100%; height: {self.height_px}px; border: 0"></iframe>'
        )


def show(what: Plan | Playback | TrialsReport | Comparison, viewer: bool = False, height_px: int = 640) -> Page:
    """The report of a playback, of trials or of a comparison. For a plan, and with `viewer`: the motion in 3D only."""
    if isinstance(what, Plan) or (viewer and isinstance(what, Playback)):
        return Page(what.viewer_html(), height_px)
    if viewer or not isinstance(what, (Playback, TrialsReport, Comparison)):
        raise TypeError(f"there is no {'motion' if viewer else 'page'} to show of a {type(what).__name__}")
    return Page(what.report_html(), height_px)


def _shown_inline(what: Playback | TrialsReport | Comparison) -> str:
    return show(what)._repr_html_()


for _kind in (Playback, TrialsReport, Comparison):
    setattr(_kind, "_repr_html_", _shown_inline)
