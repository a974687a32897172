#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# make_packages.sh BUILD OUT CPACK: makes the Debian package and the archive of the build tree BUILD in OUT. The Debian package
# is not compressed: nothing here is about how small it is.
set -euo pipefail
build=$1 out=$2 cpack=$3
rm -rf "$out"
mkdir -p "$out"
(cd "$build" && "$cpack" -G 'DEB;TGZ' -D CPACK_DEBIAN_COMPRESSION_TYPE=none -B "$out")
rm -rf "$out/_CPack_Packages"
ls -l "$out"
