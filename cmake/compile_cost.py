#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks the build time: files, headers, templates and functions.

Compiles the files of `compile_commands.json` again, by clang with -ftime-trace, and prints a table of each. Times of
headers and templates include what they bring in. The build itself is left as it is.
"""

import argparse
import collections
import concurrent.futures
import json
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

TABLES = {"Source": "headers", "InstantiateFunction": "function templates", "InstantiateClass": "class templates",
          "OptFunction": "functions optimised"}


def command_with_trace(entry, folder):
    """The entry's command for clang, with its output and trace in `folder`."""
    words = shlex.split(entry["command"])
    compiler = next(at for at, word in enumerate(words) if re.search(r"(c\+\+|g\+\+|clang\+\+)(-\d+)?$", word))
    words = [word for word in words[compiler + 1:] if not word.startswith("-W")]
    words[words.index("-o") + 1] = str(folder / "out.o")
    return ["clang++", *words, "-w", "-ftime-trace", "-ftime-trace-granularity=200"]


def short(name):
    """A template's name without its arguments."""
    while (bare := re.sub(r"<[^<>]*>", "", name)) != name:
        name = bare
    return name.replace("(anonymous namespace)::", "")


def trace(entry):
    """File, its seconds, and seconds by (kind, name)."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(command_with_trace(entry, Path(folder)), cwd=entry["directory"], capture_output=True, text=True)
        if done.returncode != 0:
            return entry["file"], None, done.stderr
        events = json.loads((Path(folder) / "out.json").read_text())["traceEvents"]
    costs, total = collections.Counter(), 0.0
    for event in events:
        seconds = event.get("dur", 0) * 1e-6
        if event["name"] == "Total ExecuteCompiler":
            total = seconds
        elif event["name"] in TABLES:
            name = event.get("args", {}).get("detail", "")
            costs[event["name"], name if event["name"] == "Source" else short(name)] += seconds
    return entry["file"], total, costs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build/release", help="folder with compile_commands.json; default build/release")
    parser.add_argument("--files", default="", metavar="REGEX", help="only files whose path matches; default all")
    parser.add_argument("--rows", type=int, default=20, help="rows of each table; default 20")
    parser.add_argument("--jobs", type=int, default=1, help="number of parallel compilers; default 1")
    arguments = parser.parse_args()
    entries = json.loads((Path(arguments.build) / "compile_commands.json").read_text())
    entries = [entry for entry in entries if re.search(arguments.files, entry["file"])]
    files, costs = collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for file, total, found in pool.map(trace, entries):
            if total is None:
                print(f"{file}: clang cannot compile it\n{found[:500]}", file=sys.stderr)
                continue
            files[file] = total
            costs.update(found)
    print(f"{len(files)} files, {sum(files.values()):.0f} s")
    print_table("files", files.most_common(arguments.rows))
    for kind, title in TABLES.items():
        of_kind = collections.Counter({name: cost for (of, name), cost in costs.items() if of == kind})
        print_table(title, of_kind.most_common(arguments.rows))


def print_table(title, rows):
    print(f"\n{title}")
    for name, seconds in rows:
        print(f"{seconds:8.2f}  {name[:150]}")


if __name__ == "__main__":
    main()
