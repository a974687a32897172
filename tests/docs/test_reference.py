# SPDX-License-Identifier: BSD-3-Clause
"""What the program writes of itself is what docs/ has, its schemas fit what it writes and reads, and no more than that."""

import filecmp
import functools
import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest
import yaml
from jsonschema import Draft202012Validator

from page import ROOT, blocks_of, pages

BUILD = Path(os.environ.get("GAITWRIGHT_BUILD", ROOT / "build/release"))
DOCS = ROOT / "docs"
SCHEMAS = sorted(path.stem for path in (DOCS / "schemas").glob("*.json"))
BLOCKS = {"mine.yaml": "gaits", "stroll.yaml": "gaits", "parts.yaml": "sequence", "yard.yaml": "terrain",
          "porch.yaml": "terrain", "names.yaml": "columns", "steps.yaml": "footsteps", "measured.yaml": "start-posture",
          "goat/robot.yaml": "robot-yaml", "parallel/robot.yaml": "robot-yaml", "stones.json": "task-plan", "weights.yaml": "repair-weights", "zmp-rubric.yaml": "rubric", "stairs-rubric.yaml": "rubric"}


def gaitwright(*arguments, folder, statuses=(0,)):
    ran = subprocess.run([BUILD / "gaitwright", *map(str, arguments)], cwd=folder, text=True, timeout=3000,
                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert ran.returncode in statuses, f"{arguments}: status {ran.returncode}\n{ran.stdout}{ran.stderr}"
    return ran


def validator(name):
    return Draft202012Validator(json.loads((DOCS / "schemas" / f"{name}.json").read_text()))


def faults(name, document):
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:200]}" for error in validator(name).iter_errors(document)]


def test_docs_have_what_the_program_writes(tmp_path):
    gaitwright("reference", "--out-dir", tmp_path, folder=tmp_path)
    for folder in ("reference", "schemas"):
        told = f"renew docs/{folder}: build/release/gaitwright reference --out-dir docs"
        made, there = sorted(p.name for p in (tmp_path / folder).iterdir()), sorted(p.name for p in (DOCS / folder).iterdir())
        assert made == there, told
        _, others, errors = filecmp.cmpfiles(tmp_path / folder, DOCS / folder, made, shallow=False)
        assert not others and not errors, f"{others} differ; {told}"


