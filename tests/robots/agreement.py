#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plays walks in both physics engines and prints the table of docs/scores.md: verdicts, largest differences, first difference.

The walks are lines of arguments of `gaitwright walk`, in --walks FILE, or with --handbook the walks that README.md and docs/*.md
show. With --at-least SHARE the exit status is 1 when a smaller share of the walks that pass in Bullet passes in MuJoCo.
"""

import argparse
import json
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SHOWN = re.compile(r"^(?:\$ )?(?:\./run|gaitwright|build/release/gaitwright) walk (.*)$")
COLUMNS = {"force": "normal force", "ZMP": "ZMP", "slip": "slip", "base": "base", "depth": "depth"}
NOT_COMPARED = {"--out-dir", "--engine"}  # flags with a value that the call sets itself


def handbook_walks():
    """Arguments of each walk in a fenced block of the handbook, without what the call sets itself; each once."""
    walks = {}
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        for line in page.read_text().replace("\\\n", " ").splitlines():
            if shown := SHOWN.match(line.strip()):
                words = shlex.split(re.split(r"\s(?:#|>|\||&&)\s?", " " + shown[1])[0])
                kept = [word for at, word in enumerate(words)
                        if word not in NOT_COMPARED and (at == 0 or words[at - 1] not in NOT_COMPARED) and word != "--json"]
                walks[shlex.join(kept)] = None
    return list(walks)


def listed_walks(file):
    lines = (line.strip() for line in file.read_text().splitlines())
    return [line for line in lines if line and not line.startswith("#")]


def walked(program, arguments, folder):
    """The answer of a walk in both engines, or its error."""
    done = subprocess.run([program, "walk", *shlex.split(arguments), "--engine", "both", "--json", "--out-dir", folder],
                          capture_output=True, text=True, cwd=ROOT, check=False)
    try:
        return json.loads(done.stdout)
    except ValueError:
        return {"error": {"code": f"status {done.returncode}", "message": done.stderr.strip()[:200]}}


def row_of(arguments, answer):
    """One row of the table; of a walk that has no two playbacks the reason."""
    engines = answer.get("engines", [])
    if len(engines) != 2:
        return f"| {arguments} | {answer.get('error', {}).get('code', 'one engine')} | | | | | | | |"
    agreement = answer["agreement"]
    shares = {name: max((q["largest"] / q["tolerance"] for q in agreement["quantities"] if q["quantity"].startswith(start)),
                        default=0.0) for name, start in COLUMNS.items()}
    first = agreement.get("first") if not agreement["agree"] else None
    part = f"{first['quantity']}, {first['parts_s']:.2f} s" if first else "agree"
    verdicts = " | ".join(f"{engine['verdict']} {engine['score']:.1f}" for engine in engines)
    return f"| {arguments} | {verdicts} | {' | '.join(f'{share:.2f}' for share in shares.values())} | {part} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/gaitwright", type=Path)
    parser.add_argument("--walks", type=Path, help="a file with the arguments of a walk in each line; default tests/robots/walks.txt")
    parser.add_argument("--handbook", action="store_true", help="the walks that README.md and the handbook show")
    parser.add_argument("--at-least", type=float, metavar="SHARE", help="share of walks that must pass in MuJoCo of those that pass in Bullet")
    arguments = parser.parse_args()
    walks = handbook_walks() if arguments.handbook else listed_walks(arguments.walks or Path(__file__).with_name("walks.txt"))
    print(f"| walk | Bullet | MuJoCo | {' | '.join(COLUMNS)} | first difference |\n|{'---|' * (len(COLUMNS) + 4)}")
    passed, both, parted = 0, 0, 0
    for walk in walks:
        with tempfile.TemporaryDirectory() as folder:
            answer = walked(arguments.program.resolve(), walk, folder)
        print(row_of(walk, answer), flush=True)
        verdicts = [engine["verdict"] == "pass" for engine in answer.get("engines", [])]
        if len(verdicts) == 2:
            passed += verdicts[0]
            both += all(verdicts)
            parted += verdicts[0] != verdicts[1]
    print(f"\n{passed} of {len(walks)} walks pass in Bullet, {both} of these in MuJoCo; {parted} have another verdict there")
    return 1 if arguments.at_least is not None and both < arguments.at_least * passed else 0


if __name__ == "__main__":
    sys.exit(main())
