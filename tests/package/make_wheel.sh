#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# make_wheel.sh BUILD OUT PYTHON: makes the wheel of the build tree BUILD in OUT.
set -euo pipefail
build=$1 out=$2 python=$3
root=$(cd "$(dirname "$0")/../.." && pwd)
source=$out/source # a copy: setuptools writes beside its source
rm -rf "$source" "$out"/*.whl
mkdir -p "$source"
cp -r "$root/python" "$source/"
ln -s "$root/robots" "$root/planning" "$root/CMakeLists.txt" "$source/"
GAITWRIGHT_BUILD=$build "$python" -m pip -q --disable-pip-version-check wheel --no-index --no-build-isolation --no-deps \
  -w "$out" "$source/python"
rm -rf "$source"
ls -l "$out"