@pytest.mark.parametrize("name", SCHEMAS)
def test_schemas_are_schemas(name):
    Draft202012Validator.check_schema(json.loads((DOCS / "schemas" / f"{name}.json").read_text()))


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """A folder with files of all kinds and, as VERB.json, what verbs print."""
    folder = tmp_path_factory.mktemp("made")
    (folder / "measured.yaml").write_text(block_named("measured.yaml"))

    def keep(name, *arguments, statuses=(0,)):
        (folder / f"{name}.json").write_text(gaitwright(*arguments, "--json", folder=folder, statuses=statuses).stdout)

    hobby = ROOT / "examples/disturbances/a1_hobby.yaml"
    keep("walk", "walk", "--robot", "a1", "--speed", "0.5", "--distance", "0.3", "--out-dir", "out", "--plot-dir", "plots")
    keep("play", "play", "out/plan.json", "--disturbances", hobby, "--state", "estimated", "--sensors", "hobby", "--seed", "3",
         "--push", "30,0,0", "--push-at", "1.5", "--push-for", "0.1", "--log", "played.json", statuses=(0, 3))
    keep("fell", "play", "out/plan.json", "--push", "0,300,0", "--push-at", "1", "--push-for", "0.2", "--log", "fell-log.json", statuses=(3,))
    keep("no-orbit", "play", "out/plan.json", "--orbit")
    keep("long-walk", "plan", "--robot", "a1", "--speed", "1", "--distance", "4", "--out", "long-plan.json")
    keep("orbit", "play", "long-plan.json", "--orbit")
    keep("plan", "plan", "--robot", "a1", "--sequence", "trot: distance=0.2; stand: duration=0.5", "--out", "plan-file.json")
    keep("margins", "audit", "out/plan.json", "--margins")
    keep("approach", "audit", "out/plan.json", "--start-posture", "measured.yaml", "--approach", "approach-plan.json", statuses=(0, 3))
    keep("trials", "trials", "out/plan.json", "-n", "4", "--out", "trials-file.json", "--report", "trials.html")
    keep("preflight", "audit", "out/plan.json", "--preflight", "--trials-result", "trials-file.json", statuses=(3,))
    keep("sweep", "sweep", "--speed", "0.5", "--distance", "0.2", "--over", "pipeline.com_height_m=0.25,0.6", "--trials", "2",
         "--best", "best.json")
    keep("tune", "tune", "--speed", "0.5", "--distance", "0.2", "--over", "swing.height_m=0.03:0.08", "--evaluations", "3", "--trials", "1",
         "--finalists", "1", "--held-out", "6", "--result", "tune-file.json")
    keep("compare", "compare", "out/plan.json", "out/log.json")
    keep("compare-reports", "compare", "walk.json", "play.json")
    keep("export", "export", "out/plan.json", "--format", "csv", "--out", "motion.csv")
    keep("import", "import", "motion.csv", "--robot", "a1", "--out", "imported.json")
    keep("repair", "repair", "motion.csv", "--robot", "a1", "--set", "lift_m=0.02", "--out", "repaired.json", "--report", "repair.html")
    keep("check", "repair", "motion.csv", "--robot", "a1", "--set", "lift_m=0.02", "--check", statuses=(3,))
    keep("do", "do", "stand up, then nod", "--robot", "a1", "--out-dir", "did", statuses=(0, 3))
    keep("tasks", "do", "walk two steps while waving", "--robot", "nao", "--tasks-only")
    student = folder / "submissions/ada"
    student.mkdir(parents=True)
    shutil.copy(ROOT / "examples/course/1-zmp/start/zmp.py", student)
    (folder / "zmp-rubric.yaml").write_text(block_named("zmp-rubric.yaml"))
    keep("grade", "grade", "submissions", "--rubric", "zmp-rubric.yaml", "--unconfined")
    keep("inputs", "grade", "--rubric", ROOT / "examples/course/1-zmp/rubric-cpp.yaml", "--write-inputs", "handout")
    keep("robots", "robots")
    keep("robot", "robots", "show", "nao", "--page", "nao.html")
    keep("gaits", "gaits")
    keep("terrains", "terrains")
    keep("terrain", "terrains", "show", "stairs", "--picture", "stairs.svg")
    keep("ground", "terrains", "show", "stairs", "--out", "stairs.png")
    (folder / "porch.yaml").write_text(block_named("porch.yaml"))
    keep("porch", "terrains", "show", "porch.yaml")
    keep("view", "view", "out/log.json", "--out", "view.html")
    keep("figure", "render", "out/log.json", "--figure", "gait.svg")
    keep("options", "walk", "--list-options")
    keep("schemas", "reference")
    keep("written", "reference", "--out-dir", "pages")
    keep("whole-body-bench", "bench", "whole-body", "--only", "a1-chain-200")
    keep("bench", "bench", "centroidal", "--only", "hyq-1-flat", "--timing", "fixed", "--audit", statuses=(0, 3))
    keep("error", "audit", "none.json", statuses=(1,))
    return folder


def block_named(name):
    return next(block.text for page in pages() for block in blocks_of(page) if block.named.get("file") == name)


@pytest.mark.parametrize("name, files", [
    ("motion-plan", ["out/plan.json", "plan-file.json", "approach-plan.json", "imported.json", "repaired.json", "did/plan.json", "best.json"]),
    ("playback-log", ["out/log.json", "played.json", "fell-log.json", "did/log.json"]),
    ("walk-result", ["walk.json", "play.json", "fell.json", "orbit.json", "no-orbit.json"]), ("do-result", ["do.json"]), ("plan-result", ["plan.json"]),
    ("audit-result", ["margins.json", "approach.json"]), ("preflight-result", ["preflight.json"]),
    ("trials-result", ["trials.json", "trials-file.json"]), ("sweep-result", ["sweep.json"]),
    ("tune-result", ["tune.json", "tune-file.json"]), ("compare-result", ["compare.json", "compare-reports.json"]),
    ("export-result", ["export.json"]), ("import-result", ["import.json"]), ("repair-result", ["repair.json", "check.json"]), ("task-plan", ["tasks.json"]),
    ("grade-result", ["grade.json", "inputs.json"]), ("robots-result", ["robots.json", "robot.json"]),
    ("gaits-result", ["gaits.json"]), ("terrains-result", ["terrains.json", "terrain.json", "ground.json", "porch.json"]),
    ("view-result", ["view.json"]), ("render-result", ["figure.json"]), ("bench-result", ["bench.json"]),
    ("whole-body-bench-result", ["whole-body-bench.json"]),
    ("option-list", ["options.json"]), ("reference-result", ["schemas.json", "written.json"]), ("error", ["error.json"]), ("options", ["tuned.yaml"])])
