#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests of a build by CTest and prints one line of counts; what failed is named, test by test.

NAME is a part of the name of a CTest test (a room such as `planning`, `docs.docs/trials.md`, `python`) or of a single test
(`ZeroMomentPoint`, `Swing.EndsAtRest`). Without a NAME all tests but the long ones are run.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

HERE = Path(__file__).resolve().parent
SLOW_SECONDS = 0.25  # what takes longer is left out by --quick


def ctest(build, *arguments, **options):
    return subprocess.run(["ctest", "--test-dir", str(build), "--no-tests=error", *arguments], check=False, **options)


def listed(build):
    """Name, labels and command of each test of the build."""
    shown = json.loads(ctest(build, "--show-only=json-v1", capture_output=True, text=True).stdout)
    labels = lambda test: next((p["value"] for p in test.get("properties", []) if p["name"] == "LABELS"), [])
    return [(test["name"], labels(test), test.get("command", [])) for test in shown["tests"]]


def run_all(build, choice, quick):
    """Runs what `choice`, options of ctest, says; exit status of ctest and the counts."""
    results, junit = build / "test-results", build / "test-results/ctest.xml"
    for old in results.glob("*.json"):
        old.unlink()
    junit.unlink(missing_ok=True)
    environment = dict(os.environ, **({"GAITWRIGHT_QUICK_TESTS": "1"} if quick else {}))
    status = ctest(build, f"-j{os.cpu_count() + 2}", "--output-on-failure", "--output-junit", str(junit), *choice,
                   env=environment).returncode
    return status, counts_of(results, junit)


def counts_of(results, junit):
    """{outcome: names} of all tests of a run: single ones of the shards, the others as CTest has them."""
    counts = {"passed": [], "failed": [], "skipped": []}
    shards = {}
    for file in results.glob("*.json"):
        report = json.loads(file.read_text())
        for test in report["tests"]:
            counts[test["outcome"]].append(f"{report['program']}: {test['name']}")
        shards[file.stem] = any(test["outcome"] == "failed" for test in report["tests"])
    for case in xml.parse(junit).getroot().iter("testcase") if junit.exists() else []:
        outcome = {"run": "passed", "fail": "failed"}.get(case.get("status"), "skipped")
        named = shards.get(case.get("name"))
        if named is None or (outcome == "failed" and not named):
            counts[outcome].append(case.get("name"))
    return counts


def run_named(build, names, tests):
    """Tests of CTest whose name has one of `names`, and single tests of the programs."""
    status, counts = 0, {"passed": [], "failed": [], "skipped": []}
    entries = [name for name in names if any(name in test for test, _, _ in tests)]
    if entries:
        status, counts = run_all(build, ["-LE", "^long$", "-R", "|".join(re.escape(name) for name in entries)], False)
    single = [name for name in names if name not in entries]
    programs = sorted({command[2] for _, labels, command in tests if "shard" in labels and "long" not in labels} if single else [])
    for program in filter(os.path.exists, programs):
        results = build / "test-results/named.json"
        only = [word for name in single for word in ("--only", name)]
        status |= subprocess.run([sys.executable, HERE / "run_shard.py", program, "--results", results, *only],
                                 check=False).returncode
        for test in json.loads(results.read_text())["tests"]:
            counts[test["outcome"]].append(f"{Path(program).name}: {test['name']}")
    return status, counts


def slow_tests(results):
    """(program, name, seconds) of the tests of the last run that take long."""
    reports = [json.loads(file.read_text()) for file in results.glob("*.json")]
    return [(report["program"], test["name"], test["seconds"]) for report in reports for test in report["tests"]
            if test["seconds"] >= SLOW_SECONDS]


def renew_slow_tests(results):
    """Writes tests/slow_tests.txt from the results of the last whole run."""
    rows = slow_tests(results)
    text = ("# Seconds, program and name of the tests that take long. Shards are balanced by it, and `./test --quick` leaves these\n"
            "# tests out. Renewed by `tests/run_tests.py --renew-slow` after a whole run.\n")
    (HERE / "slow_tests.txt").write_text(text + "".join(f"{s:.2f} {program} {name}\n" for program, name, s in sorted(set(rows))))
    print(f"{len(rows)} tests take {SLOW_SECONDS} s or more: tests/slow_tests.txt")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--build", default="build/release", type=Path, help="folder of the build; default build/release")
    parser.add_argument("--quick", action="store_true", help="leave out the tests of tests/slow_tests.txt, the handbook and the packages")
    parser.add_argument("--long", action="store_true", help="only the long tests")
    parser.add_argument("--renew-slow", action="store_true", help="write tests/slow_tests.txt anew; run no test")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    if arguments.renew_slow:
        return renew_slow_tests(build / "test-results")
    if arguments.names:
        status, counts = run_named(build, arguments.names, listed(build))
    elif arguments.quick:
        status, counts = run_all(build, ["-L", "^(shard|quick)$", "-LE", "^long$"], True)
        slow = slow_tests(build / "test-results")
        if slow:
            print(f"{len(slow)} of these tests take {SLOW_SECONDS} s or more; tests/run_tests.py --renew-slow after a whole run leaves them out")
    else:
        status, counts = run_all(build, ["-L" if arguments.long else "-LE", "^long$"], False)
    for name in counts["skipped"]:
        print(f"skipped: {name}")
    for name in counts["failed"]:
        print(f"failed: {name}")
    total = sum(len(names) for names in counts.values())
    if total == 0:
        print("no test was run: no test has such a name; the names are listed by `ctest --test-dir build/release -N`", file=sys.stderr)
        return 1
    print(f"{len(counts['passed'])} passed, {len(counts['failed'])} failed, {len(counts['skipped'])} skipped")
    return 1 if counts["failed"] else status


if __name__ == "__main__":
    sys.exit(main())
