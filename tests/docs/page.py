# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the handbook, their blocks of code, and how those are run.

The line that opens a block says what it is:

    sh                  commands, run in order; the first that fails ends the test
    sh no-run           commands that a test cannot run; `not_run.py` says why
    console             commands after `$ ` and what they print; `...` stands for anything
    python              run by tests/python
    yaml file=NAME      the file NAME (also json, csv, xml, bash), which commands further down the page read
    cpp from=FILE       lines of FILE, word for word; blank ones and the indent do not count
    text, bibtex        nothing to run
"""

import os
import re
import shlex
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FILES = {"yaml", "json", "csv", "xml", "bash"}
SEEN_BY_A_READER = ("robots", "examples", "python", "docs", "tests", "playback")  # what commands of a page may name
LONGEST_S = 3000  # that one block may take on whatever machine; what hangs is ended, nothing is judged by it


@dataclass
class Block:
    language: str
    words: list[str]
    text: str
    line: int
    named: dict[str, str] = field(default_factory=dict)

    def __post_init__(self):
        self.named = dict(word.split("=", 1) for word in self.words if "=" in word)

    @property
    def runs(self):
        return self.language in ("sh", "console") and "no-run" not in self.words


def pages():
    docs = sorted(page for page in (ROOT / "docs").rglob("*.md") if page.name != "long-test-results.md")
    return [ROOT / "README.md", ROOT / "README.zh.md", *docs] if (ROOT / "README.zh.md").exists() else [ROOT / "README.md", *docs]


def name_of(page):
    return page.relative_to(ROOT).as_posix()


def blocks_of(page):
    """All fenced blocks of a page. An indented one is a fault: nothing says what it is."""
    blocks, lines, at = [], page.read_text().split("\n"), 0
    while at < len(lines):
        line = lines[at]
        fence = re.match(r"^( *)```(.*)$", line)
        if fence:
            indent, words = fence.group(1), fence.group(2).split()
            end = at + 1
            while end < len(lines) and lines[end].strip() != "```":
                end += 1
            assert end < len(lines), f"{name_of(page)}, line {at + 1}: the block has no end"
            text = "\n".join(inner.removeprefix(indent) for inner in lines[at + 1 : end]) + "\n"
            blocks.append(Block(words[0] if words else "", words[1:], text, at + 1))
            at = end
        elif line.startswith("    ") and not (at and lines[at - 1].strip()):
            blocks.append(Block("indented", [], line, at + 1))
            while at + 1 < len(lines) and lines[at + 1].startswith("    "):
                at += 1
        at += 1
    return blocks


def commands_of(block):
    """The commands of a console, each with what it is said to print."""
    commands = []
    for line in block.text.splitlines():
        if line.startswith("$ "):
            commands.append([line[2:], []])
        elif line.startswith("> ") and commands and not commands[-1][1]:
            commands[-1][0] += "\n" + line[2:]
        else:
            assert commands, f"line {block.line}: a console begins with '$ ' and a command"
            commands[-1][1].append(line)
    return [(command, "\n".join(printed)) for command, printed in commands]


def is_as_said(printed, said):
    """Whether the text is what the page has, `...` being anything, a whole line of it any number of lines."""
    pattern = ""
    for line in said.splitlines():
        if line.strip() == "...":
            pattern += r"(?:.*\n)*?"
        else:
            pattern += ".*".join(re.escape(piece) for piece in line.rstrip().split("...")) + "\n"
    text = "".join(line.rstrip() + "\n" for line in printed.splitlines())
    return re.fullmatch(pattern, text) is not None


class Scratch:
    """A folder that looks like a fresh clone which `./run` has built, with a shell in it."""

    def __init__(self, folder, build):
        self.folder = folder
        for name in SEEN_BY_A_READER:
            (folder / name).symlink_to(ROOT / name)
        (folder / "build").mkdir()
        (folder / "build/release").symlink_to(build)
        self._stand_in("run", build)
        state = folder.parent / (folder.name + "-shell")
        state.mkdir()
        self.state, self.build = state, build
        (state / "environment").write_text(f"export PATH={shlex.quote(str(build))}:$PATH\n")
        (state / "folder").write_text(str(folder))

    def _stand_in(self, name, build):
        """`./run` once its set-up is done, which is what brought the program here."""
        script = (ROOT / name).read_text()
        root_line, set_up = 'root=$(cd "$(dirname "$0")" && pwd)\n', r"^(\.|ensure_packages|configure|build) .*\n"
        assert root_line in script
        (self.folder / name).write_text(re.sub(set_up, "", script, flags=re.M))
        (self.folder / name).chmod(0o755)

    def run(self, commands, stop=True):
        """Runs commands where the ones before them left the shell. @return the exit status and what was printed."""
        keep = f"declare -px >{self.state}/environment; pwd >{self.state}/folder"
        script = f'. {self.state}/environment\ncd "$(cat {self.state}/folder)"\ntrap {shlex.quote(keep)} EXIT\n'
        script += ("set -eo pipefail\n" if stop else "") + commands
        known = ("PATH", "LANG", "LC_ALL", "TMPDIR", "PYTHONDONTWRITEBYTECODE")
        environment = {key: os.environ[key] for key in known if key in os.environ}
        environment |= {"HOME": str(self.state), "PYTHONPATH": str(self.build / "python"), "MPLBACKEND": "Agg"}
        ran = subprocess.run(["bash", "-c", script], env=environment, text=True, timeout=LONGEST_S,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return ran.returncode, ran.stdout
