#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs clang-tidy over every .cc file of the tree that has changed since it was found clean.

A file has changed when it, a header of ours that it includes, its compiler flags, .clang-tidy or the tool has. Files that
were found clean are kept by the hash of all that, and docs/long-test-results.md names the last commit at which all files
were clean. Needs the compile commands of single files: `cmake --preset editor`.
Exit status: 0 all clean, 1 findings.
"""

import argparse
import concurrent.futures
import hashlib
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def included(file, known):
    """The file and all that it includes of ours, as a set of paths; `known` keeps what was read."""
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


def keyed_files(build, rooms, clean):
    """(key, file) of each .cc file of the rooms; the key is the hash of all that its findings depend on. Those that are as
    they were when all were clean are noted in the folder `clean`."""
    version = subprocess.run(["clang-tidy", "--version"], check=True, capture_output=True, text=True).stdout
    common = version + (ROOT / ".clang-tidy").read_text()
    known, keyed, changed = {}, {}, changed_since_clean()
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = Path(entry["file"])
        if not file.is_relative_to(ROOT) or file.relative_to(ROOT).parts[0] not in rooms:
            continue
        hashed = hashlib.sha256((common + entry["command"]).encode())
        paths = sorted(included(file, known))
        for path in paths:
            hashed.update(path.read_bytes())
        keyed[file] = hashed.hexdigest()
        if changed is not None and changed.isdisjoint(paths):
            (clean / keyed[file]).touch()
    return sorted((key, file) for file, key in keyed.items())


def git(*arguments):
    return subprocess.run(["git", *arguments], check=True, capture_output=True, text=True, cwd=ROOT).stdout


def changed_since_clean():
    """Paths that differ from the last commit at which clang-tidy passed; None where that tells nothing."""
    try:
        page = git("show", "HEAD:docs/long-test-results.md")
        commit = re.search(r"at commit ([0-9a-f]+),", page)
        if not commit or not re.search(r"^\| clang-tidy \| passed \|", page, re.M):
            return None
        paths = git("diff", "--name-only", commit[1]) + git("ls-files", "--others", "--exclude-standard")
    except (OSError, subprocess.CalledProcessError):
        return None  # no repository, or one without that commit
    changed = {ROOT / name for name in paths.splitlines()}
    return None if ROOT / ".clang-tidy" in changed else changed


def findings(build, file):
    """What clang-tidy has to say about a file; empty when it is clean."""
    done = subprocess.run(["clang-tidy", "-p", build, "--quiet", "--extra-arg=-Wno-unknown-warning-option", file],
                          capture_output=True, text=True, cwd=ROOT)
    said = re.findall(r"^.*(?:warning|error): .*$", done.stdout + done.stderr, re.M)
    return said or ([] if done.returncode == 0 else [f"{file}: error: clang-tidy failed"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rooms", nargs="+", help="folders whose files are looked at")
    parser.add_argument("--build", default=ROOT / "build/editor", type=Path, help="default build/editor")
    parser.add_argument("--clean", default=ROOT / "build/long-tests/clean", type=Path, help="folder that keeps what is clean")
    arguments = parser.parse_args()
    arguments.clean.mkdir(parents=True, exist_ok=True)
    files = keyed_files(arguments.build, arguments.rooms, arguments.clean)
    if not files:
        print(f"no .cc file of {', '.join(arguments.rooms)} is in {arguments.build}/compile_commands.json", file=sys.stderr)
        return 1
    left = [(key, file) for key, file in files if not (arguments.clean / key).exists()]
    found = set()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for (key, _), said in zip(left, pool.map(lambda item: findings(arguments.build, item[1]), left)):
            if not said:
                (arguments.clean / key).touch()
            for line in set(said) - found:
                found.add(line)
                print(line, flush=True)
    print(f"{len(found)} findings in {len(files)} files" if found else f"{len(files)} files are clean, {len(left)} of them looked at anew")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