def test_what_is_written_fits_its_schema(made, name, files):
    for file in files:
        text = (made / file).read_text()
        assert faults(name, yaml.safe_load(text) if file.endswith("yaml") else json.loads(text)) == [], file


@pytest.mark.parametrize("name, path", [
    *(("robot-yaml", path) for path in [*(ROOT / "robots").glob("*/robot.yaml"), *(ROOT / "examples/motors").glob("*.yaml")]),
    *(("disturbances", path) for path in (ROOT / "examples/disturbances").glob("*.yaml")),
    *(("rubric", path) for path in (ROOT / "examples/course").glob("*/rubric*.yaml")),
    ("gaits", ROOT / "planning/gait/gaits.yaml")], ids=lambda value: str(value).removeprefix(f"{ROOT}/"))
def test_files_that_come_with_it_fit_their_schemas(name, path):
    assert faults(name, yaml.safe_load(path.read_text())) == []


@pytest.mark.parametrize("file", BLOCKS)
def test_files_of_the_handbook_fit_their_schemas(file):
    assert faults(BLOCKS[file], yaml.safe_load(block_named(file))) == []


def test_every_yaml_of_the_handbook_is_held_against_a_schema():
    files = {block.named["file"] for page in pages() for block in blocks_of(page) if block.language in ("yaml", "json")}
    assert files == set(BLOCKS)


def test_the_standard_disturbances_fit_their_schema(made):
    printed = gaitwright("trials", "out/plan.json", "--show-disturbances", folder=made).stdout
    assert faults("disturbances", yaml.safe_load(printed)) == []


