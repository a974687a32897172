# SPDX-License-Identifier: BSD-3-Clause
"""Makes a wheel: pip wheel ./python. CMake builds it. It contains robots, gaits and shared libraries.

GAITWRIGHT_BUILD names a build tree of CMake; its Python package is used instead of a new build.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python"))
from bundle_libraries import bundle  # noqa: E402


def version():
    return re.search(r"project\(gaitwright VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


class BuiltByCMake(build_ext):
    """The package as CMake builds it, with robots, gaits and shared libraries."""

    def build_extension(self, ext):
        tree = os.environ.get("GAITWRIGHT_BUILD")
        package = Path(tree or self.build_by_cmake()) / "python" / "gaitwright"
        core = next(package.glob("_core*.so"), None)
        if core is None:
            raise SystemExit(f"there is no Python package in {package}; GAITWRIGHT_BUILD names a tree without one")
        target = Path(self.get_ext_fullpath(ext.name)).parent
        shutil.copytree(package, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
        data = target / "share" / "gaitwright"  # where the core looks first
        shutil.copytree(ROOT / "robots", data / "robots", dirs_exist_ok=True)
        shutil.copy(ROOT / "planning" / "gait" / "gaits.yaml", data / "gaits.yaml")
        libraries = target.parent / "gaitwright.libs"
        shutil.rmtree(libraries, ignore_errors=True)
        bundle(libraries, [target / core.name])

    def build_by_cmake(self):
        tree = Path(self.build_temp).resolve()
        subprocess.run(
            ["cmake", "-S", ROOT, "-B", tree, "-DCMAKE_BUILD_TYPE=Release", "-DGAITWRIGHT_PYTHON=ON",
             "-DGAITWRIGHT_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", tree, "--target", "python_core", "--parallel"], check=True)
        return tree


def platform():
    """Platform tag for systems with this machine's glibc or a newer one; pip reads it from the name of the wheel."""
    major, minor = os.confstr("CS_GNU_LIBC_VERSION").split()[1].split(".")[:2]
    return f"manylinux_{major}_{minor}_{os.uname().machine}"


setup(
    version=version(),
    packages=[],
    ext_modules=[Extension("gaitwright._core", sources=[])],
    cmdclass={"build_ext": BuiltByCMake},
    options={"bdist_wheel": {"plat_name": platform()}},
)
