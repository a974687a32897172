#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lists the texts of all refusals of the sources and compares them with tests/messages/messages.txt.

A refusal is a `Failure` or an `InvalidArgument`; its texts are the string literals in it, as written, with fmt's
placeholders. So a change of a text shows in the review as one line, and no other test needs to know it.
With --renew the list is written anew. Exit status: 0 the list is up to date, 1 it is not.
"""

import difflib
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
KEPT = Path(__file__).with_name("messages.txt")
ROOMS = ["kinematics", "planning", "optimisation", "playback", "workflows", "cli"]
BEGINS = re.compile(r"\b(?:InvalidArgument|BadInput|Infeasible|Refuse\w*|Refused|Failure)\s*[({]|\{\s*FailureKind::")
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
SKIPPED = re.compile(r"//[^\n]*|^\s*#[^\n]*", re.M)
WORDS = re.compile(r"[A-Za-z]{2,}.* |^\{.*\}.*[a-z]{3,}")  # a text, not a key or a name


def balanced(text, start):
    """The text from the bracket at `start` to its partner; brackets in literals do not count."""
    depth, at = 0, start
    while at < len(text):
        if text[at] == '"':
            at = LITERAL.match(text, at).end() if LITERAL.match(text, at) else at + 1
            continue
        depth += text[at] in "({["
        depth -= text[at] in ")}]"
        at += 1
        if depth == 0:
            break
    return text[start:at]


def texts_of(source):
    """The literals of each refusal, adjacent ones joined, in the order of the source."""
    source = SKIPPED.sub("", source)
    found, done = [], 0
    for begin in BEGINS.finditer(source):
        bracket = source.rindex("{" if source[begin.end() - 1] != "(" else "(", 0, begin.end())
        if bracket < done:
            continue
        block = balanced(source, bracket)
        done = bracket + len(block)
        joined = re.sub(r'"\s*\n\s*"', "", block)
        found += [text for text in LITERAL.findall(joined) if WORDS.search(text)]
    return found


def listed():
    files = subprocess.run(["git", "ls-files", *ROOMS], cwd=ROOT, capture_output=True, text=True).stdout.split()
    if not files:  # an archive without git
        files = [str(path.relative_to(ROOT)) for room in ROOMS for path in (ROOT / room).rglob("*")]
    lines = []
    for file in sorted(files):
        if file.endswith((".cc", ".h")):
            texts = texts_of((ROOT / file).read_text())
            lines += [f"{file}: {text}" for text in texts]
    return lines


def main():
    lines = listed()
    if "--renew" in sys.argv:
        KEPT.write_text("\n".join(lines) + "\n")
        print(f"{len(lines)} texts: {KEPT.relative_to(ROOT)}")
        return 0
    kept = KEPT.read_text().splitlines()
    if lines == kept:
        return 0
    print("\n".join(difflib.unified_diff(kept, lines, "tests/messages/messages.txt", "the sources", lineterm="", n=0)))
    print("texts of refusals were changed: read them, then run tests/messages/messages.py --renew")
    return 1


if __name__ == "__main__":
    sys.exit(main())