# Schema, the file whose whole document is right, how it is broken, and the command that must refuse it.
BROKEN = [
    ("gaits", "mine.yaml", lambda d: d["mine"].update(feets=4), ["gaits", "FILE"]),
    ("gaits", "mine.yaml", lambda d: d["mine"].update(cycle_s=50), ["gaits", "FILE"]),
    ("gaits", "mine.yaml", lambda d: d["mine"].pop("phase"), ["gaits", "FILE"]),
    ("gaits", "mine.yaml", lambda d: d["mine"].update(cycle_per_leg_time=3), ["gaits", "FILE"]),
    ("sequence", "parts.yaml", lambda d: d[0].update(sped=1), ["plan", "--sequence", "FILE"]),
    ("sequence", "parts.yaml", lambda d: d[0].update(distance=-1), ["plan", "--sequence", "FILE"]),
    ("terrain", "porch.yaml", lambda d: d["patches"][0].update(frction=1), ["terrains", "show", "FILE"]),
    ("terrain", "porch.yaml", lambda d: d["patches"][0].update(friction=9), ["terrains", "show", "FILE"]),
    ("terrain", "porch.yaml", lambda d: d["obstacles"][0].pop("type"), ["terrains", "show", "FILE"]),
    ("disturbances", "hobby", lambda d: d.update(mass_scle=1), ["trials", "out/plan.json", "--show-disturbances", "--disturbances", "FILE"]),
    ("disturbances", "hobby", lambda d: d.update(mass_scale={"uniform": [0, 1]}), ["trials", "out/plan.json", "--show-disturbances", "--disturbances", "FILE"]),
    ("start-posture", "measured.yaml", lambda d: d.update(FL_hip_joint="left"), ["audit", "out/plan.json", "--start-posture", "FILE"]),
    ("footsteps", "steps.yaml", lambda d: d["footsteps"][0].update(foots=1), ["import", "FILE", "--robot", "a1"]),
    ("footsteps", "steps.yaml", lambda d: d["footsteps"][0].pop("x_m"), ["import", "FILE", "--robot", "a1"]),
    ("columns", "names.yaml", lambda d: d.update(colums={}), ["import", "motion.csv", "--robot", "a1", "--columns", "FILE"]),
    ("columns", "names.yaml", lambda d: d.update(angle_unit="gon"), ["import", "motion.csv", "--robot", "a1", "--columns", "FILE"]),
    ("robot-yaml", "goat/robot.yaml", lambda d: d.update(nominal_sped_m_s=1), ["robots", "show", "robot.urdf"]),
    ("robot-yaml", "goat/robot.yaml", lambda d: d.update(nominal_speed_m_s=0), ["robots", "show", "robot.urdf"]),
    ("robot-yaml", "goat/robot.yaml", lambda d: d["motors"]["Q1.3"].update(thermal_s=-1), ["robots", "show", "robot.urdf"]),
    ("options", "tuned.yaml", lambda d: d.update({"swing.hight_m": 0.1}), ["walk", "--options", "FILE"]),
    ("options", "tuned.yaml", lambda d: d.update({"swing.height_m": 100}), ["walk", "--options", "FILE"]),
    ("task-plan", "stones.json", lambda d: d["tasks"][0].update(step=2), ["do", "--task-plan", "FILE", "--tasks-only"]),
    ("rubric", "zmp-rubric.yaml", lambda d: d["parts"][0].update(tolerence=1), ["grade", "submissions", "--rubric", "FILE"]),
    ("rubric", "zmp-rubric.yaml", lambda d: d["parts"][0].update(cases=0), ["grade", "submissions", "--rubric", "FILE"]),
    ("rubric", "zmp-rubric.yaml", lambda d: d["parts"][0].update(reference="zmp"), ["grade", "submissions", "--rubric", "FILE"]),
    ("rubric", "zmp-rubric.yaml", lambda d: d["parts"][0]["limits"].update(time_s=0), ["grade", "submissions", "--rubric", "FILE"]),
    ("motion-plan", "out/plan.json", lambda d: d.update(colour=1), ["audit", "FILE"]),
    ("motion-plan", "out/plan.json", lambda d: d.pop("q"), ["audit", "FILE"]),
    ("motion-plan", "out/plan.json", lambda d: d["terrain"]["patches"][0].update(friction=-1), ["audit", "FILE"]),
    ("motion-plan", "out/plan.json", lambda d: d.update(schema=3), ["audit", "FILE"]),
    ("playback-log", "out/log.json", lambda d: d.update(colour=1), ["export", "FILE", "--plan", "out/plan.json", "--format", "csv"]),
    ("playback-log", "out/log.json", lambda d: d["stances"][0].pop("slip_m"), ["export", "FILE", "--plan", "out/plan.json", "--format", "csv"]),
]


def whole(made, name):
    if name == "hobby":
        return yaml.safe_load((ROOT / "examples/disturbances/a1_hobby.yaml").read_text())
    path = made / name
    if name.startswith("out/"):
        return json.loads(path.read_text())
    return yaml.safe_load(path.read_text() if path.exists() else block_named(name))


@functools.cache
def faults_of_whole(made, schema, name):
    """Looked for once a document, as plans and logs are long."""
    return faults(schema, whole(made, name))


@pytest.mark.parametrize("at", range(len(BROKEN)), ids=lambda at: f"{BROKEN[at][0]}-{at}")
def test_what_is_broken_is_refused_by_schema_and_program(made, tmp_path, at):
    schema, name, spoil, command = BROKEN[at]
    assert faults_of_whole(made, schema, name) == []
    broken = whole(made, name)
    spoil(broken)
    assert not validator(schema).is_valid(broken), "the schema takes it"
    for there in made.iterdir():
        (tmp_path / there.name).symlink_to(there)
    file = tmp_path / ("broken.json" if name.endswith("json") else "robot.yaml" if schema == "robot-yaml" else "broken.yaml")
    file.write_text(json.dumps(broken) if name.endswith("json") else yaml.safe_dump(broken, sort_keys=False))
    shutil.copy(ROOT / "examples/robots/goat.urdf", tmp_path / "robot.urdf")
    ran = gaitwright(*(file.name if word == "FILE" else word for word in command), folder=tmp_path, statuses=(1,))
    assert ran.stderr.startswith("gaitwright: ")
