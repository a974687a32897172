#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a part of the tests of a GoogleTest program, and prints the output of those that fail.

A shard is a set of whole suites, so that tests of a suite share in one process what they make once. Suites are spread by
the durations in tests/slow_tests.txt. A test that ends the process is reported, and the rest run on in a new process.
Exit status: 0 all passed, 1 some failed, 2 no test was run.
"""

import argparse
import fnmatch
import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path

SLOW_TESTS = Path(__file__).with_name("slow_tests.txt")
USUAL_SECONDS = 0.02  # of a test that is not in slow_tests.txt
RAN = re.compile(r"^\[ +(OK|FAILED|SKIPPED) +\] (\S+?),? .*?\((\d+) ms\)$")


def slow_tests(program):
    """Seconds by test, for tests of the program that take long."""
    rows = [line.split() for line in SLOW_TESTS.read_text().splitlines() if line and not line.startswith("#")]
    return {name: float(seconds) for seconds, of_program, name in rows if of_program == program}


def listed_tests(path):
    """Full names of the tests of the program at `path`, in its order."""
    names, suite = [], ""
    listing = subprocess.run([path, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
    for line in listing.splitlines():
        word = line.split("#")[0].rstrip()
        if line.startswith("  "):
            names.append(suite + word.strip())
        elif word.endswith("."):
            suite = word
    return names


def shard_of_suites(names, seconds, count):
    """Shard (0 to count - 1) of each suite: the longest suite first, to the shard that has least."""
    weights = {}
    for name in names:
        suite = name.rpartition(".")[0]
        weights[suite] = weights.get(suite, 0.0) + seconds.get(name, USUAL_SECONDS)
    load, shards = [0.0] * count, {}
    for suite, weight in sorted(weights.items(), key=lambda item: (-item[1], item[0])):
        shards[suite] = load.index(min(load))
        load[shards[suite]] += weight
    return shards


def run_process(path, names, results):
    """Runs the tests in one process; adds {name, outcome, seconds} to `results`. Returns what has not been run."""
    environment = dict(os.environ, GTEST_FILTER=":".join(names))
    process = subprocess.Popen([path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                               env=environment, cwd=Path(path).parent)
    left, running, output, began = dict.fromkeys(names), None, [], 0.0
    for line in process.stdout:
        output.append(line)
        if line.startswith("[ RUN      ] "):
            running, output, began = line[13:].strip(), [line], time.monotonic()
        elif running and (ran := RAN.match(line.rstrip())) and ran[2] == running:
            outcome = {"OK": "passed", "FAILED": "failed", "SKIPPED": "skipped"}[ran[1]]
            results.append({"name": running, "outcome": outcome, "seconds": int(ran[3]) * 1e-3})
            if outcome == "failed":
                sys.stdout.writelines(output)
            left.pop(running, None)
            running, output = None, []
    status = process.wait()
    if running:
        sys.stdout.writelines(output)
        print(f"[  FAILED  ] {running} (the process ended with status {status})")
        results.append({"name": running, "outcome": "failed", "seconds": time.monotonic() - began})
        left.pop(running, None)
        return list(left)
    if status not in (0, 1) or left:
        sys.stdout.writelines(output)
        name = f"{Path(path).name}, outside of its tests"
        print(f"[  FAILED  ] {name} (the process ended with status {status}; {len(left)} tests were not run)")
        results.append({"name": name, "outcome": "failed", "seconds": 0.0})
    return []


def chosen_tests(path, arguments):
    """Names of the tests that are to be run."""
    program = Path(path).name
    names, seconds = listed_tests(path), slow_tests(program)
    shard, count = (int(part) for part in arguments.shard.split("/"))
    shards = shard_of_suites(names, seconds, count)
    names = [name for name in names if shards[name.rpartition(".")[0]] == shard - 1]
    if arguments.quick:
        names = [name for name in names if name not in seconds]
    if arguments.at_most:
        names = [name for name in names if seconds.get(name, 0.0) <= arguments.at_most]
    if arguments.only:
        names = [name for name in names if any(fnmatch.fnmatchcase(name, f"*{part}*") for part in arguments.only)]
    return names


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="path of the test program")
    parser.add_argument("--shard", default="1/1", metavar="K/N", help="run part K of N; default all")
    parser.add_argument("--quick", action="store_true", help="leave out the tests of tests/slow_tests.txt")
    parser.add_argument("--at-most", type=float, default=os.environ.get("GAITWRIGHT_TESTS_AT_MOST"), metavar="SECONDS",
                        help="leave out the tests that tests/slow_tests.txt says to take longer; default $GAITWRIGHT_TESTS_AT_MOST, or none")
    parser.add_argument("--only", action="append", metavar="PART", help="run only tests whose name has this part")
    parser.add_argument("--results", metavar="FILE", help="write the outcome of each test as JSON")
    arguments = parser.parse_args()
    arguments.quick |= bool(os.environ.get("GAITWRIGHT_QUICK_TESTS"))
    arguments.chosen = arguments.quick or bool(arguments.only or arguments.at_most)  # a part without any such test is fine
    path = str(Path(arguments.program).resolve())
    names, results = chosen_tests(path, arguments), []
    to_run = names
    while to_run:
        to_run = run_process(path, to_run, results)
    if arguments.results:
        Path(arguments.results).parent.mkdir(parents=True, exist_ok=True)
        Path(arguments.results).write_text(json.dumps({"program": Path(path).name, "tests": results}, indent=1))
    failed = [result["name"] for result in results if result["outcome"] == "failed"]
    skipped = sum(result["outcome"] == "skipped" for result in results)
    print(f"{Path(path).name}: {len(results) - len(failed) - skipped} passed, {len(failed)} failed, {skipped} skipped")
    for name in failed:
        print(f"  failed: {name}")
    return 1 if failed else 0 if results or arguments.chosen else 2


if __name__ == "__main__":
    sys.exit(main())
