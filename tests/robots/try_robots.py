#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Walks every robot of a folder for a metre, with nothing but its description, and prints a table.

A robot is a URDF, xacro or MJCF file in a folder of its own. With --kept FILE the outcomes are compared with those of that
file: a line `NAME OUTCOME`, where OUTCOME is `walks`, or the code of the refusal. Exit status: 0 as kept, 1 not so.
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ENDINGS = (".urdf", ".xacro", ".xml")
WRONG_INPUT = 1  # exit status of a robot that is not loaded, among others


def described(folder):
    """(name, file) of each robot of the folder."""
    for place in sorted(path for path in folder.iterdir() if path.is_dir()):
        files = [path for path in sorted(place.iterdir()) if path.suffix in ENDINGS and path.name != "package.xml"]
        if files:
            yield place.name, files[0].resolve()


def run_json(folder, program, *arguments):
    """Status and answer of a call in a folder of its own, where the program may write a draft of a robot.yaml."""
    done = subprocess.run([program, *map(str, arguments), "--json"], capture_output=True, text=True, cwd=folder)
    try:
        return done.returncode, json.loads(done.stdout)
    except ValueError:
        return done.returncode, {"error": {"code": f"status {done.returncode}", "message": done.stderr.strip()[:200]}}


def findings_of(program, folder, file):
    """Whether the description loads, its first error, and how many warnings there are. `robots check` plans a walk for its
    verdict, which takes as long as to plan the walk itself, so it is not asked without need."""
    _, checked = run_json(folder, program, "robots", "check", file)
    error = next((f for f in checked.get("findings", []) if f["level"] == "error"), checked.get("error"))
    return checked.get("verdict", "is not loaded") != "is not loaded", error, checked.get("warnings", 0)


def tried(program, file, with_warnings):
    """One row of the table."""
    flag = "--mjcf" if file.suffix == ".xml" else "--urdf"
    loads, finding, warnings = True, None, None
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        status, walk = run_json(folder, program, "walk", flag, file, "--distance", "1", "--out-dir", folder)
        if status == WRONG_INPUT or with_warnings:
            loads, finding, warnings = findings_of(program, folder, file)
    if not loads:
        error = finding or {"code": "unknown", "message": ""}
    else:
        error = walk.get("error", {"code": f"falls: {walk.get('reason', '')}" if status == 3 else "", "message": walk.get("reason", "")})
    return {"loads": loads, "warnings": "" if warnings is None else warnings, "walks": status == 0, "score": walk.get("score"),
            "seconds": time.monotonic() - began, "code": error["code"], "why": "" if status == 0 else error["message"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="path of gaitwright")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--kept", type=Path, help="outcomes that are expected")
    parser.add_argument("--warnings", action="store_true", help="count the warnings of `robots check` too, which doubles the time")
    arguments = parser.parse_args()
    kept = {}
    if arguments.kept:
        lines = [line.split(None, 1) for line in arguments.kept.read_text().splitlines() if line and not line.startswith("#")]
        kept = {name: outcome.strip() for name, outcome in lines}
    different = []
    print(f"{'robot':<18} loads  warnings  walks  score  seconds")
    for name, file in described(arguments.folder):
        row = tried(Path(arguments.program).resolve(), file, arguments.warnings)
        score = "" if row["score"] is None else f"{row['score']:.1f}"
        print(f"{name:<18} {'yes' if row['loads'] else 'no':<6} {row['warnings']:<9} {'yes' if row['walks'] else 'no':<6} "
              f"{score:<6} {row['seconds']:<7.1f} {row['why']}", flush=True)
        outcome = "walks" if row["walks"] else row["code"]
        if kept and kept.get(name) != outcome:
            different.append(f"{name}: {outcome}, kept is {kept.get(name, 'nothing')}")
    for line in different:
        print("different:", line)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
