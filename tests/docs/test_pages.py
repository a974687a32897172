# SPDX-License-Identifier: BSD-3-Clause
"""What the handbook tells a reader to type is typed, page by page, and what it says is printed is held against it."""

import os
import re
import subprocess
from pathlib import Path

import pytest

from not_run import NOT_RUN
from page import FILES, ROOT, Scratch, blocks_of, commands_of, is_as_said, name_of, pages

BUILD = Path(os.environ.get("GAITWRIGHT_BUILD", ROOT / "build/release"))
PAGES = {name_of(page): page for page in pages()}
BLOCKS = {name: blocks_of(page) for name, page in PAGES.items()}
each_page = pytest.mark.parametrize("name", PAGES)


@pytest.mark.parametrize("name", [name for name, blocks in BLOCKS.items()
                                  if any(block.runs for block in blocks) and not name.endswith(".zh.md")])
def test_commands(name, tmp_path):
    folder = tmp_path / "gaitwright"
    folder.mkdir()
    scratch = Scratch(folder, BUILD)
    for block in BLOCKS[name]:
        where = f"{name}, line {block.line}"
        if block.language in FILES:
            path = folder / block.named["file"]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block.text)
        elif block.language == "sh" and block.runs:
            status, printed = scratch.run(block.text)
            if "cannot be run safely here" in printed:
                pytest.skip(printed.strip().splitlines()[-1])
            assert status == 0, f"{where}: ended with status {status}\n{printed}"
        elif block.language == "console":
            run_console(scratch, block, where)
    for picture in re.findall(r"\]\(images/([^)]+\.svg)\)", PAGES[name].read_text()):
        if (folder / picture).exists():
            numbers = r"[-+\u22120-9.,eE\s]+"  # they change with the plan, and so does the length of its curves
            bare = lambda path: re.sub(r"[MLZ]+", "M", re.sub(numbers, "", path.read_text()))
            assert bare(folder / picture) == bare(ROOT / "docs/images" / picture), (
                f"{name}: its commands draw another docs/images/{picture}: copy the new one there")


def run_console(scratch, block, where):
    commands, status = commands_of(block), 0
    for at, (command, said) in enumerate(commands):
        if command == "echo $?":
            assert said == str(status), f"{where}: the status of '{commands[at - 1][0]}' is {status}, the page has {said}"
            continue
        status, printed = scratch.run(command, stop=False)
        told = at + 1 < len(commands) and commands[at + 1][0] == "echo $?"
        assert status == 0 or told, f"{where}: '{command}' ended with status {status}, which the page does not say\n{printed}"
        assert is_as_said(printed, said), f"{where}: '{command}' prints\n{printed}\nand the page has\n{said}"


@each_page
def test_every_block_says_what_it_is(name):
    for block in BLOCKS[name]:
        where = f"{name}, line {block.line}"
        assert block.language in {"sh", "console", "python", "cpp", "text", "bibtex", *FILES}, (
            f"{where}: '{block.language or 'a block without a name'}' is none of the kinds that page.py lists")
        assert set(block.words) <= {"no-run", *(f"{k}={v}" for k, v in block.named.items())}, f"{where}: {block.words}"
        assert "no-run" not in block.words or block.language == "sh", f"{where}: only sh may be marked 'no-run'"


@each_page
def test_files_are_read_by_commands(name):
    """A file that no command of the page reads is one that nothing checks."""
    for at, block in enumerate(BLOCKS[name]):
        if block.language not in FILES or block.language == "bash":  # for bash see test_scripts_are_shell
            continue
        where = f"{name}, line {block.line}"
        assert "file" in block.named, f"{where}: {block.language} needs file=NAME"
        file = Path(block.named["file"])
        near = [file.name, *(f"{folder}/" for folder in file.parts[:-1])]  # a robot.yaml is read with what is beside it
        read = any(word in after.text for after in BLOCKS[name][at + 1 :] if after.runs for word in near)
        assert read, f"{where}: no command further down reads '{block.named['file']}'"


@each_page
def test_cpp_stands_in_the_source(name):
    for block in BLOCKS[name]:
        if block.language != "cpp":
            continue
        where = f"{name}, line {block.line}"
        assert "from" in block.named, f"{where}: cpp needs from=FILE"
        bare = lambda text: "\n".join(line.strip() for line in text.splitlines() if line.strip())
        assert bare(block.text) in bare((ROOT / block.named["from"]).read_text()), (
            f"{where}: these lines do not stand in {block.named['from']}")


def test_what_is_not_run_has_its_reason():
    marked = {(name.replace(".zh.md", ".md"), block.text.splitlines()[0])
              for name, blocks in BLOCKS.items() for block in blocks if "no-run" in block.words}
    assert marked == set(NOT_RUN), "blocks marked 'no-run' and the reasons of not_run.py"
    assert all(len(reason.split()) >= 3 for reason in NOT_RUN.values())


@pytest.mark.parametrize("name", [name for name in PAGES if name.endswith(".zh.md")])
def test_translations_have_the_blocks_of_the_original(name):
    shape = lambda blocks: [(block.language, block.words, block.text) for block in blocks]
    assert BLOCKS[name], f"{name} has no blocks"
    assert shape(BLOCKS[name]) == shape(BLOCKS[name.replace(".zh.md", ".md")])


def anchors_of(page):
    """The names that headings get on the web."""
    titles = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@each_page
def test_links_lead_somewhere(name):
    page = PAGES[name]
    text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        there = (page.parent / path).resolve() if path else page
        assert there.exists(), f"{name}: there is no '{target}'"
        assert not anchor or anchor in anchors_of(there), f"{name}: '{target}' names no heading of its page"


def test_a_block_that_fails_is_seen(tmp_path):
    folder = tmp_path / "clone"
    folder.mkdir()
    scratch = Scratch(folder, BUILD)
    assert scratch.run("false\ntrue\n")[0] == 1
    assert scratch.run("cd examples && export WORD=kept\n") == (0, "")
    assert scratch.run('echo "$WORD ${PWD##*/}"\n') == (0, "kept examples\n")
    assert is_as_said("a 1\nb\nc 2 d\n", "a 1\n...\nc ... d") and not is_as_said("a 1\nb\n", "a 1")


def test_scripts_are_shell(tmp_path):
    for name, blocks in BLOCKS.items():
        for block in blocks:
            if block.language == "bash":
                checked = subprocess.run(["bash", "-n"], input=block.text, text=True, stderr=subprocess.PIPE)
                assert checked.returncode == 0, f"{name}, line {block.line}: {checked.stderr}"


def program_text():
    """All literals of the program, those that go over several lines in one piece."""
    rooms = ("kinematics", "planning", "optimisation", "playback", "workflows", "cli", "cmake")
    files = [file for room in rooms for ending in ("cc", "h", "sh", "cmake") for file in (ROOT / room).rglob(f"*.{ending}")]
    return re.sub(r'"\s*\n\s*"', "", "\n".join(file.read_text() for file in files))


def test_messages_of_troubleshooting_are_the_programs():
    page, program = (ROOT / "docs/troubleshooting.md").read_text(), program_text()
    symptoms = re.findall(r"^\| (.*?) \|", page, re.M)
    messages = [message for symptom in symptoms for message in re.findall(r"`([^`]+)`", symptom) if " " in message]
    assert len(messages) > 40
    for message in messages:
        for piece in re.split(r"'?\.\.\.'?", message):
            assert piece.strip() in program, f"troubleshooting.md: no message of the program has '{piece.strip()}'"
