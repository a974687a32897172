# SPDX-License-Identifier: BSD-3-Clause
"""The course kit of examples/course: its solutions get all marks and its starting code next to none, in both languages."""

import csv
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

COURSE = Path(__file__).resolve().parents[2] / "examples" / "course"
BUILD = Path(os.environ["GAITWRIGHT_BUILD"])
PROGRAM = BUILD / "gaitwright"

ASSIGNMENTS = {
    "1-zmp": "zmp",
    "2-preview": "preview",
    "3-dcm": "dcm",
    "4-swing": "swing",
    "5-ik": "ik",
    "6-trot": "trot",
    "7-stairs": "stairs",
    "8-robustness": "robustness",
}
BY_NUMBERS = ("1-zmp", "2-preview", "3-dcm", "4-swing", "5-ik")
CODE = tuple(folder for folder in ASSIGNMENTS if folder != "6-trot")  # whose Python is handed in, and not what it writes
HANDED_IN = {"6-trot": "trot.yaml", "7-stairs": "plan.json", "8-robustness": "robustness.yaml"}  # by C++ programs
MOST_OF_THE_START = 20.0  # of 100
SEEDS = [int(seed) for seed in os.environ.get("GAITWRIGHT_COURSE_SEEDS", "11").split()]


def run(command, folder):
    """What a program prints; it must end well."""
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, check=False)
    if "cannot be run safely here" in done.stderr:
        pytest.skip(done.stderr.strip())
    assert done.returncode == 0, f"{command}: {done.stdout}\n{done.stderr}"
    return done.stdout


def source(student, folder):
    return COURSE / folder / "start" if student == "start" else COURSE / "solutions" / folder


def program(student, folder):
    place = Path(folder, "start") if student == "start" else Path("solutions", folder)
    return BUILD / "examples" / "course" / place / ASSIGNMENTS[folder]


def hand_in_python(folder, student, place):
    name = ASSIGNMENTS[folder] + ".py"
    if folder in CODE:
        shutil.copy(source(student, folder) / name, place)
    else:
        run([sys.executable, source(student, folder) / name], place)


def hand_in_cpp(folder, student, place, seed):
    if folder in BY_NUMBERS:
        questions = place.parent.parent / "questions"
        rubric = COURSE / folder / "rubric-cpp.yaml"
        run([PROGRAM, "grade", "--rubric", rubric, "--seed", seed, "--write-inputs", questions], place)
        run([program(student, folder), questions, place], place)
    else:
        run([program(student, folder), place / HANDED_IN[folder]], place)


def marks(folder, track, students, seed):
    """The points of each student, of 100, and what each part says."""
    rubric = COURSE / folder / f"rubric-{track}.yaml"
    out = students.parent / "grades"
    flags = ["--rubric", rubric, "--seed", seed, "--out-dir", out, "--python", sys.executable, "--json"]
    text = run([PROGRAM, "grade", students, *flags], students)
    with open(out / "grades.csv", encoding="utf-8", newline="") as table:
        total = {row["student"]: float(row["total"]) for row in csv.DictReader(table)}
    return total, json.loads(text)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("track", ["python", "cpp"])
@pytest.mark.parametrize("folder", ASSIGNMENTS)
def test_the_solution_gets_all_marks_and_the_start_next_to_none(folder, track, seed, tmp_path):
    students = tmp_path / "class"
    for student in ("start", "solution"):
        place = students / student
        place.mkdir(parents=True)
        if track == "python":
            hand_in_python(folder, student, place)
        else:
            hand_in_cpp(folder, student, place, seed)
    total, told = marks(folder, track, students, seed)
    print(f"{folder} {track} seed {seed}: solution {total['solution']}, start {total['start']}")
    assert total["solution"] == 100.0, json.dumps(told, indent=1)
    assert total["start"] <= MOST_OF_THE_START, json.dumps(told, indent=1)


@pytest.mark.parametrize("folder", CODE)
def test_starting_code_in_python_runs_and_shows_what_is_wanted(folder, tmp_path):
    said = run([sys.executable, source("start", folder) / (ASSIGNMENTS[folder] + ".py")], tmp_path)
    assert said.strip()


@pytest.mark.parametrize("folder", BY_NUMBERS)
def test_what_starting_code_says_is_wanted_is_what_the_solution_gives(folder, tmp_path):
    """The examples at the end of the starting code, run on the solution's functions."""
    name = ASSIGNMENTS[folder]
    start = (source("start", folder) / f"{name}.py").read_text(encoding="utf-8")
    solution = (source("solution", folder) / f"{name}.py").read_text(encoding="utf-8")
    shown = start[start.index("if __name__") :]
    helper = start[start.index("def show") : start.index("if __name__")] if "def show" in start else ""
    joined = tmp_path / "joined.py"
    joined.write_text(f"{solution}\n\n{helper}\n{shown}", encoding="utf-8")
    for line in run([sys.executable, joined], tmp_path).splitlines():
        for got, wanted in numbers_told(line):
            assert got == pytest.approx(wanted, abs=2e-4), line


def numbers_told(line):
    """Pairs of numbers in 'WHAT: GOT, expected WANTED', as many as are expected."""
    if "expected" not in line or "more" in line:
        return []
    got, wanted = line.rsplit("expected", 1)
    wanted = numbers_in(wanted)
    return list(zip(numbers_in(got.split(":")[-1])[: len(wanted)], wanted))


def numbers_in(text):
    numbers = []
    for word in text.replace("[", " ").replace("]", " ").replace(",", " ").replace(";", " ").split():
        try:
            numbers.append(float(word))
        except ValueError:
            pass
    return numbers


def test_a_handout_without_solutions_has_all_that_its_texts_name():
    for folder, name in ASSIGNMENTS.items():
        for file in ("README.md", f"start/{name}.py", f"start/{name}.cc", "rubric-python.yaml", "rubric-cpp.yaml"):
            assert (COURSE / folder / file).is_file(), f"{folder}/{file}"
        assert (COURSE / "solutions" / folder / f"{name}.cc").is_file()
        assert "solutions/" not in (COURSE / folder / "README.md").read_text(encoding="utf-8")
