# SPDX-License-Identifier: BSD-3-Clause
"""The package as others get it: a wheel, and what `cmake --install` puts down."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
WALK = (
    "import gaitwright as gw, sys;"
    "assert gw.__file__.startswith(sys.argv[1]), gw.__file__;"
    "robot = gw.load_robot('a1');"
    "print(gw.play(gw.plan_walk(robot, gait='trot', speed=0.3, distance=0.3)).passed, sorted(gw.robot_names())[0])"
)


def run(*command, cwd, **environment):
    done = subprocess.run(command, cwd=cwd, env={**os.environ, **environment}, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def walk_from(folder, cwd):
    return run(sys.executable, "-c", WALK, str(folder), cwd=cwd, PYTHONPATH=str(folder))


@pytest.fixture(scope="module")
def build():
    tree = os.environ.get("GAITWRIGHT_BUILD")
    if not tree:
        pytest.skip("GAITWRIGHT_BUILD does not name a build tree")
    return tree


def test_a_wheel_walks_from_anywhere(build, tmp_path):
    pip = [sys.executable, "-m", "pip", "-q", "--disable-pip-version-check"]
    source = tmp_path / "source"  # a copy, since setuptools writes beside it
    shutil.copytree(ROOT / "python", source / "python")
    for name in ("robots", "planning", "CMakeLists.txt"):
        (source / name).symlink_to(ROOT / name)
    run(*pip, "wheel", "--no-build-isolation", "--no-deps", "-w", str(tmp_path), str(source / "python"), cwd=tmp_path,
        GAITWRIGHT_BUILD=build)
    wheel = next(tmp_path.glob("gaitwright-*.whl"))
    run(*pip, "install", "--no-deps", "--target", str(tmp_path / "site"), str(wheel), cwd=tmp_path)
    assert walk_from(tmp_path / "site", tmp_path).startswith("True a1")
    assert (tmp_path / "site" / "gaitwright" / "data" / "robots" / "nao" / "SOURCE.md").exists()


def test_what_is_installed_walks(build, tmp_path):
    run("cmake", "--install", build, "--prefix", str(tmp_path / "prefix"), cwd=tmp_path)
    package = next((tmp_path / "prefix").glob("lib/python3*/*-packages/gaitwright"))
    assert walk_from(package.parent, tmp_path).startswith("True a1")
