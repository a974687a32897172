# SPDX-License-Identifier: BSD-3-Clause
"""Runs a submission's Python: reads requests from file 3, one JSON text per line, and writes the answers to file 4.

It runs in the same process as the submission, so it is not trusted either: it has only inputs, and the program checks
its answers.
"""

import importlib.util
import json
import math
import os
import sys
import traceback


def told(error):
    """An exception in one line: its type, its message and its place in the submission."""
    places = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename.startswith(state["code"])]
    name = type(error).__name__
    where = f" ({os.path.basename(places[-1].filename)} line {places[-1].lineno})" if places else ""
    if isinstance(error, SyntaxError) and error.lineno:
        where = f" ({os.path.basename(str(error.filename))} line {error.lineno})"
        return f"{name}: {error.msg}{where}"
    return f"{name}: {error}{where}"[:1000]


def plain(value, depth=0):
    """Converts arrays and numbers to lists of numbers; a value that is not a finite number becomes a text."""
    if depth > 3:
        raise ValueError("the answer has more than three lists inside each other")
    if hasattr(value, "tolist"):
        value = value.tolist()
    if type(value) is list and set(map(type, value)) == {float} and all(map(math.isfinite, value)):
        return value
    if isinstance(value, bool) or value is None:
        return str(value)
    if isinstance(value, (int, float)):
        return float(value) if math.isfinite(value) else str(float(value))
    if isinstance(value, str):
        return value[:100]
    if isinstance(value, complex):
        return "a complex number"
    return [plain(item, depth + 1) for item in value]


def argument(value):
    """Converts a list of numbers to an array; numbers and words stay as they are."""
    if isinstance(value, list):
        import numpy

        return numpy.array(value, dtype=float)
    return value


class Package:
    """Finds the package in its own folder, because the folder above cannot be listed."""

    def __init__(self, folder):
        self.folder = folder

    def find_spec(self, name, path=None, target=None):
        if name != "gaitwright":
            return None
        start = os.path.join(self.folder, "__init__.py")
        return importlib.util.spec_from_file_location(name, start, submodule_search_locations=[self.folder])


def load(request):
    """Imports the submission's file and finds the required function."""
    state["code"] = request["code"]
    sys.path[:] = [request["code"]] + sys.path[1:]
    if request["package"]:
        sys.meta_path.insert(0, Package(os.path.join(request["package"], "gaitwright")))
    spec = importlib.util.spec_from_file_location("submission", os.path.join(request["code"], request["file"]))
    module = importlib.util.module_from_spec(spec)
    sys.modules["submission"] = module
    spec.loader.exec_module(module)
    if not hasattr(module, request["function"]):
        raise NameError(f"'{request['file']}' has no '{request['function']}'")
    state["function"] = getattr(module, request["function"])


def steps(request):
    """A footstep planner's steps: feet by name, places as numbers."""
    import gaitwright

    robot = gaitwright.load_robot(request["robot"])
    terrain = gaitwright.load_terrain(request["terrain"], robot)
    found = []
    for foot, x, y, yaw in state["function"](robot, terrain, tuple(request["goal"])):
        found.append([str(foot)[:100], plain(x), plain(y), plain(yaw)])
        if len(found) > request["most"]:
            raise ValueError(f"the planner gave more than {request['most']} steps")
    return found


def make_controller(request):
    """A controller for the plan in a file."""
    import gaitwright

    state["controller"] = state["function"](gaitwright.load_plan(request["plan"]))
    if not hasattr(state["controller"], "update"):
        raise TypeError(f"'{state['function'].__name__}' did not return a controller: the object has no 'update'")
    if hasattr(state["controller"], "reset"):
        state["controller"].reset()
    return []


def update(values):
    """One step of the controller: targets, feed-forward and gains of the joints."""
    import gaitwright

    command = state["controller"].update(gaitwright.ControlInput(*values))
    return [plain(part) for part in (command.q, command.v, command.tau_ff, command.stiffness, command.damping)]


def answer(request):
    if "load" in request:
        return load(request["load"])
    if "call" in request:
        return plain(state["function"](*(argument(value) for value in request["call"])))
    if "update" in request:
        return update(request["update"])
    if "plan" in request:
        return make_controller(request)
    return steps(request)


state = {"code": "/"}
requests = os.fdopen(3, "r", encoding="utf-8", errors="replace")
answers = os.fdopen(4, "w", encoding="utf-8", errors="backslashreplace")
for line in requests:
    try:
        reply = {"answer": answer(json.loads(line))}
    except Exception as error:
        reply = {"error": told(error)}
    answers.write(json.dumps(reply) + "\n")
    answers.flush()
