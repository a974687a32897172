#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that no test defines a function that a library of the project defines too.

A function of a test's header is `inline`, hence the linker drops it without a word for a library's function of the same
name and parameters, and the tests then run with that one. Which of the two is linked depends on the order of archives.

    one_definition.py LIBRARY... -- TEST_PROGRAM_FOLDER...
"""

import pathlib
import subprocess
import sys


def definitions(files, kinds):
    """(file, mangled name) of what objects or archives define with one of nm's letters."""
    printed = subprocess.run(["nm", "--defined-only", "--format=posix", "--print-file-name", *files],
                             check=True, capture_output=True, text=True).stdout
    for line in printed.splitlines():
        file, row = line.split(": ", 1)
        name, kind = row.split()[:2]
        if kind in kinds:
            yield file, name


def shared_definitions(libraries, objects):
    """(object, name) of each definition of an object that a library has too, not inline."""
    strong = {name for _, name in definitions(libraries, "TDBR")}
    return sorted((file, name) for file, name in definitions(objects, "TDBRWV") if name in strong)


def demangled(name):
    return subprocess.run(["c++filt", name], check=True, capture_output=True, text=True).stdout.strip()


def main(arguments):
    border = arguments.index("--")
    libraries, folders = arguments[:border], arguments[border + 1:]
    objects = sorted(str(file) for folder in folders for file in pathlib.Path(folder).rglob("*.o"))
    if not libraries or not objects:
        sys.exit("expected libraries and folders with objects")
    found = shared_definitions(libraries, objects)
    for file, name in found:
        print(f"{file} defines {demangled(name)}, as a library does")
    print(f"{len(objects)} objects of tests, {len(found)} definitions that a library has too")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
