# SPDX-License-Identifier: BSD-3-Clause
"""The type file has exactly the names and parameters of the module."""

import ast
import inspect
import re
import subprocess
import sys
from pathlib import Path

import gaitwright as gw
import pytest
from gaitwright import _core

TYPES = ast.parse(Path(_core.__file__).with_name("_core.pyi").read_text())
CLASSES = {node.name: node for node in TYPES.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in TYPES.body if isinstance(node, ast.FunctionDef)}


def public(names):
    return {name for name in names if not name.startswith("_")}


def names_in(body):
    named = {node.name for node in body if isinstance(node, ast.FunctionDef)}
    return named | {node.target.id for node in body if isinstance(node, ast.AnnAssign)}


def parameters_of(node):
    return [arg.arg for arg in node.args.args + node.args.kwonlyargs if arg.arg != "self"]


def parameters_at_runtime(function):
    """Parameters as pybind11 writes them into the first line of a docstring."""
    first = function.__doc__.splitlines()[0]
    return [name for name in re.findall(r"(\w+): ", first) if name != "self"]


def test_the_type_file_has_all_classes_and_functions():
    runtime = public(vars(_core)) - {"AUDIT_LAWS", "CONTROLLERS", "FAILURE_CODES"}
    assert runtime == public(CLASSES) | public(FUNCTIONS)


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_the_type_file_has_all_of_a_class(name):
    assert public(names_in(CLASSES[name].body)) == public(vars(getattr(_core, name)))


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_parameters_have_the_same_names(name):
    assert parameters_of(FUNCTIONS[name]) == parameters_at_runtime(getattr(_core, name))


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_methods_have_the_same_parameters(name):
    for node in CLASSES[name].body:
        method = inspect.getattr_static(getattr(_core, name), getattr(node, "name", ""), None)
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_") and not isinstance(method, property):
            assert parameters_of(node) == parameters_at_runtime(getattr(getattr(_core, name), node.name)), node.name


def test_everything_that_is_public_is_told_of():
    for name in gw.__all__:
        what = getattr(gw, name)
        if callable(what):
            assert inspect.getdoc(what), name


def test_the_package_fits_its_types():
    package = Path(gw.__file__).parent
    done = subprocess.run([sys.executable, "-m", "mypy", "--ignore-missing-imports", "--cache-dir=/dev/null", "-p", "gaitwright"],
                          cwd=package.parent, capture_output=True, text=True)
    if "No module named mypy" in done.stderr:
        pytest.skip("mypy is not installed")
    assert done.returncode == 0, done.stdout
