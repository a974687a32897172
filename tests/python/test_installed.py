# SPDX-License-Identifier: BSD-3-Clause
"""The package as users get it: a wheel, and the files that `cmake --install` installs."""

import os
import re
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


PIP = [sys.executable, "-m", "pip", "-q", "--disable-pip-version-check"]


@pytest.fixture(scope="module")
def wheel(build, tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    source = folder / "source"  # a copy, since setuptools writes files beside the sources
    shutil.copytree(ROOT / "python", source / "python")
    for name in ("robots", "planning", "CMakeLists.txt"):
        (source / name).symlink_to(ROOT / name)
    run(*PIP, "wheel", "--no-index", "--no-build-isolation", "--no-deps", "-w", str(folder), str(source / "python"),
        cwd=folder, GAITWRIGHT_BUILD=build)
    return next(folder.glob("gaitwright-*.whl"))


@pytest.fixture(scope="module")
def site(wheel, tmp_path_factory):
    folder = tmp_path_factory.mktemp("installed") / "site"
    run(*PIP, "install", "--no-index", "--no-deps", "--no-compile", "--target", str(folder), str(wheel), cwd=folder.parent)
    return folder


def test_a_wheel_walks_from_anywhere(site, tmp_path):
    assert walk_from(site, tmp_path).startswith("True a1")
    data = site / "gaitwright" / "share" / "gaitwright"
    assert (data / "robots" / "nao" / "SOURCE.md").exists()
    shutil.copytree(data / "robots" / "a1", data / "robots" / "of_the_wheel")
    names = run(sys.executable, "-c", "import gaitwright; print(gaitwright.robot_names())", cwd=tmp_path,
                PYTHONPATH=str(site))
    assert "of_the_wheel" in names, "the wheel uses the robots of another folder"


OF_THE_SYSTEM = r"linux-vdso|ld-linux|lib(c|m|dl|rt|pthread|resolv|gcc_s|stdc\+\+)\.so"


def test_a_wheel_needs_no_library_of_the_machine(site, tmp_path):
    core = next((site / "gaitwright").glob("_core*.so"))
    loaded = [line.strip() for line in run("ldd", str(core), cwd=tmp_path).splitlines()]
    bundled = [line for line in loaded if "/gaitwright.libs/" in line]
    assert len(bundled) > 10
    assert [line for line in loaded if line not in bundled and not re.search(OF_THE_SYSTEM, line)] == []
    assert any((site / "gaitwright.libs" / "licences").iterdir())


def test_what_is_installed_walks(build, tmp_path):
    run("cmake", "--install", build, "--prefix", str(tmp_path / "prefix"), cwd=tmp_path)
    package = next((tmp_path / "prefix").glob("lib/python3*/*-packages/gaitwright"))
    assert walk_from(package.parent, tmp_path).startswith("True a1")
