#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs clang-tidy over every .cc file of the tree that has changed since its last clean result.

Files are checked in the groups in which the build compiles them, in a third of the time that single files take.
A group has changed if one of its files, one of our headers in it, its compiler flags, .clang-tidy or the tool has.
Clean groups are stored by the hash of all these, and docs/long-test-results.md names the last commit at which
all were clean. With --alone each file is compiled separately instead, without generating code. This finds files that lack an
include which another file of their group has. It needs the compile commands of single files: `cmake --preset editor`.
Exit status: 0 all clean, 1 findings.
"""

import argparse
import concurrent.futures
import hashlib
import json
import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def included(file, known):
    """The file and all of our headers that it includes, as a set of paths; `known` caches file contents."""
    reached, to_read = set(), [file]
    while to_read:
        at = to_read.pop()
        if at in reached:
            continue
        reached.add(at)
        if at not in known:
            paths = [ROOT / name for name in INCLUDE.findall(at.read_text(errors="replace"))]
            paths += [at.parent / path.name for path in paths]
            known[at] = [path for path in paths if path.is_file()]
        to_read += known[at]
    return reached


def room_of(unit):
    """Top folder of a .cc file, or of the first file of a group (a source that includes its files); None for other files."""
    if not unit.is_relative_to(ROOT):
        return None
    if "Unity" in unit.parts:
        unit = next((Path(name) for name in INCLUDE.findall(unit.read_text()) if name.endswith(".cc")), unit)
    return unit.relative_to(ROOT).parts[0]


def keyed_units(build, rooms, clean, part):
    """(key, file, command) of each source of the build in the rooms; the key is the hash of everything that affects its findings.
    Sources that have not changed since all were clean are recorded in the folder `clean`."""
    version = subprocess.run(["clang-tidy", "--version"], check=True, capture_output=True, text=True).stdout
    common = version + (ROOT / ".clang-tidy").read_text()
    known, keyed, changed = {}, {}, changed_since_clean(part)
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = Path(entry["file"])
        if room_of(file) not in rooms:
            continue
        hashed = hashlib.sha256((common + entry["command"]).encode())
        paths = sorted(included(file, known))
        for path in paths:
            hashed.update(path.read_bytes())
        key = hashed.hexdigest()
        keyed[file] = (key, file, entry["command"])
        if changed is not None and changed.isdisjoint(paths):
            (clean / key).touch()
    return sorted(keyed.values())


def git(*arguments):
    return subprocess.run(["git", *arguments], check=True, capture_output=True, text=True, cwd=ROOT).stdout


def changed_since_clean(part):
    """Paths that differ from the last commit at which that part of the long tests passed; None if it is unknown."""
    page = "docs/long-test-results.md"
    try:
        for version in git("log", "--format=%h", "--", page).split():
            text = git("show", f"{version}:{page}")
            commit = re.search(r"at commit ([0-9a-f]+),", text)
            if commit and re.search(rf"^\| {part} \| passed \|", text, re.M):
                paths = git("diff", "--name-only", commit[1]) + git("ls-files", "--others", "--exclude-standard")
                changed = {ROOT / name for name in paths.splitlines()}
                return None if ROOT / ".clang-tidy" in changed else changed
    except (OSError, subprocess.CalledProcessError):
        pass  # not a repository, or one without those commits
    return None


def findings(build, file):
    """Findings of clang-tidy for a file or a group of files; empty if it is clean."""
    done = subprocess.run(["clang-tidy", "-p", build, "--quiet", "--checks=-bugprone-suspicious-include",  # of a group's .cc
                           "--extra-arg=-Wno-unknown-warning-option",
                           "--extra-arg=-Wno-unused-command-line-argument", file],
                          capture_output=True, text=True, cwd=ROOT)
    return told(done, file)


def findings_alone(file, command):
    """Diagnostics of the compiler for a file alone; empty if it compiles."""
    words = shlex.split(command)
    words[words.index("-o"):words.index("-o") + 2] = ["-fsyntax-only"]
    return told(subprocess.run(words, capture_output=True, text=True, cwd=ROOT), file)


def told(done, file):
    said = re.findall(r"^.*(?:warning|error): .*$", done.stdout + done.stderr, re.M)
    return said or ([] if done.returncode == 0 else [f"{file}: error: {done.args[0]} failed"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rooms", nargs="+", help="folders whose files are looked at")
    parser.add_argument("--alone", action="store_true", help="compile each file separately; uses build/editor")
    parser.add_argument("--build", type=Path, help="default build/release")
    parser.add_argument("--clean", default=ROOT / "build/long-tests/clean", type=Path, help="folder that records clean sources")
    arguments = parser.parse_args()
    build = arguments.build or ROOT / "build" / ("editor" if arguments.alone else "release")
    clean = arguments.clean / "alone" if arguments.alone else arguments.clean
    clean.mkdir(parents=True, exist_ok=True)
    units = keyed_units(build, arguments.rooms, clean, "files alone" if arguments.alone else "clang-tidy")
    if not units:
        print(f"no source of {', '.join(arguments.rooms)} is in {build}/compile_commands.json", file=sys.stderr)
        return 1
    left = [unit for unit in units if not (clean / unit[0]).exists()]
    look = (lambda unit: findings_alone(*unit[1:])) if arguments.alone else (lambda unit: findings(build, unit[1]))
    found = set()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for (key, *_), said in zip(left, pool.map(look, left)):
            if not said:
                (clean / key).touch()
            for line in set(said) - found:
                found.add(line)
                print(line, flush=True)
    kind = "files, each alone," if arguments.alone else "groups of files"
    print(f"{len(found)} findings in {len(units)} {kind}" if found
          else f"{len(units)} {kind} are clean, {len(left)} of them checked now")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
